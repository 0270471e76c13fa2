// Answers one query for one player: compiles it, searches, checks every solution with the verifier,
// and writes the answer as records. Progress comes first, then the trajectories, then the result.
#pragma once

#include "solve/answer/solver_options.h"

namespace obby::solve {

Result<QueryAnswer> solveFor(const PlayerQuestion& question, const SolverOptions& options,
                             const Machine& machine, const SolverOutput& output);

}  // namespace obby::solve
