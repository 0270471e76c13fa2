// One rollout: random exploration from a state under the query's rules. Searching and replaying a
// rollout run this same function, so that they cannot differ.
#pragma once

#include "sim/rules.h"
#include "sim/tick.h"
#include "solve/search/rollouts/explorer.h"

namespace obby::solve {

// Advances `world` and its loose bodies by at most `ticks` ticks, fewer if the playthrough ends or
// is doomed; gives the ticks done. next(world) is the action of each, visit(action, world) is
// called after it.
template <bool kLoose, bool kToTheEnd, class Next, class Visit>
OBBY_DEVICE uint32_t runTicks(const ExploreContext& c, sim::World& world, sim::LooseBody* loose,
                              uint32_t ticks, Next&& next, Visit&& visit) {
  for (uint32_t t = 1; t <= ticks; ++t) {
    const sim::Action action = next(world);
    const sim::Before before = sim::beforeOf(world);
    sim::tick<kLoose>(world, loose, c.level, action);
    sim::applyRules(world, before, loose, c.level, c.query);
    visit(action, world);
    if (world.outcome != sim::Outcome::running) return t;
    if (!kToTheEnd && doomed(c, world)) return t;
  }
  return ticks;
}

// The same with the random actions of a rollout. kToTheEnd: also while there is no hope left, for
// those who want to see it end.
template <bool kLoose = true, bool kToTheEnd = false, class Visit>
OBBY_DEVICE uint32_t runRollout(const ExploreContext& c, uint64_t seed, uint64_t rollout,
                                sim::World& world, sim::LooseBody* loose, uint32_t ticks,
                                Visit&& visit) {
  Explorer explorer(seed, rollout);
  const auto next = [&](const sim::World& w) { return explorer.next(c, w, loose); };
  return runTicks<kLoose, kToTheEnd>(c, world, loose, ticks, next, visit);
}

}  // namespace obby::solve
