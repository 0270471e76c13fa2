// Notes of a rollout: the cells it passes through that are worth keeping, and its closest approach
// to the goal. The same on CPU and GPU.
#pragma once

#include "solve/search/archive/cell.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

// The progress of a state toward the goal.
struct Approach {
  uint32_t targets = 0;    // waypoints and visits reached
  float distance = 1e30f;  // studs to the next region
  Vec3 position;           // feet
};

OBBY_DEVICE bool closer(const Approach& a, const Approach& b) {
  return a.targets > b.targets || (a.targets == b.targets && a.distance < b.distance);
}

// Returns the studs to the next region.
OBBY_DEVICE float distanceLeft(const level::QueryView& query, const sim::World& w) {
  return nextRegion(query, w).distance;
}

OBBY_DEVICE Approach approachOf(const level::QueryView& query, const sim::World& w) {
  return {targetsReached(w), distanceLeft(query, w), w.position};
}

// Decides which states are worth keeping.
struct KeepRule {
  bool groundedOnly;   // only those that stand, or have long been in the air
  uint32_t airSteps;   // physics steps in the air that count as long
  uint32_t lookEvery;  // ticks; states in between are ignored
};

OBBY_DEVICE bool keeps(const KeepRule& rule, const sim::World& w) {
  return !rule.groundedOnly || grounded(w) || w.floorlessSteps >= rule.airSteps;
}

// The cell of a rollout at the last look, and the cell of its last kept state.
struct Trail {
  uint64_t last, kept;

  OBBY_DEVICE bool isNew(uint64_t key, const KeepRule& rule, const sim::World& w) const {
    return key != kept && keeps(rule, w);
  }
};

}  // namespace obby::solve
