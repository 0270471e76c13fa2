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
  // Methods at a query may be of different kinds of machine: what is told of them then holds only
  // where they are far apart.
  bool anyMachine = false;

  // Is the method asked this query with this seed? A query without a solution costs its whole cap
  // whatever the method, so only the first method is asked, and once.
  bool asks(size_t method, size_t query, uint64_t seed) const;
  double capOf(const SuiteQuery& query) const;

  // One query with one seed to each method that is asked.
  std::vector<Question> questionsAt(size_t query, uint64_t seed) const;
  // Query by query within a seed, so that what an interruption leaves is balanced.
  std::vector<Question> questions() const;
};

// The kind of machine that has come farthest with a query and a seed. All methods at them are to be
// of one kind, for times compare only within it.
Made machineOf(const std::vector<Question>& questions, const RunLog& log, const Maker& maker);

// The planned runs that the log has, at each query and seed of the kind of machine that has made
// most of them, unless any machine counts; `program` 0: of whatever program.
Results resultsOf(const Plan& plan, const RunLog& log, const Maker& maker);

}  // namespace obby::bench
