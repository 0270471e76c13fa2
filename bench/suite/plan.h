// The runs of one call of the bench: methods x queries x seeds, each with a cap.
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
  double cap = 90;            // seconds, for solvable queries
  double unsolvableCap = 10;  // seconds, for unsolvable queries
  bool sampled = false;       // methods after the first run only every third solvable query
  // If true, the methods' runs of a query may come from different kinds of machine, and only large
  // differences are meaningful.
  bool anyMachine = false;

  // Returns true if the method answers this query with this seed. An unsolvable query always takes
  // its whole cap, so only the first method answers it, and only once.
  bool asks(size_t method, size_t query, uint64_t seed) const;
  double capOf(const SuiteQuery& query) const;

  // Returns one query with one seed for each method that answers it.
  std::vector<Trial> trialsAt(size_t query, uint64_t seed) const;
  // Returns all trials, query by query within a seed, so that an interrupted series is balanced.
  std::vector<Trial> trials() const;
};

// Returns the kind of machine with the most runs of a query and a seed. All methods must use one
// kind, because times are comparable only within it.
Made machineOf(const std::vector<Trial>& trials, const RunLog& log, const Maker& maker);

// Returns the planned runs in the log. For each query and seed they come from the kind of machine
// with the most runs, unless any machine counts. `program` 0 stands for any program.
Results resultsOf(const Plan& plan, const RunLog& log, const Maker& maker);

}  // namespace obby::bench
