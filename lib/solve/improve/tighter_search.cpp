#include "solve/improve/tighter_search.h"

#include <algorithm>

namespace obby::solve {

namespace {

Problem tighter(const Problem& problem, const TighterLimits& limits) {
  Problem tight = problem;
  tight.known.clear();
  level::QueryView& q = tight.query;
  if (limits.jumps >= 0)
    q.maxJumps = q.maxJumps < 0 ? limits.jumps : std::min(q.maxJumps, limits.jumps);
  if (limits.ticks >= 0) {
    const auto ticks = uint32_t(std::max<int64_t>(limits.ticks, 1));
    q.timeLimitTicks = q.timeLimitTicks == 0 ? ticks : std::min(q.timeLimitTicks, ticks);
  }
  return tight;
}

}  // namespace

std::vector<Trajectory> TighterSearch::run(const TighterLimits& limits, uint64_t maxSteps,
                                           uint64_t seed,
                                           const std::function<bool(const Trajectory&)>& accept) {
  Budget budget;
  budget.seed = seed;
  budget.maxSteps = maxSteps;
  budget.solutions = kTaken;
  budget.attempts = 0;
  const Watcher watcher{accept, [this](const SearchView&) { return !stop_ || !stop_(); }};
  SearchOutcome outcome = method_.run(tighter(problem_, limits), budget, watcher, machine_);
  steps_ += outcome.statistics.steps;
  return std::move(outcome.solutions);
}

}  // namespace obby::solve
