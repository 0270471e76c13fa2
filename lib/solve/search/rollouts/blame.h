// Which part an attempt failed by, also where the simulator names none. For records: no search
// depends on it.
#pragma once

#include "sim/targets.h"

namespace obby::solve {

OBBY_DEVICE bool hurts(const sim::World& w, const sim::LooseBody* loose,
                       const level::LevelView& level, uint32_t collider, const sim::Limbs& limbs) {
  return (level.bounds[collider].flags & level::kKill) != 0 &&
         sim::touchesCollider(w, loose, level, collider, limbs);
}

// The part that took the health which was too much, of a world that has just ended as hurt: the
// first that is touched there. level::kNone: none is, as the same tick has taken the player
// elsewhere. `loose`: null where it is not known; its parts are not looked at then.
OBBY_DEVICE uint32_t partThatHurts(const sim::World& w, const sim::LooseBody* loose,
                                   const level::LevelView& level) {
  const sim::Limbs limbs = sim::limbsOf(w, level.params);
  // In the order of a tick's touches. Loose bodies are in no grid.
  for (uint32_t b = 0; loose != nullptr && b < level.looseCount; ++b) {
    const level::Loose& body = level.loose[b];
    for (uint32_t i = 0; i < body.colliderCount; ++i) {
      const uint32_t id = body.firstCollider + i;
      if (hurts(w, loose, level, id, limbs)) return level.colliders[id].part;
    }
  }
  const int32_t cell = sim::cellOf<float>(level.grid, w.position);
  if (cell < 0) return level::kNone;
  const uint32_t* const list = level.grid.lists + level.grid.cells[cell];
  for (uint32_t i = 1; i <= list[0]; ++i) {
    if (hurts(w, loose, level, list[i], limbs)) return level.colliders[list[i]].part;
  }
  return level::kNone;
}

// World::part, and of those who were hurt the part that did it.
OBBY_DEVICE uint32_t blamedPart(const sim::World& w, const sim::LooseBody* loose,
                                const level::LevelView& level) {
  return w.outcome == sim::Outcome::hurt ? partThatHurts(w, loose, level) : w.part;
}

}  // namespace obby::solve
