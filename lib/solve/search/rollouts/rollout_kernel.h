// The kernel of a search: one rollout per thread, with the search's notes on it. cuda/rollout.cu
// launches it on a GPU. The archive stays on the host, which takes the visits in rollout order.
#pragma once

#include "solve/search/rollouts/rollout.h"
#include "solve/search/rollouts/trail.h"

namespace obby::solve {

struct RolloutStart {
  sim::World world;
  uint64_t id;     // its stream of random numbers
  uint32_t ticks;  // max length
};

// A state whose cell is not that of the rollout's last kept state.
struct RolloutVisit {
  sim::World world;
  uint64_t key;
  uint32_t ticks;  // ticks into the rollout
};

struct RolloutEnd {
  sim::World world;
  Approach closest;
  uint32_t closestTicks, ticks, visits;
};

// The data that all rollouts of a search read.
struct RolloutRules {
  ExploreContext context;
  Binning binning;
  KeepRule rule;
  uint64_t seed;
  uint32_t ticks;  // max length of a rollout
};

template <class Table>
OBBY_DEVICE void forTables(RolloutRules& r, Table&& table) {
  forTables(r.context, table);
  forTables(r.binning.clock, table);
}

// Returns the max number of visits of a rollout.
OBBY_DEVICE uint32_t visitCapacity(const RolloutRules& r) { return r.ticks / r.rule.lookEvery; }

struct RolloutArguments {
  RolloutRules rules;
  uint32_t capacity;            // max visits of a rollout
  const RolloutStart* starts;   // (rollouts)
  RolloutVisit* visits;         // (rollouts, capacity)
  sim::RigidBody* bodies;       // (rollouts, level.bodyCount); in: at the start, out: at the end
  sim::RigidBody* visitBodies;  // (rollouts, capacity, level.bodyCount)
  RolloutEnd* ends;             // (rollouts)
};

// The results of a rollout, apart from its visits.
struct RolloutPath {
  Approach closest;
  uint32_t closestTicks, ticks;
};

// Examines the state of a rollout after each tick.
template <class Visit>
struct RolloutWatch {
  const RolloutRules& rules;
  const sim::RigidBody* bodies;
  Trail trail;
  Visit visit;  // takes (key, world, ticks) of each state outside the last kept state's cell
  Approach closest{};
  uint32_t closestTicks = 0, tick = 0;

  OBBY_DEVICE void operator()(const sim::Action&, const sim::World& w) {
    if (++tick % rules.rule.lookEvery != 0 || w.outcome != sim::Outcome::running) return;
    const uint64_t here = cellKey(rules.binning, w, bodies);
    if (trail.isNew(here, rules.rule, w)) {
      visit(here, w, tick);
      trail.kept = here;
    }
    if (here == trail.last) return;
    trail.last = here;
    const Approach now = approachOf(rules.context.query, w);
    if (!closer(now, closest)) return;
    closest = now;
    closestTicks = tick;
  }
};

// Takes `world` and its bodies to the end of rollout `id`. `kDynamic`: see sim::tick.
template <bool kDynamic, class Visit>
OBBY_DEVICE RolloutPath explore(const RolloutRules& rules, uint64_t id, uint32_t ticks,
                                sim::World& world, sim::RigidBody* bodies, Visit&& visit) {
  const uint64_t key = cellKey(rules.binning, world, bodies);
  RolloutWatch<Visit&> watch{rules, bodies, {key, key}, visit};
  const uint32_t done =
      runRollout<kDynamic>(rules.context, rules.seed, id, world, bodies, ticks, watch);
  return {watch.closest, watch.closestTicks, done};
}

template <bool kDynamic>
OBBY_DEVICE void exploreOne(const RolloutArguments& a, uint32_t i) {
  const RolloutStart& start = a.starts[i];
  sim::World world = start.world;
  const uint32_t bodyCount = a.rules.context.level.bodyCount;
  sim::RigidBody* const bodies = a.bodies + size_t(i) * bodyCount;
  uint32_t visits = 0;
  const auto note = [&](uint64_t key, const sim::World& w, uint32_t tick) {
    const size_t at = size_t(i) * a.capacity + visits++;
    a.visits[at] = {w, key, tick};
    for (uint32_t b = 0; b < bodyCount; ++b) a.visitBodies[at * bodyCount + b] = bodies[b];
  };
  const RolloutPath path = explore<kDynamic>(a.rules, start.id, start.ticks, world, bodies, note);
  a.ends[i] = {world, path.closest, path.closestTicks, path.ticks, visits};
}

}  // namespace obby::solve
