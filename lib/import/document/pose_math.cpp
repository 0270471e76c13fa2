// Computes rotations in double precision, so that repeated use does not drift.
#include "import/document/pose_math.h"

#include <algorithm>
#include <cmath>

namespace obby::importer {

Vec3 boundedSize(Vec3 size) {
  constexpr float kLeast = 0.001f, kMost = 2048;  // studs
  return min(max(abs(size), Vec3{kLeast, kLeast, kLeast}), Vec3{kMost, kMost, kMost});
}

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

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

Pose between(const Pose& a, const Pose& b, float t) {
  const Vec3 turn = rotationVector(b.rotation * inverse(a.rotation));
  const float angle = length(turn);
  const Mat3 part =
      angle < 1e-7f ? Mat3{} : rotationAbout(turn * (1 / angle), double(angle) * double(t));
  return {a.position + (b.position - a.position) * t, part * a.rotation};
}

Mat3 fromOrientation(Vec3 degrees) {
  return rotationAbout({0, 1, 0}, double(degrees.y) * kDegree) *
         rotationAbout({1, 0, 0}, double(degrees.x) * kDegree) *
         rotationAbout({0, 0, 1}, double(degrees.z) * kDegree);
}

Vec3 toOrientation(const Mat3& r) {
  const double pitch = std::asin(std::clamp(-double(r.z.y), -1.0, 1.0));
  const bool locked = std::abs(r.z.y) > 0.999999f;
  const double yaw =
      locked ? std::atan2(-double(r.x.z), double(r.x.x)) : std::atan2(double(r.z.x), double(r.z.z));
  const double roll = locked ? 0 : std::atan2(double(r.x.y), double(r.y.y));
  return Vec3{float(pitch / kDegree), float(yaw / kDegree), float(roll / kDegree)};
}

float yawOf(Vec3 look) {
  if (absf(look.x) < 1e-6f && absf(look.z) < 1e-6f) return 0;
  return float(std::atan2(-double(look.x), -double(look.z))) + 0.0f;
}

bool isSame(const Pose& a, const Pose& b) {
  constexpr float kUnmoved = 1e-4f;
  return length(a.position - b.position) < kUnmoved &&
         length(a.rotation.x - b.rotation.x) < kUnmoved &&
         length(a.rotation.y - b.rotation.y) < kUnmoved;
}

}  // namespace obby::importer
