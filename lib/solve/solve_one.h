// Answers a query for one player: searches, checks every solution with the verifier, and writes the
// answer as records: progress while it works, then trajectories, then the result.
#pragma once

#include "solve/solver_options.h"

namespace obby::solve {

Result<QueryAnswer> solveFor(const PlayerQuestion& question, const SolverOptions& options,
                             const Machine& machine, const SolverOutput& output);

}  // namespace obby::solve
