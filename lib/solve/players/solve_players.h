// Answers a query for each of the players that it names, and combines the answers into one result.
#pragma once

#include "solve/answer/solver_options.h"

namespace obby::solve {

Result<QueryAnswer> solveForPlayers(const LoadedLevel& level, schema::Query::Reader query,
                                    const SolverOptions& options, const Machine& machine,
                                    const SolverOutput& output);

}  // namespace obby::solve
