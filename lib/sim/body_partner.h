// The partner of a dynamic body in a contact, another body or a part, and the motion of its
// surface.
#pragma once

#include "geom/convex.h"
#include "sim/rigid_body.h"

namespace obby::sim {

constexpr int kPart = level::kMaxBodies;

OBBY_DEVICE geom::Convex convexOf(const level::Collider& c, const Pose& pose) {
  return {c.kind, c.shape, pose};
}

// A partner, represented by one of its colliders.
struct Partner {
  geom::Convex convex;
  int body;  // kPart for a part
  const level::Collider* collider;
  uint32_t flags;
  Pose before;  // pose of a moving part a tick ago
};

// Returns the velocity of a part at a point. It is zero unless a mover moves the part.
OBBY_DEVICE Vec3 movedBy(const level::LevelView& level, const Partner& part, Vec3 point) {
  if (!(part.flags & level::kMoving)) return {};
  const Vec3 local = toLocal(part.convex.pose, point);
  return (point - toWorld(part.before, local)) * float(level.params.controlRate);
}

// Returns the velocity of a part's surface. A moving part that does not carry still pushes, but
// does not drag.
OBBY_DEVICE Vec3 surfaceOf(const level::LevelView& level, const Partner& part, Vec3 point,
                           Vec3 normal, Vec3 moved) {
  Vec3 velocity = part.flags & level::kCarries ? moved : normal * dot(moved, normal);
  if (part.flags & level::kConveyor) {
    const Vec3 center = part.convex.pose.position;
    velocity += conveyorVelocityAt(level.roles[part.collider->role], center, point);
  }
  return velocity + Vec3{};  // never -0: a later addition of 0 would change the bits of -0
}

}  // namespace obby::sim
