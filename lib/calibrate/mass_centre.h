// An avatar's centre of mass beside the centre of its root part. A recorded velocity is of the
// former, a recorded position of the latter. They are up to 0.3 studs apart (docs/physics.md,
// body).
#pragma once

#include "math/angle.h"
#include "math/vec.h"

namespace obby::calibrate {

// A quarter turn to the right of a horizontal direction.
inline Vec3 rightOf(Vec3 ahead) { return {-ahead.z, 0, ahead.x}; }

struct MassCentre {
  float ahead = 0, right = 0;  // of the root's centre, studs

  bool isRoot() const { return ahead == 0 && right == 0; }
  // From the root's centre, world axes, of an avatar that faces `yaw`.
  Vec3 at(Turns yaw) const;
};

}  // namespace obby::calibrate
