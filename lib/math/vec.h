// Vectors, rotations and boxes in single precision. Every operation is a fixed sequence of IEEE
// operations, so that all backends agree bit for bit. Y is up, right-handed, lengths in studs.
#pragma once

#include "base/device.h"

namespace obby {

struct Vec3 {
  float x = 0, y = 0, z = 0;
};

OBBY_DEVICE Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
OBBY_DEVICE Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
OBBY_DEVICE Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
OBBY_DEVICE Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
OBBY_DEVICE Vec3 operator*(float s, Vec3 a) { return a * s; }
OBBY_DEVICE Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
OBBY_DEVICE Vec3& operator-=(Vec3& a, Vec3 b) { return a = a - b; }
OBBY_DEVICE bool operator==(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
OBBY_DEVICE Vec3 mul(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
OBBY_DEVICE float dot(Vec3 a, Vec3 b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
OBBY_DEVICE Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

OBBY_DEVICE float minf(float a, float b) { return a < b ? a : b; }
OBBY_DEVICE float maxf(float a, float b) { return a > b ? a : b; }
OBBY_DEVICE float clampf(float v, float lo, float hi) { return minf(maxf(v, lo), hi); }
OBBY_DEVICE float absf(float v) { return __builtin_fabsf(v); }
OBBY_DEVICE float sqrtf32(float v) { return __builtin_sqrtf(v); }  // correctly rounded everywhere

OBBY_DEVICE Vec3 min(Vec3 a, Vec3 b) { return {minf(a.x, b.x), minf(a.y, b.y), minf(a.z, b.z)}; }
OBBY_DEVICE Vec3 max(Vec3 a, Vec3 b) { return {maxf(a.x, b.x), maxf(a.y, b.y), maxf(a.z, b.z)}; }
OBBY_DEVICE Vec3 abs(Vec3 a) { return {absf(a.x), absf(a.y), absf(a.z)}; }
OBBY_DEVICE float length(Vec3 a) { return sqrtf32(dot(a, a)); }
// `fallback` where `a` is too short to have a direction.
OBBY_DEVICE Vec3 normalize(Vec3 a, Vec3 fallback = {0, 1, 0}) {
  const float n = length(a);
  return n > 1e-12f ? a * (1.0f / n) : fallback;
}
OBBY_DEVICE float component(Vec3 a, int i) { return i == 0 ? a.x : i == 1 ? a.y : a.z; }

// Rotation matrix by columns: the axes of the rotated frame. world = local.x * x + local.y * y +
// local.z * z.
struct Mat3 {
  Vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
};

OBBY_DEVICE Vec3 operator*(const Mat3& m, Vec3 v) { return (m.x * v.x + m.y * v.y) + m.z * v.z; }
// Transpose times vector: world to local.
OBBY_DEVICE Vec3 toLocal(const Mat3& m, Vec3 v) { return {dot(m.x, v), dot(m.y, v), dot(m.z, v)}; }
OBBY_DEVICE Mat3 operator*(const Mat3& a, const Mat3& b) { return {a * b.x, a * b.y, a * b.z}; }

// Unit quaternion.
struct Quat {
  float x = 0, y = 0, z = 0, w = 1;
};

OBBY_DEVICE Quat operator*(Quat a, Quat b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

OBBY_DEVICE Quat normalize(Quat q) {
  const float n = sqrtf32(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(n > 1e-12f)) return {};
  const float s = 1.0f / n;
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}

OBBY_DEVICE Mat3 toMat3(Quat q) {
  const float xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const float xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const float wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy)},
          {2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx)},
          {2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy)}};
}

// Where a body is: world = rotation * local + position.
struct Pose {
  Vec3 position;
  Mat3 rotation;
};

OBBY_DEVICE Vec3 toWorld(const Pose& p, Vec3 local) { return p.rotation * local + p.position; }
OBBY_DEVICE Vec3 toLocal(const Pose& p, Vec3 world) {
  return toLocal(p.rotation, world - p.position);
}

// Axis-aligned box, corners included.
struct Box {
  Vec3 lo, hi;
};

OBBY_DEVICE bool overlaps(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
         a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}
OBBY_DEVICE Box join(const Box& a, const Box& b) { return {min(a.lo, b.lo), max(a.hi, b.hi)}; }
OBBY_DEVICE Box grow(const Box& a, Vec3 by) { return {a.lo - by, a.hi + by}; }
// World box of an oriented box with half extents `half`.
OBBY_DEVICE Box boundsOf(const Pose& p, Vec3 half) {
  const Vec3 e =
      abs(p.rotation.x) * half.x + abs(p.rotation.y) * half.y + abs(p.rotation.z) * half.z;
  return {p.position - e, p.position + e};
}

}  // namespace obby
