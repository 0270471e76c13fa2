// What the suite shows, as a picture.
#pragma once

#include <string>

#include "suite/summary.h"

namespace obby::bench {

// An SVG of one plot, or of two where `ge` is among the methods:
// - for each method the share of the runs of solvable queries that were solved, against the seconds
//   on a logarithmic axis up to the cap, with its 95 % band;
// - the paper's figure: mean seconds to the first solution, with quartiles, of the thirds by the
//   time of `ge`; a run without a solution took the cap. `measures`: of these results.
std::string suiteSvg(const Results& results, const std::vector<Measure>& measures);

}  // namespace obby::bench
