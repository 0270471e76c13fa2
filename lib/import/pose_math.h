// Rotations as place files hold them: nine numbers that may be off, or a reflection.
#pragma once

#include "level/rotation.h"

namespace obby::importer {

// Orthonormal and right-handed. `reflected` is set where the determinant was negative: then the X
// axis is turned round, which keeps look and up directions (every part shape but the corner wedge
// is symmetric in X). A singular matrix gives the identity.
Mat3 repairedRotation(const Mat3& rotation, bool* reflected);

// The pose a share `t` of the straight way and the shortest turn from `a` to `b`.
Pose between(const Pose& a, const Pose& b, float t);

// The engine's Orientation: degrees about X, Y and Z; the rotation is that about Y, times X, times
// Z.
Mat3 fromOrientation(Vec3 degrees);
Vec3 toOrientation(const Mat3& rotation);

// Radians of the horizontal direction: 0 looks along -Z, counter-clockwise seen from above.
float yawOf(Vec3 look);

bool isFinite(Vec3 v);
// Returns true if the poses differ by no more than rounding.
bool isSame(const Pose& a, const Pose& b);
// As the engine takes the size of a part, and the level's record has it.
Vec3 boundedSize(Vec3 size);

}  // namespace obby::importer
