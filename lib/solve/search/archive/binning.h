// Chooses the dimensions of a problem's cells.
#pragma once

#include "solve/model/problem.h"
#include "solve/search/archive/cell.h"
#include "solve/search/archive/clock_map.h"

namespace obby::solve {

// `width` in studs at the usual 16 studs/s: a faster player gets wider cells, up to twice. `clock`
// must outlive the binning.
Binning makeBinning(const Problem& problem, float width, const ClockMap& clock);

}  // namespace obby::solve
