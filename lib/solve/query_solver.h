// Answers one query for each of its players.
#pragma once

#include "solve/answer/solver_options.h"

namespace obby::solve {

// Answers for every player that the query names, or for the level's own. An error is about the
// query record (path is set), or comes from `write`.
Result<QueryAnswer> solveQuery(const LoadedLevel& level, schema::Query::Reader query,
                               const SolverOptions& options, const Machine& machine,
                               const SolverOutput& output);

}  // namespace obby::solve
