// The kernel of a search: one rollout a thread, with what the search notes of it. Launched on a GPU
// by cuda/rollout.cu. The archive stays with the host, which takes the visits in rollout order.
#pragma once

#include "solve/rollout.h"
#include "solve/trail.h"

namespace obby::solve {

struct RolloutStart {
  sim::World world;
  uint64_t id;     // its stream of random numbers
  uint32_t ticks;  // at most
};

// A state in a cell that the rollout had not just been kept in.
struct RolloutVisit {
  sim::World world;
  uint64_t key;
  uint32_t ticks;  // into the rollout
};

struct RolloutEnd {
  sim::World world;
  Approach closest;
  uint32_t closestTicks, ticks, visits;
};

struct RolloutArguments {
  ExploreContext context;
  Binning binning;
  KeepRule rule;
  uint64_t seed;
  uint32_t ticks;              // of any rollout, at most
  uint32_t room;               // visits of a rollout, at most
  const RolloutStart* starts;  // (rollouts)
  RolloutVisit* visits;        // (rollouts, room)
  sim::LooseBody* loose;       // (rollouts, level.looseCount), from the start to the end
  sim::LooseBody* visitLoose;  // (rollouts, room, level.looseCount)
  RolloutEnd* ends;            // (rollouts)
};

// Visits that a rollout can have.
OBBY_DEVICE uint32_t visitRoom(const RolloutArguments& a) { return a.ticks / a.rule.lookEvery; }

// `kLoose`: as for sim::tick.
template <bool kLoose>
OBBY_DEVICE void exploreOne(const RolloutArguments& a, uint32_t i) {
  sim::World world = a.starts[i].world;
  const uint32_t bodies = a.context.level.looseCount;
  sim::LooseBody* const loose = a.loose + size_t(i) * bodies;
  const uint64_t key = cellKey(a.binning, world, loose);
  Trail trail{key, key};
  Approach closest;
  uint32_t closestTicks = 0, tick = 0, visits = 0;
  const auto look = [&](const sim::Action&, const sim::World& w) {
    if (++tick % a.rule.lookEvery != 0 || w.outcome != sim::Outcome::running) return;
    const uint64_t here = cellKey(a.binning, w, loose);
    if (trail.isNew(here, a.rule, w)) {
      const size_t at = size_t(i) * a.room + visits++;
      a.visits[at] = {w, here, tick};
      for (uint32_t b = 0; b < bodies; ++b) a.visitLoose[at * bodies + b] = loose[b];
      trail.kept = here;
    }
    if (here == trail.last) return;
    trail.last = here;
    const Approach now = approachOf(a.context.query, w);
    if (!closer(now, closest)) return;
    closest = now;
    closestTicks = tick;
  };
  const RolloutStart& start = a.starts[i];
  const uint32_t ticks =
      runRollout<kLoose>(a.context, a.seed, start.id, world, loose, start.ticks, look);
  a.ends[i] = {world, closest, closestTicks, ticks, visits};
}

}  // namespace obby::solve
