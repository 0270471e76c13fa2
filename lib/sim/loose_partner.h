// What a loose body meets: another body or a part, and how its surface moves.
#pragma once

#include "geom/convex.h"
#include "sim/loose.h"

namespace obby::sim {

constexpr int kPart = level::kMaxLoose;

OBBY_DEVICE geom::Convex convexOf(const level::Collider& c, const Pose& pose) {
  return {c.kind, c.shape, pose};
}

// What a body meets: another body or a part, by one of its colliders.
struct Partner {
  geom::Convex convex;
  int body;  // kPart: a part
  const level::Collider* collider;
  uint32_t flags;
  Pose before;  // where a moving part was a tick ago
};

// How a part itself moves where it is met: not at all, or as its mover has it.
OBBY_DEVICE Vec3 movedBy(const level::LevelView& level, const Partner& part, Vec3 point) {
  if (!(part.flags & level::kMoving)) return {};
  const Vec3 local = toLocal(part.convex.pose, point);
  return (point - toWorld(part.before, local)) * float(level.params.controlRate);
}

// Velocity of a part's surface. Parts that do not carry press, but do not drag along.
OBBY_DEVICE Vec3 surfaceOf(const level::LevelView& level, const Partner& part, Vec3 point,
                           Vec3 normal, Vec3 moved) {
  Vec3 velocity = part.flags & level::kCarries ? moved : normal * dot(moved, normal);
  if (part.flags & level::kConveyor) {
    const Vec3 center = part.convex.pose.position;
    velocity += conveyorVelocityAt(level.roles[part.collider->role], center, point);
  }
  return velocity + Vec3{};  // never -0, to which adding nothing makes a difference
}

}  // namespace obby::sim
