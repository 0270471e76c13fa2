// Solves a query of the suite and measures its solution.
#pragma once

#include <optional>

#include "base/thread_pool.h"
#include "solve/improve/preference.h"
#include "suite/suite.h"

namespace obby::bench {

struct Quality {
  double ticks = 0, jumps = 0;
  double turnsBack = 0;  // times that the direction turns by more than 100 degrees within 0.4 s
  double changes = 0;    // runs of the same keys
  double length = 0;     // studs
  double firstSeconds = 0, finalSeconds = 0;  // wall-clock time to the first and final solution
  uint64_t steps = 0;                         // simulated ticks of the search and the improvement
};

// Returns all but the times and steps. The trajectory must have a path.
Quality qualityOf(schema::Trajectory::Reader trajectory);

// Returns nothing if no solution is found within 5 million steps. `preference` is null for the
// first solution.
std::optional<Quality> measure(const SuiteQuery& query, const solve::Preference* preference,
                               double seconds, ThreadPool& pool);

}  // namespace obby::bench
