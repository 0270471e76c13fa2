// What a call of the bench is to run: methods x queries x seeds, each within its cap.
#pragma once

#include <string>
#include <vector>

#include "suite/ask.h"
#include "suite/suite.h"
#include "suite/summary.h"

namespace obby::bench {

struct Plan {
  std::vector<const solve::Method*> methods;
  std::vector<SuiteQuery> suite;
  uint64_t seeds = 5;
  double cap = 90;            // seconds, of queries that have a solution
  double unsolvableCap = 10;  // of the others
  bool sampled = false;       // methods after the first run every third solvable query only

  // Is the method asked this query with this seed? A query without a solution costs its whole cap
  // whatever the method, so only the first method is asked, and once.
  bool asks(size_t method, size_t query, uint64_t seed) const;
  double capOf(const SuiteQuery& query) const;

  // Query by query within a seed, so that what an interruption leaves is balanced.
  std::vector<Question> questions() const;
};

// The planned runs that the log has; `program` 0: of whatever program.
Results resultsOf(const Plan& plan, const RunLog& log, const Maker& maker);

}  // namespace obby::bench
