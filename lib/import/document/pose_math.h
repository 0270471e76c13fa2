// Repairs and converts rotations of place files: nine numbers that may be inexact or a reflection.
#pragma once

#include "level/record_values.h"
#include "level/rotation.h"

namespace obby::importer {

// Returns an orthonormal, right-handed rotation. A negative determinant sets `reflected` and flips
// the X axis, which keeps the look and up directions. Every part shape except the corner wedge is
// symmetric in X. A singular matrix becomes the identity.
Mat3 repairedRotation(const Mat3& rotation, bool* reflected);

// Interpolates from `a` to `b` by the fraction `t`: straight in position, by the shortest turn in
// rotation.
Pose between(const Pose& a, const Pose& b, float t);

// Converts the engine's Orientation, in degrees: the rotation about Y, times X, times Z.
Mat3 fromOrientation(Vec3 degrees);
Vec3 toOrientation(const Mat3& rotation);

// Returns the yaw of a direction in radians: 0 looks along -Z, counter-clockwise seen from above.
float yawOf(Vec3 look);

using level::isFinite;
// Returns true if the poses differ by no more than rounding.
bool isSame(const Pose& a, const Pose& b);
// Clamps the size of a part to the engine's limits.
Vec3 boundedSize(Vec3 size);

}  // namespace obby::importer
