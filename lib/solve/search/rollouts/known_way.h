// Plays a trajectory of an earlier answer: its actions, tick by tick. Host only.
#pragma once

#include "solve/model/problem.h"
#include "solve/search/rollouts/rollout.h"

namespace obby::solve {

constexpr uint32_t kBeyondKnown = 60;  // ticks that the last action is held; a goal may have moved

inline uint32_t ticksOf(const KnownWay& way) {
  uint32_t ticks = way.empty() ? 0 : kBeyondKnown;
  for (const sim::ActionRun& run : way) ticks += run.ticks;
  return ticks;
}

// Appends one tick of `action`.
inline void hold(KnownWay& way, const sim::Action& action) {
  const auto same = [&](const sim::Action& a) {
    return a.heading == action.heading && a.walk == action.walk && a.jump == action.jump;
  };
  if (way.empty() || !same(way.back().action)) way.push_back({action, 0});
  way.back().ticks++;
}

// Returns the actions of a trajectory tick by tick, the last one without end.
class WayCursor {
 public:
  sim::Action next(const KnownWay& way) {
    while (run_ + 1 < way.size() && held_ >= way[run_].ticks) {
      ++run_;
      held_ = 0;
    }
    ++held_;
    return way[run_].action;
  }

 private:
  size_t run_ = 0;
  uint32_t held_ = 0;  // ticks
};

// Like runRollout(), with the actions of `way`. `ticks` is at most ticksOf(way).
template <class Visit>
uint32_t runKnown(const ExploreContext& c, const KnownWay& way, sim::World& world,
                  sim::LooseBody* loose, uint32_t ticks, Visit&& visit) {
  WayCursor cursor;
  const auto next = [&](const sim::World&) { return cursor.next(way); };
  return runTicks<true, true>(c, world, loose, ticks, next, visit);
}

}  // namespace obby::solve
