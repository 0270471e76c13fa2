// Tests after a tick whether the player reaches or touches a target of a query.
#pragma once

#include "level/query_view.h"
#include "sim/touch.h"

namespace obby::sim {

// Returns the pose of a collider after the tick that led to `w`.
OBBY_DEVICE Pose poseAfter(const level::LevelView& level, const World& w, const RigidBody* bodies,
                           const level::Collider& c) {
  return poseOf(c, w, bodies, level, 0);
}

// Returns true if the player touches the collider, even if it is away. Roles use the same test.
OBBY_CALLED bool touchesCollider(const World& w, const RigidBody* bodies,
                                 const level::LevelView& level, uint32_t id, const Limbs& limbs) {
  const level::Collider& c = level.colliders[id];
  if (isGone(c, bodies)) return false;
  const Pose pose = poseAfter(level, w, bodies, c);
  const Candidate candidate{boundsOf(pose, c.shape.half), &pose, id, level.bounds[id].flags};
  return touches(c, candidate, limbs);
}

// Returns true if a floor, a truss or a seat holds the player.
OBBY_DEVICE bool isHeld(const World& w) {
  const bool onFeet = w.state == State::running || w.state == State::landed;
  return onFeet ? (w.flags & kFloorSensed) != 0
                : w.state == State::climbing || w.state == State::seated;
}

// Returns true if the player is in the region, or if the limbs touch a part of the target. If the
// player must stand on the target, something must also hold the player, with the feet in the
// region. `bodies` has level.bodyCount bodies, or is null if there are none.
OBBY_DEVICE bool reaches(const World& w, const RigidBody* bodies, const level::LevelView& level,
                         const level::QueryView& q, const level::TargetView& target) {
  const Vec3 feet = w.position;
  if (target.stand) return isHeld(w) && geom::meets(target.region, feet, feet);
  if (target.touchCount == 0) {
    return geom::meets(target.region, feet, feet + Vec3{0, level.params.bodyTop, 0});
  }
  const Limbs limbs = limbsOf(w, level.params);
  for (uint32_t i = 0; i < target.touchCount; ++i) {
    if (touchesCollider(w, bodies, level, q.touched[target.firstTouch + i], limbs)) return true;
  }
  return false;
}

}  // namespace obby::sim
