// Rotation helpers; double precision inside so that repeated use does not drift.
#include "import/pose_math.h"

#include <algorithm>
#include <cmath>

namespace obby::importer {

bool isFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

namespace {

bool isExact(const Mat3& m) {
  constexpr float kSlack = 1e-6f;
  return absf(dot(m.x, m.x) - 1) < kSlack && absf(dot(m.y, m.y) - 1) < kSlack &&
         absf(dot(m.z, m.z) - 1) < kSlack && absf(dot(m.x, m.y)) < kSlack &&
         absf(dot(m.x, m.z)) < kSlack && absf(dot(m.y, m.z)) < kSlack;
}

}  // namespace

Mat3 repairedRotation(const Mat3& rotation, bool* reflected) {
  Mat3 m = rotation;
  *reflected = false;
  if (!isFinite(m.x) || !isFinite(m.y) || !isFinite(m.z)) return {};
  if (dot(cross(m.x, m.y), m.z) < 0) {
    *reflected = true;
    m.x = -m.x;
  }
  if (isExact(m)) return m;
  m.y = normalize(m.y);
  const Vec3 side = m.x - m.y * dot(m.x, m.y);
  if (length(side) < 1e-6f) return {};
  m.x = normalize(side);
  m.z = cross(m.x, m.y);
  return m;
}

Quat toQuat(const Mat3& m) {
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

Mat3 rotationAbout(Vec3 axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), k = 1 - c;
  const double x = axis.x, y = axis.y, z = axis.z;
  return {{float(c + x * x * k), float(x * y * k + z * s), float(x * z * k - y * s)},
          {float(x * y * k - z * s), float(c + y * y * k), float(y * z * k + x * s)},
          {float(x * z * k + y * s), float(y * z * k - x * s), float(c + z * z * k)}};
}

Vec3 rotationVector(const Mat3& rotation) {
  const Quat q = toQuat(rotation);
  const double sine = std::sqrt(double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z);
  if (sine < 1e-9) return {};
  const double angle = 2 * std::atan2(sine, double(q.w));
  return Vec3{q.x, q.y, q.z} * float(angle / sine);
}

Mat3 inverse(const Mat3& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}

Pose operator*(const Pose& a, const Pose& b) {
  return {toWorld(a, b.position), a.rotation * b.rotation};
}

Pose inverse(const Pose& pose) {
  const Mat3 back = inverse(pose.rotation);
  return {-(back * pose.position), back};
}

Pose between(const Pose& a, const Pose& b, float t) {
  const Vec3 turn = rotationVector(b.rotation * inverse(a.rotation));
  const float angle = length(turn);
  const Mat3 part =
      angle < 1e-7f ? Mat3{} : rotationAbout(turn * (1 / angle), double(angle) * double(t));
  return {a.position + (b.position - a.position) * t, part * a.rotation};
}

float yawOf(Vec3 look) {
  if (absf(look.x) < 1e-6f && absf(look.z) < 1e-6f) return 0;
  return float(std::atan2(-double(look.x), -double(look.z))) + 0.0f;
}

}  // namespace obby::importer
