// Builds rotations from angles, axes and directions, as CFrame's constructors and members do.
// Angles are radians. Values are computed in double precision and rounded once. Private to
// lib/engine.
#pragma once

#include "level/rotation.h"

namespace obby::engine {

struct Angles {
  double x = 0, y = 0, z = 0;
};
struct AxisAngle {
  Vec3 axis = {1, 0, 0};
  double angle = 0;
};

Mat3 fromAnglesXyz(Angles angles);  // Rx Ry Rz, as CFrame.Angles
Mat3 fromAnglesYxz(Angles angles);  // Ry Rx Rz, as CFrame.fromOrientation and part.Orientation
Angles anglesXyz(const Mat3& rotation);
Angles anglesYxz(const Mat3& rotation);
AxisAngle axisAngle(const Mat3& rotation);
// Returns the rotation that looks along `direction`. Straight up and down have a rotation, too.
Mat3 looking(Vec3 direction, Vec3 up);
Mat3 orthonormal(const Mat3& rotation);
// Interpolates along the shortest arc. `share` may be outside of [0, 1].
Mat3 between(const Mat3& from, const Mat3& to, float share);

}  // namespace obby::engine
