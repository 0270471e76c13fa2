// Searches for solutions that avoid the parts about which the importer has doubts.
#pragma once

#include "solve/answer/solver_options.h"
#include "solve/report/doubts.h"

namespace obby::solve {

// A query that a search has solved.
struct SolvedQuery {
  const LoadedLevel& level;
  schema::Query::Reader query;
  const Problem& problem;
  const std::vector<uint32_t>& doubtful;  // doubtfulParts() of the level
  const SolverOptions& options;
  const Watcher& watcher;  // watches the search for other solutions, in `level`
};

// Searches for solutions that touch none of the doubtful parts. If it finds any, they replace the
// others. Parts on which the player starts and parts that the query names are exempt. The search is
// limited to 500,000 steps or eight times those of the first one, whichever is more, and to the
// query's budget. `touched`, in and out: doubtful parts that the first solution touches. Error:
// the level with deadly parts is invalid, which is not expected.
Result<Avoiding> avoidDoubts(const SolvedQuery& solved, const Machine& machine,
                             const Course& course, std::vector<uint32_t>& touched,
                             SearchOutcome& outcome);

}  // namespace obby::solve
