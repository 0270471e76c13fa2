// Chooses the dimensions of a problem's cells.
#pragma once

#include "solve/model/problem.h"
#include "solve/search/archive/cell.h"
#include "solve/search/archive/clock_map.h"

namespace obby::solve {

// `width`: studs at the usual speed of 16 studs/s; a faster player gets cells up to twice as wide.
// `clock` must outlive the binning.
Binning makeBinning(const Problem& problem, float width, const ClockMap& clock);

}  // namespace obby::solve
