// Plays the actions of an earlier answer's trajectory, tick by tick. Host only.
#pragma once

#include "solve/model/problem.h"
#include "solve/search/rollouts/rollout.h"

namespace obby::solve {

constexpr uint32_t kBeyondKnown = 60;  // extra ticks of the last action, in case the goal has moved

inline uint32_t ticksOf(const ActionRuns& runs) {
  uint32_t ticks = runs.empty() ? 0 : kBeyondKnown;
  for (const sim::ActionRun& run : runs) ticks += run.ticks;
  return ticks;
}

inline bool sameKeys(const sim::Action& a, const sim::Action& b) {
  return a.heading == b.heading && a.walk == b.walk && a.jump == b.jump;
}

// Appends one tick of `action`.
inline void hold(ActionRuns& runs, const sim::Action& action) {
  if (runs.empty() || !sameKeys(runs.back().action, action)) runs.push_back({action, 0});
  runs.back().ticks++;
}

// Returns the actions of a trajectory tick by tick, and repeats the last one forever.
class RunCursor {
 public:
  sim::Action next(const ActionRuns& runs) {
    while (run_ + 1 < runs.size() && held_ >= runs[run_].ticks) {
      ++run_;
      held_ = 0;
    }
    ++held_;
    return runs[run_].action;
  }

 private:
  size_t run_ = 0;
  uint32_t held_ = 0;  // ticks
};

// Like runRollout(), with the actions of `runs`. `ticks` is at most ticksOf(runs).
template <class Visit>
uint32_t playRuns(const ExploreContext& c, const ActionRuns& runs, sim::World& world,
                  sim::RigidBody* bodies, uint32_t ticks, Visit&& visit) {
  RunCursor cursor;
  const auto next = [&](const sim::World&) { return cursor.next(runs); };
  return runTicks<true, true>(c, world, bodies, ticks, next, visit);
}

}  // namespace obby::solve
