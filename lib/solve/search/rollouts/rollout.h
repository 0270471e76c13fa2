// One rollout: random exploration from a state under the query's rules. Searching and replaying a
// rollout run this same function, so they cannot differ.
#pragma once

#include "sim/rules.h"
#include "sim/tick.h"
#include "solve/search/rollouts/explorer.h"

namespace obby::solve {

// Advances `world` and its bodies by at most `ticks` ticks, fewer if the attempt ends or is doomed.
// Returns the ticks done. next(world) returns the action of each tick, and visit(action, world) is
// called after it.
template <bool kDynamic, bool kToTheEnd, class Next, class Visit>
OBBY_DEVICE uint32_t runTicks(const ExploreContext& c, sim::World& world, sim::RigidBody* bodies,
                              uint32_t ticks, Next&& next, Visit&& visit) {
  for (uint32_t t = 1; t <= ticks; ++t) {
    const sim::Action action = next(world);
    const sim::Before before = sim::beforeOf(world);
    sim::tick<kDynamic>(world, bodies, c.level, action);
    sim::applyRules(world, before, bodies, c.level, c.query);
    visit(action, world);
    if (world.outcome != sim::Outcome::running) return t;
    if (!kToTheEnd && doomed(c, world)) return t;
  }
  return ticks;
}

// Does the same with the actions of a rollout. kToTheEnd: plays a doomed attempt to its end, too.
template <bool kDynamic = true, bool kToTheEnd = false, class Visit>
OBBY_DEVICE uint32_t runRollout(const ExploreContext& c, uint64_t seed, uint64_t rollout,
                                sim::World& world, sim::RigidBody* bodies, uint32_t ticks,
                                Visit&& visit) {
  Explorer explorer(seed, rollout);
  const auto next = [&](const sim::World& w) { return explorer.next(c, w, bodies); };
  return runTicks<kDynamic, kToTheEnd>(c, world, bodies, ticks, next, visit);
}

}  // namespace obby::solve
