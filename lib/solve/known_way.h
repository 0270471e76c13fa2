// Plays a way of an earlier answer: its actions, tick by tick. Host only.
#pragma once

#include "solve/problem.h"
#include "solve/rollout.h"

namespace obby::solve {

constexpr uint32_t kBeyondKnown =
    60;  // ticks that the last action is held on: a goal may have moved

inline uint32_t ticksOf(const KnownWay& way) {
  uint32_t ticks = way.empty() ? 0 : kBeyondKnown;
  for (const sim::ActionRun& run : way) ticks += run.ticks;
  return ticks;
}

// As runRollout, with the actions of `way`; `ticks` at most ticksOf(way).
template <class Visit>
uint32_t runKnown(const ExploreContext& c, const KnownWay& way, sim::World& world,
                  sim::LooseBody* loose, uint32_t ticks, Visit&& visit) {
  size_t run = 0;
  uint32_t held = 0;
  const auto next = [&](const sim::World&) {
    while (run + 1 < way.size() && held >= way[run].ticks) {
      ++run;
      held = 0;
    }
    ++held;
    return way[run].action;
  };
  return runTicks<true, true>(c, world, loose, ticks, next, visit);
}

}  // namespace obby::solve
