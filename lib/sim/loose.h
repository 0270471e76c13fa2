// A loose body: the state of an unanchored part that physics moves. A world has one for each row of
// LevelView::loose, in an array of its own beside it; levels without loose parts have none.
#pragma once

#include "level/level_view.h"

namespace obby::sim {

enum class LooseState : uint8_t {
  awake,   // moves, or may
  asleep,  // at rest until something touches it
  gone     // fell out of the world
};

// Without padding: a body hashes as its bytes.
struct LooseBody {
  Vec3 position;        // of the centre of mass, studs
  Quat rotation;        // of the part
  Vec3 velocity;        // studs/s
  Vec3 spin;            // rad/s, world
  uint16_t stillTicks;  // for how long it has been slow
  LooseState state;
  uint8_t unused;  // 0
};
static_assert(sizeof(LooseBody) == 56);

// Of a body's part, whose centre need not be its centre of mass, at `center`.
OBBY_DEVICE Pose partPose(const level::Loose& l, Vec3 center, const Mat3& axes) {
  return {center - axes * l.center, axes};
}
OBBY_DEVICE Pose poseOf(const LooseBody& b, const level::Loose& l) {
  return partPose(l, b.position, toMat3(b.rotation));
}

OBBY_DEVICE Vec3 velocityAt(const LooseBody& b, Vec3 point) {
  return b.velocity + cross(b.spin, point - b.position);
}

// Could it meet the box?
OBBY_DEVICE bool isNear(const LooseBody& b, const level::Loose& l, const Box& box) {
  const Vec3 r{l.radius, l.radius, l.radius};
  return b.state != LooseState::gone && overlaps(Box{b.position - r, b.position + r}, box);
}

OBBY_DEVICE void wake(LooseBody& b) {
  if (b.state == LooseState::asleep) b.state = LooseState::awake;
  b.stillTicks = 0;
}

}  // namespace obby::sim
