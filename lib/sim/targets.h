// What a query names, as the world is after a tick: has the player reached it, does it touch it?
#pragma once

#include "level/query_view.h"
#include "sim/touch.h"

namespace obby::sim {

// Where a collider is after the tick that led to `w`.
OBBY_DEVICE Pose poseAfter(const level::LevelView& level, const World& w, const LooseBody* loose,
                           const level::Collider& c) {
  return poseOf(c, w, loose, level, 0);
}

// Does the player touch the collider? The same test that roles are touched by, away or not.
OBBY_CALLED bool touchesCollider(const World& w, const LooseBody* loose,
                                 const level::LevelView& level, uint32_t id, const Limbs& limbs) {
  const level::Collider& c = level.colliders[id];
  if (isGone(c, loose)) return false;
  const Pose pose = poseAfter(level, w, loose, c);
  const Candidate candidate{boundsOf(pose, c.shape.half), &pose, id, level.bounds[id].flags};
  return touches(c, candidate, limbs);
}

// Does something hold the player: a floor, a truss or a seat?
OBBY_DEVICE bool isHeld(const World& w) {
  const bool onFeet = w.state == State::running || w.state == State::landed;
  return onFeet ? (w.flags & kFloorSensed) != 0
                : w.state == State::climbing || w.state == State::seated;
}

// Is the player in the region, or, of a target that is to be touched, do the limbs touch its part?
// If the target is to be stood on: does something hold the player, with the feet in the region?
// `loose`: (level.looseCount), null where that is 0.
OBBY_DEVICE bool reaches(const World& w, const LooseBody* loose, const level::LevelView& level,
                         const level::QueryView& q, const level::TargetView& target) {
  const Vec3 feet = w.position;
  if (target.stand) return isHeld(w) && geom::meets(target.region, feet, feet);
  if (target.touchCount == 0) {
    return geom::meets(target.region, feet, feet + Vec3{0, level.params.bodyTop, 0});
  }
  const Limbs limbs = limbsOf(w, level.params);
  for (uint32_t i = 0; i < target.touchCount; ++i) {
    if (touchesCollider(w, loose, level, q.touched[target.firstTouch + i], limbs)) return true;
  }
  return false;
}

}  // namespace obby::sim
