// Vectors, rotations and boxes in single precision. Every operation is a fixed sequence of IEEE
// operations, so that all backends agree bit for bit. Y is up, right-handed, lengths in studs. F is
// float, or lanes of floats (lanes.h); comparisons and select() then work lane by lane.
#pragma once

#include "math/lanes.h"

namespace obby {

template <class F>
struct Vec3T {
  F x = 0, y = 0, z = 0;

  friend OBBY_DEVICE Vec3T operator+(Vec3T a, Vec3T b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend OBBY_DEVICE Vec3T operator-(Vec3T a, Vec3T b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend OBBY_DEVICE Vec3T operator-(Vec3T a) { return {-a.x, -a.y, -a.z}; }
  friend OBBY_DEVICE Vec3T operator*(Vec3T a, F s) { return {a.x * s, a.y * s, a.z * s}; }
  friend OBBY_DEVICE Vec3T operator*(F s, Vec3T a) { return a * s; }
  friend OBBY_DEVICE Vec3T& operator+=(Vec3T& a, Vec3T b) { return a = a + b; }
  friend OBBY_DEVICE Vec3T& operator-=(Vec3T& a, Vec3T b) { return a = a - b; }
  friend OBBY_DEVICE bool operator==(Vec3T a, Vec3T b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
  // Returns the product by components.
  friend OBBY_DEVICE Vec3T mul(Vec3T a, Vec3T b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend OBBY_DEVICE F dot(Vec3T a, Vec3T b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  friend OBBY_DEVICE Vec3T cross(Vec3T a, Vec3T b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend OBBY_DEVICE Vec3T min(Vec3T a, Vec3T b) {
    return {minf(a.x, b.x), minf(a.y, b.y), minf(a.z, b.z)};
  }
  friend OBBY_DEVICE Vec3T max(Vec3T a, Vec3T b) {
    return {maxf(a.x, b.x), maxf(a.y, b.y), maxf(a.z, b.z)};
  }
  friend OBBY_DEVICE Vec3T abs(Vec3T a) { return {absf(a.x), absf(a.y), absf(a.z)}; }
  friend OBBY_DEVICE F length(Vec3T a) { return sqrtf32(dot(a, a)); }
  // Returns the unit vector along `a`, or `fallback` if `a` is not longer than 1e-12. The other
  // overload falls back to +Y.
  friend OBBY_DEVICE Vec3T normalize(Vec3T a, Vec3T fallback) {
    const F n = length(a);
    return select(n > 1e-12f, a * (1.0f / n), fallback);
  }
  friend OBBY_DEVICE Vec3T normalize(Vec3T a) { return normalize(a, Vec3T{0, 1, 0}); }
  friend OBBY_DEVICE Vec3T select(MaskOf<F> choose, Vec3T yes, Vec3T no) {
    return {select(choose, yes.x, no.x), select(choose, yes.y, no.y), select(choose, yes.z, no.z)};
  }
};

using Vec3 = Vec3T<float>;

// Returns a component by its index, 0 to 2.
OBBY_DEVICE float component(Vec3 a, int i) { return i == 0 ? a.x : i == 1 ? a.y : a.z; }

// Rotation matrix by columns: the axes of the rotated frame, orthonormal. world = local.x * x +
// local.y * y + local.z * z. a * b applies b first.
template <class F>
struct Mat3T {
  Vec3T<F> x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

  friend OBBY_DEVICE Vec3T<F> operator*(const Mat3T& m, Vec3T<F> v) {
    return (m.x * v.x + m.y * v.y) + m.z * v.z;
  }
  friend OBBY_DEVICE Mat3T operator*(const Mat3T& a, const Mat3T& b) {
    return {a * b.x, a * b.y, a * b.z};
  }
  // Transpose times vector: world to local.
  friend OBBY_DEVICE Vec3T<F> toLocal(const Mat3T& m, Vec3T<F> v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
  }
};

using Mat3 = Mat3T<float>;

// Unit quaternion. a * b applies b first.
template <class F>
struct QuatT {
  F x = 0, y = 0, z = 0, w = 1;

  friend OBBY_DEVICE QuatT operator*(QuatT a, QuatT b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
  }
  // Returns the quaternion scaled to length 1, or the identity if its length is at most 1e-12.
  friend OBBY_DEVICE QuatT normalize(QuatT q) {
    const F n = sqrtf32(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w), s = 1.0f / n;
    const MaskOf<F> known = n > 1e-12f;
    return {select(known, q.x * s, F(0)), select(known, q.y * s, F(0)),
            select(known, q.z * s, F(0)), select(known, q.w * s, F(1))};
  }
  friend OBBY_DEVICE Mat3T<F> toMat3(QuatT q) {
    const F xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    const F xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const F wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return {{1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy)},
            {2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx)},
            {2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy)}};
  }
  // Returns q turned by `angle` in the world's frame. `angle` is the axis times radians. Exact to
  // second order, and normalized.
  friend OBBY_DEVICE QuatT turned(QuatT q, Vec3T<F> angle) {
    const Vec3T<F> h = angle * F(0.5f);
    const QuatT d = QuatT{h.x, h.y, h.z, 1.0f - 0.5f * dot(h, h)} * q;
    return normalize(d);
  }
};

using Quat = QuatT<float>;

// Position and rotation of a body: world = rotation * local + position.
template <class F>
struct PoseT {
  Vec3T<F> position;
  Mat3T<F> rotation;

  friend OBBY_DEVICE Vec3T<F> toWorld(const PoseT& p, Vec3T<F> local) {
    return p.rotation * local + p.position;
  }
  friend OBBY_DEVICE Vec3T<F> toLocal(const PoseT& p, Vec3T<F> world) {
    return toLocal(p.rotation, world - p.position);
  }
};

using Pose = PoseT<float>;

// An axis-aligned box that includes its surface: boxes that touch overlap. lo <= hi.
template <class F>
struct BoxT {
  Vec3T<F> lo, hi;

  friend OBBY_DEVICE MaskOf<F> overlaps(const BoxT& a, const BoxT& b) {
    return (a.lo.x <= b.hi.x) & (b.lo.x <= a.hi.x) & (a.lo.y <= b.hi.y) & (b.lo.y <= a.hi.y) &
           (a.lo.z <= b.hi.z) & (b.lo.z <= a.hi.z);
  }
  friend OBBY_DEVICE BoxT join(const BoxT& a, const BoxT& b) {
    return {min(a.lo, b.lo), max(a.hi, b.hi)};
  }
  friend OBBY_DEVICE BoxT grow(const BoxT& a, Vec3T<F> by) { return {a.lo - by, a.hi + by}; }
};

using Box = BoxT<float>;

// Returns the world box of an oriented box with half extents `half`.
template <class F>
OBBY_DEVICE BoxT<F> boundsOf(const PoseT<F>& p, Vec3T<F> half) {
  const Vec3T<F> e =
      abs(p.rotation.x) * half.x + abs(p.rotation.y) * half.y + abs(p.rotation.z) * half.z;
  return {p.position - e, p.position + e};
}

}  // namespace obby
