// The offset of an avatar's centre of mass from the centre of its root part, up to 0.3 studs
// (docs/physics.md, body). A recorded velocity belongs to the centre of mass, a recorded position
// to the root.
#pragma once

#include "math/angle.h"
#include "math/vec.h"

namespace obby::calibrate {

// Returns a horizontal direction turned to the right by a quarter turn.
inline Vec3 rightOf(Vec3 ahead) { return {-ahead.z, 0, ahead.x}; }

struct MassCentre {
  float ahead = 0, right = 0;  // offset from the root's centre, studs

  bool isRoot() const { return ahead == 0 && right == 0; }
  // Returns the offset from the root's centre in world axes, for an avatar that faces `yaw`.
  Vec3 at(Turns yaw) const {
    const Vec3 front = directionOf(sinCos(yaw));
    return front * ahead + rightOf(front) * right;
  }
};

}  // namespace obby::calibrate
