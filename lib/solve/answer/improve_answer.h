// Improves the solutions of an answer by the preference of the options.
#pragma once

#include <functional>

#include "solve/answer/solver_options.h"

namespace obby::solve {

// All that it refers to must outlive it.
struct AnswerToImprove {
  const Problem& problem;
  const SolverOptions& options;
  const Machine& machine;
  std::function<bool(const Trajectory&)> accept;  // true for a solution that may be reported
  std::function<bool()> stop;                     // true to end early
};

// Replaces the solutions of `outcome` by better ones, the best first. Several solutions stay
// distinct, and each keeps its route. Adds the steps and seconds to the outcome's.
void improveAnswer(const AnswerToImprove& answer, SearchOutcome& outcome);

}  // namespace obby::solve
