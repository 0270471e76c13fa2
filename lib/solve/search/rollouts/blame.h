// Finds the part by which an attempt failed, even if the simulator names none. This is for records:
// no search depends on it.
#pragma once

#include "sim/targets.h"

namespace obby::solve {

OBBY_DEVICE bool hurts(const sim::World& w, const sim::RigidBody* bodies,
                       const level::LevelView& level, uint32_t collider, const sim::Limbs& limbs) {
  return (level.bounds[collider].flags & level::kKill) != 0 &&
         sim::touchesCollider(w, bodies, level, collider, limbs);
}

// Returns the part that took too much health from a player whose attempt has just ended as hurt:
// the first kill part that is touched. Returns level::kNone if none is touched any more, because
// the same tick moved the player away. `bodies`: null if unknown; parts of dynamic bodies are then
// ignored.
OBBY_DEVICE uint32_t partThatHurts(const sim::World& w, const sim::RigidBody* bodies,
                                   const level::LevelView& level) {
  const sim::Limbs limbs = sim::limbsOf(w, level.params);
  // The order is that of a tick's touches. Dynamic bodies are in no grid.
  for (uint32_t b = 0; bodies != nullptr && b < level.bodyCount; ++b) {
    const level::DynamicBody& body = level.bodies[b];
    for (uint32_t i = 0; i < body.colliderCount; ++i) {
      const uint32_t id = body.firstCollider + i;
      if (hurts(w, bodies, level, id, limbs)) return level.colliders[id].part;
    }
  }
  const int32_t cell = sim::cellOf<float>(level.grid, w.position);
  if (cell < 0) return level::kNone;
  const uint32_t* const list = level.grid.lists + level.grid.cells[cell];
  for (uint32_t i = 1; i <= list[0]; ++i) {
    if (hurts(w, bodies, level, list[i], limbs)) return level.colliders[list[i]].part;
  }
  return level::kNone;
}

// Returns the part that hurt the player if that ended the attempt, or else World::part.
OBBY_DEVICE uint32_t blamedPart(const sim::World& w, const sim::RigidBody* bodies,
                                const level::LevelView& level) {
  return w.outcome == sim::Outcome::hurt ? partThatHurts(w, bodies, level) : w.part;
}

}  // namespace obby::solve
