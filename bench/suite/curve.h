// The success-against-time curve as a picture.
#pragma once

#include <string>

#include "suite/summary.h"

namespace obby::bench {

// An SVG: for each method the share of the runs of solvable queries that were solved, against the
// seconds on a logarithmic axis up to the cap, with its 95 % band.
std::string curveSvg(const Results& results);

}  // namespace obby::bench
