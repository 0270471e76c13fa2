// What a search notes of a rollout: the cells it passes through that are worth keeping, and how
// close it comes to where it should go. The same on CPU and GPU.
#pragma once

#include "solve/search/archive/cell.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

// How close a state is to the goal, and how much of the way there is behind.
struct Approach {
  uint32_t targets = 0;    // waypoints and visits behind
  float distance = 1e30f;  // studs from the next region
  Vec3 position;           // feet
};

OBBY_DEVICE bool closer(const Approach& a, const Approach& b) {
  return a.targets > b.targets || (a.targets == b.targets && a.distance < b.distance);
}

// Studs to the next region.
OBBY_DEVICE float distanceLeft(const level::QueryView& query, const sim::World& w) {
  return nextRegion(query, w).distance;
}

OBBY_DEVICE Approach approachOf(const level::QueryView& query, const sim::World& w) {
  return {targetsReached(w), distanceLeft(query, w), w.position};
}

// Which states are worth keeping.
struct KeepRule {
  bool groundedOnly;   // those that stand, or have been in the air for long
  uint32_t airSteps;   // that many physics steps
  uint32_t lookEvery;  // ticks: states between are passed over
};

OBBY_DEVICE bool keeps(const KeepRule& rule, const sim::World& w) {
  return !rule.groundedOnly || grounded(w) || w.floorlessSteps >= rule.airSteps;
}

// The cells that a rollout was in and was kept in last.
struct Trail {
  uint64_t last, kept;

  OBBY_DEVICE bool isNew(uint64_t key, const KeepRule& rule, const sim::World& w) const {
    return key != kept && keeps(rule, w);
  }
};

}  // namespace obby::solve
