// The state of a dynamic body: an unanchored part that physics moves. A world has one for each row
// of LevelView::bodies, in a separate array. Levels without dynamic parts have none.
#pragma once

#include "level/level_view.h"

namespace obby::sim {

enum class RigidBodyState : uint8_t {
  awake,   // moves, or may move
  asleep,  // at rest until something touches it
  gone     // fell out of the world
};

// The struct has no padding, so a body is hashed as its bytes.
struct RigidBody {
  Vec3 position;        // position of the centre of mass, studs
  Quat rotation;        // rotation of the part
  Vec3 velocity;        // studs/s
  Vec3 spin;            // rad/s, world
  uint16_t stillTicks;  // ticks since the body became slow
  RigidBodyState state;
  uint8_t unused;  // 0
};
static_assert(sizeof(RigidBody) == 56);

// Returns the pose of a body's part. `center` is the centre of mass, which need not be the part's
// centre.
OBBY_DEVICE Pose partPose(const level::DynamicBody& l, Vec3 center, const Mat3& axes) {
  return {center - axes * l.center, axes};
}
OBBY_DEVICE Pose poseOf(const RigidBody& b, const level::DynamicBody& l) {
  return partPose(l, b.position, toMat3(b.rotation));
}

// Returns the velocity of the body's material at a point of the world, studs/s.
OBBY_DEVICE Vec3 velocityAt(const RigidBody& b, Vec3 point) {
  return b.velocity + cross(b.spin, point - b.position);
}

// Returns true if the body could meet the box.
OBBY_DEVICE bool isNear(const RigidBody& b, const level::DynamicBody& l, const Box& box) {
  const Vec3 r{l.radius, l.radius, l.radius};
  return b.state != RigidBodyState::gone && overlaps(Box{b.position - r, b.position + r}, box);
}

// Wakes a body that sleeps. A body that fell out of the world stays gone.
OBBY_DEVICE void wake(RigidBody& b) {
  if (b.state == RigidBodyState::asleep) b.state = RigidBodyState::awake;
  b.stillTicks = 0;
}

}  // namespace obby::sim
