// Rotations as place files hold them: nine numbers that may be off, or a reflection.
#pragma once

#include "math/vec.h"

namespace obby::importer {

// Orthonormal and right-handed. `reflected` is set where the determinant was negative: then the X
// axis is turned round, which keeps look and up directions (every part shape but the corner wedge
// is symmetric in X). A singular matrix gives the identity.
Mat3 repairedRotation(const Mat3& rotation, bool* reflected);

// Unit quaternion with w >= 0 of an orthonormal matrix.
Quat toQuat(const Mat3& rotation);

// Rotation by `angle` radians about a unit axis.
Mat3 rotationAbout(Vec3 axis, double angle);

// Axis (unit) times angle (0 to pi) of a rotation.
Vec3 rotationVector(const Mat3& rotation);

// Transpose, which is the inverse of a rotation.
Mat3 inverse(const Mat3& rotation);
Pose operator*(const Pose& a, const Pose& b);
Pose inverse(const Pose& pose);

// The pose a share `t` of the straight way and the shortest turn from `a` to `b`.
Pose between(const Pose& a, const Pose& b, float t);

// Radians of the horizontal direction: 0 looks along -Z, counter-clockwise seen from above.
float yawOf(Vec3 look);

bool isFinite(Vec3 v);

}  // namespace obby::importer
