// Solutions that do without the parts of which the import is not sure.
#pragma once

#include "solve/report/doubts.h"
#include "solve/solver_options.h"

namespace obby::solve {

// A query that a search has solved.
struct SolvedQuery {
  const LoadedLevel& level;
  schema::Query::Reader query;
  const Problem& problem;
  const std::vector<uint32_t>& doubtful;  // doubtfulParts() of the level
  const SolverOptions& options;
  const Watcher& watcher;  // of the search for other solutions, in `level`
};

// Searches for solutions that touch none of the doubtful parts, but for those on which the player
// starts and those that the query names, and puts them in place of the others. It does up to eight
// times the steps of the first search, within the query's budget. `touched`: doubtful parts of the
// shortest solution, before and after. Error: of the level with those parts deadly; none is
// expected.
Result<Avoiding> avoidDoubts(const SolvedQuery& solved, const Machine& machine,
                             const Course& course, std::vector<uint32_t>& touched,
                             SearchOutcome& outcome);

}  // namespace obby::solve
