// Plans a query of the suite with OMPL's SST and measures its solutions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quality/measure.h"
#include "quality/ompl_planner.h"
#include "suite/suite.h"

namespace obby::bench {

// Returns the quality of the best solution after each budget of simulated ticks, or nothing where
// there is none yet. Budgets ascend. One run serves all of them.
std::vector<std::optional<Quality>> measureSst(const SuiteQuery& query,
                                               std::span<const uint64_t> budgets,
                                               const SstSettings& settings);

}  // namespace obby::bench
