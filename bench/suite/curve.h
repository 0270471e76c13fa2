// The suite's results as a picture.
#pragma once

#include <string>

#include "suite/summary.h"

namespace obby::bench {

// Returns an SVG with one plot, or with two if `ge` is among the methods:
// - For each method, the share of solved runs of solvable queries over the seconds, with its 95 %
//   band. The time axis is logarithmic and ends at the cap.
// - The paper's figure: mean seconds to the first solution, with quartiles, for the thirds by the
//   time of `ge`. A run without a solution counts as the cap. `measures`: those of `results`.
std::string suiteSvg(const Results& results, const std::vector<Measure>& measures);

}  // namespace obby::bench
