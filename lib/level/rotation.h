// Conversions of rotations for the host. They use libm, so their bits may differ between machines.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace obby {

// Returns the unit quaternion with w >= 0 of an orthonormal matrix.
inline Quat toQuat(const Mat3& m) {
  // Shepperd's method: divide by the largest component.
  const double xx = m.x.x, yy = m.y.y, zz = m.z.z;
  const double t[4] = {1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz, 1 + xx + yy + zz};
  const int big = int(std::max_element(t, t + 4) - t);
  const double s = 0.5 / std::sqrt(std::max(t[big], 1e-12));
  const double a = double(m.y.z) - m.z.y, b = double(m.z.x) - m.x.z, c = double(m.x.y) - m.y.x;
  const double xy = double(m.x.y) + m.y.x, xz = double(m.x.z) + m.z.x, yz = double(m.y.z) + m.z.y;
  double q[4];
  switch (big) {
    case 0: q[0] = t[0] * s, q[1] = xy * s, q[2] = xz * s, q[3] = a * s; break;
    case 1: q[0] = xy * s, q[1] = t[1] * s, q[2] = yz * s, q[3] = b * s; break;
    case 2: q[0] = xz * s, q[1] = yz * s, q[2] = t[2] * s, q[3] = c * s; break;
    default: q[0] = a * s, q[1] = b * s, q[2] = c * s, q[3] = t[3] * s; break;
  }
  const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double sign = q[3] < 0 ? -1 / n : 1 / n;
  const auto part = [&](double v) { return float(v * sign) + 0.0f; };  // no negative zero
  return {part(q[0]), part(q[1]), part(q[2]), part(q[3])};
}

// Returns the axis (unit) times the angle (0 to pi) of a rotation.
inline Vec3 rotationVector(const Mat3& rotation) {
  const Quat q = toQuat(rotation);
  const double sine = std::sqrt(double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z);
  if (sine < 1e-9) return {};
  const double angle = 2 * std::atan2(sine, double(q.w));
  return Vec3{q.x, q.y, q.z} * float(angle / sine);
}

// Returns the transpose, which is the inverse of a rotation.
inline Mat3 inverse(const Mat3& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}

// Returns the rotation by `angle` radians about a unit axis.
inline Mat3 rotationAbout(Vec3 axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), k = 1 - c;
  const double x = axis.x, y = axis.y, z = axis.z;
  return {{float(c + x * x * k), float(x * y * k + z * s), float(x * z * k - y * s)},
          {float(x * y * k - z * s), float(c + y * y * k), float(y * z * k + x * s)},
          {float(x * z * k + y * s), float(y * z * k - x * s), float(c + z * z * k)}};
}

// Returns the world pose of `b`, which is given in the frame of `a`.
inline Pose operator*(const Pose& a, const Pose& b) {
  return {toWorld(a, b.position), a.rotation * b.rotation};
}

// Returns the pose that undoes this one: inverse(p) * p is the identity.
inline Pose inverse(const Pose& pose) {
  const Mat3 back = inverse(pose.rotation);
  return {-(back * pose.position), back};
}

}  // namespace obby
