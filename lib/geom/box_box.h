// Penetration of the player's box and a block, the pair in nearly all contacts. It tests the
// separating axes of geom/penetration.h and shares the products between axes. tests/geom compares
// both forms.
#pragma once

#include "geom/contact.h"

namespace obby::geom {

namespace internal {

// Returns the i-th component.
template <class F>
OBBY_DEVICE const F& at(const Vec3T<F>& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

// Tests a unit axis. `apart` is the signed distance of the centres along it, `radii` the sum of
// both extents. Returns false for a separated lane, whose contact is meaningless from then on.
template <class F>
OBBY_DEVICE MaskOf<F> keepMin(ContactT<F>& best, F apart, F radii, Vec3T<F> axis) {
  const F depth = radii - absf(apart);
  const MaskOf<F> less = depth < best.depth;
  best.depth = select(less, depth, best.depth);
  best.normal = select(less, select(apart < 0.0f, -axis, axis), best.normal);
  return best.depth >= 0.0f;
}

// A contact along an axis that is not normalized yet. Depth and normal are scaled by its length.
template <class F>
struct ScaledContact {
  ContactT<F> contact;
  F length2;
};

// Tests the cross product of shape axis i, a unit axis of the local frame, and body axis j. The
// product is perpendicular to both, so only the two other axes of each shape count. Depths are
// compared as fractions, so that one division is enough for all axes.
template <int i, int j, class F>
OBBY_DEVICE void keepCross(ScaledContact<F>& best, const LocalBoxT<F>& box, Vec3T<F> half) {
  const Vec3T<F>* const axes[3] = {&box.axes.x, &box.axes.y, &box.axes.z};
  constexpr int u = i == 0 ? 1 : 0, v = i == 2 ? 1 : 2, k = j == 0 ? 1 : 0, l = j == 2 ? 1 : 2;
  const Vec3T<F>& r = *axes[j];
  // The cross product is (0, -z, y), (z, 0, -x) or (-y, x, 0).
  const F a = i == 1 ? at(r, v) : -at(r, v), b = i == 1 ? -at(r, u) : at(r, u);
  const F n2 = a * a + b * b;
  const auto along = [&](const Vec3T<F>& w) { return at(w, u) * a + at(w, v) * b; };
  const F radii =
      absf(a) * at(half, u) + absf(b) * at(half, v) +
      (absf(along(*axes[k])) * at(box.half, k) + absf(along(*axes[l])) * at(box.half, l));
  const F apart = along(box.center);
  const F depth = radii - absf(apart), min = best.contact.depth;
  // Otherwise the edges are parallel, and the faces cover that case.
  const MaskOf<F> counts = n2 >= 1e-6f;
  const MaskOf<F> less =
      counts & ((depth < 0.0f) | (depth * depth * best.length2 < min * min * n2));
  // The depth of a lane that is already separated stays below 0.
  const MaskOf<F> take = less & (min >= 0.0f);
  best.contact.depth = select(take, depth, min);
  const F zero = 0.0f, x = select(apart < 0.0f, -a, a), y = select(apart < 0.0f, -b, b);
  const Vec3T<F> n = i == 0   ? Vec3T<F>{zero, x, y}
                     : i == 1 ? Vec3T<F>{x, zero, y}
                              : Vec3T<F>{x, y, zero};
  best.contact.normal = select(take, n, best.contact.normal);
  best.length2 = select(take, n2, best.length2);
}

// Tests shape axis i with all body axes. Returns false if every lane is separated.
template <int i, class F>
OBBY_DEVICE bool keepCrosses(ScaledContact<F>& best, const LocalBoxT<F>& box, Vec3T<F> half) {
  keepCross<i, 0>(best, box, half);
  keepCross<i, 1>(best, box, half);
  keepCross<i, 2>(best, box, half);
  return any(best.contact.depth >= 0.0f);
}

}  // namespace internal

// `box` is in the block's frame, and so is the normal. Returns early once every lane is separated.
template <class F>
OBBY_DEVICE ContactT<F> boxBlock(Vec3T<F> half, const LocalBoxT<F>& box) {
  using internal::keepMin;
  const Vec3T<F> ax = abs(box.axes.x), ay = abs(box.axes.y), az = abs(box.axes.z);
  const Vec3T<F> reach = half + ax * box.half.x + ay * box.half.y + az * box.half.z;
  ContactT<F> best{1e30f, {0, 1, 0}};
  if (!any(keepMin<F>(best, box.center.x, reach.x, {1, 0, 0}))) return best;
  if (!any(keepMin<F>(best, box.center.y, reach.y, {0, 1, 0}))) return best;
  if (!any(keepMin<F>(best, box.center.z, reach.z, {0, 0, 1}))) return best;
  const Vec3T<F>* const axes[3] = {&box.axes.x, &box.axes.y, &box.axes.z};
  const F halves[3] = {box.half.x + dot(ax, half), box.half.y + dot(ay, half),
                       box.half.z + dot(az, half)};
  for (int j = 0; j < 3; ++j) {
    if (!any(keepMin<F>(best, dot(box.center, *axes[j]), halves[j], *axes[j]))) return best;
  }
  internal::ScaledContact<F> scaled{best, 1.0f};
  const bool meet = internal::keepCrosses<0>(scaled, box, half) &&
                    internal::keepCrosses<1>(scaled, box, half) &&
                    internal::keepCrosses<2>(scaled, box, half);
  if (!meet) return scaled.contact;
  const F inverse = 1.0f / sqrtf32(scaled.length2);  // scaled.length2 is 1 if a face is best
  return {scaled.contact.depth * inverse, scaled.contact.normal * inverse};
}

// Tests two upright boxes, for which five axes suffice. `block` and the normal are in world space.
template <class F>
OBBY_DEVICE ContactT<F> boxUprightBlock(const BlockT<F>& block, const UprightBoxT<F>& box) {
  using internal::keepMin;
  const Vec3T<F> d = box.center - block.pose.position, half = block.half;
  const Vec3T<F> sx = block.pose.rotation.x, sz = block.pose.rotation.z;
  const Vec3T<F> bx{box.yaw.cos, 0, -box.yaw.sin}, bz{box.yaw.sin, 0, box.yaw.cos};
  const F c = absf(sx.x * bx.x + sx.z * bx.z), s = absf(sx.x * bz.x + sx.z * bz.z);
  ContactT<F> best{1e30f, {0, 1, 0}};
  if (!any(keepMin<F>(best, d.y, half.y + box.half.y, {0, 1, 0}))) return best;
  const F x = d.x * sx.x + d.z * sx.z, z = d.x * sz.x + d.z * sz.z;
  if (!any(keepMin<F>(best, x, half.x + c * box.half.x + s * box.half.z, sx))) return best;
  if (!any(keepMin<F>(best, z, half.z + s * box.half.x + c * box.half.z, sz))) return best;
  const F bodyX = d.x * bx.x + d.z * bx.z, bodyZ = d.x * bz.x + d.z * bz.z;
  if (!any(keepMin<F>(best, bodyX, box.half.x + c * half.x + s * half.z, bx))) return best;
  keepMin<F>(best, bodyZ, box.half.z + s * half.x + c * half.z, bz);
  return best;
}

// Tests a block with any rotation. The normal is in world space.
template <class F>
OBBY_DEVICE ContactT<F> boxTiltedBlock(const BlockT<F>& block, const UprightBoxT<F>& box) {
  const Mat3T<F> axes = box.axes();
  const Mat3T<F>& r = block.pose.rotation;
  const LocalBoxT<F> local{toLocal(block.pose, box.center),
                           {toLocal(r, axes.x), toLocal(r, axes.y), toLocal(r, axes.z)},
                           box.half};
  ContactT<F> contact = boxBlock<F>(block.half, local);
  contact.normal = r * contact.normal;
  return contact;
}

}  // namespace obby::geom
