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

// X(type, name)
#define OBBY_LOOSE_FIELDS(X)                                  \
  X(Vec3, position)       /* of the centre of mass, studs */  \
  X(Quat, rotation)       /* of the part */                   \
  X(Vec3, velocity)       /* studs/s */                       \
  X(Vec3, spin)           /* rad/s, world */                  \
  X(uint16_t, stillTicks) /* for how long it has been slow */ \
  X(LooseState, state)                                        \
  X(uint8_t, unused) /* 0: no padding, so that a body hashes as bytes */

struct LooseBody {
#define OBBY_LOOSE_FIELD(type, name) type name;
  OBBY_LOOSE_FIELDS(OBBY_LOOSE_FIELD)
#undef OBBY_LOOSE_FIELD
};
static_assert(sizeof(LooseBody) == 56);

// Of the part, whose centre need not be its centre of mass.
OBBY_DEVICE Pose poseOf(const LooseBody& b, const level::Loose& l) {
  Pose pose{{}, toMat3(b.rotation)};
  pose.position = b.position - pose.rotation * l.center;
  return pose;
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
