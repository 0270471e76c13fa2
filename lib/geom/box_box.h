// Penetration of the player's box and a block: the separating axes of geom/penetration.h for the
// pair that nearly all contacts are, with the products shared between axes. tests/geom holds both
// forms together.
#pragma once

#include "geom/contact.h"

namespace obby::geom {

namespace internal {

// Overlap along a unit axis: `apart` is the signed distance of the centres along it, `radii` the
// sum of both extents. False: separated.
OBBY_DEVICE bool keepLeast(Contact& best, float apart, float radii, Vec3 axis) {
  const float depth = radii - absf(apart);
  if (depth < best.depth) best = {depth, apart < 0 ? -axis : axis};
  return best.depth >= 0;
}

// The cross product of shape axis i (a unit axis of the local frame) and the body axis `r`, with
// index j in the body.
OBBY_DEVICE bool keepCross(Contact& best, const LocalBox& box, Vec3 half, int i, int j) {
  const Vec3 r = j == 0 ? box.axes.x : j == 1 ? box.axes.y : box.axes.z;
  const Vec3 n = i == 0 ? Vec3{0, -r.z, r.y} : i == 1 ? Vec3{r.z, 0, -r.x} : Vec3{-r.y, r.x, 0};
  const float n2 = dot(n, n);
  if (n2 < 1e-6f) return true;  // parallel: covered by the faces
  const float radii = dot(abs(n), half) + dot(abs(toLocal(box.axes, n)), box.half);
  const float apart = dot(n, box.center);
  if (absf(apart) > radii) {
    best = {-1, n};
    return false;
  }
  // Compare depths without dividing where the axis cannot win.
  const float limit = best.depth;
  const float depth = radii - absf(apart);
  if (depth * depth >= limit * limit * n2) return true;
  const float inverse = 1.0f / sqrtf32(n2);
  return keepLeast(best, apart * inverse, radii * inverse, n * inverse);
}

}  // namespace internal

// `box` in the block's frame. The normal is local.
OBBY_DEVICE Contact boxBlock(Vec3 half, const LocalBox& box) {
  using internal::keepCross;
  using internal::keepLeast;
  const Vec3 ax = abs(box.axes.x), ay = abs(box.axes.y), az = abs(box.axes.z);
  const Vec3 reach = half + ax * box.half.x + ay * box.half.y + az * box.half.z;
  Contact best{1e30f, {0, 1, 0}};
  if (!keepLeast(best, box.center.x, reach.x, {1, 0, 0})) return best;
  if (!keepLeast(best, box.center.y, reach.y, {0, 1, 0})) return best;
  if (!keepLeast(best, box.center.z, reach.z, {0, 0, 1})) return best;
  if (!keepLeast(best, dot(box.center, box.axes.x), box.half.x + dot(ax, half), box.axes.x))
    return best;
  if (!keepLeast(best, dot(box.center, box.axes.y), box.half.y + dot(ay, half), box.axes.y))
    return best;
  if (!keepLeast(best, dot(box.center, box.axes.z), box.half.z + dot(az, half), box.axes.z))
    return best;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!keepCross(best, box, half, i, j)) return best;
    }
  }
  return best;
}

// Both upright: five axes are all there are. `pose` of the block; the normal is in the world.
OBBY_DEVICE Contact boxUprightBlock(const Pose& pose, Vec3 half, const UprightBox& box) {
  using internal::keepLeast;
  const Vec3 d = box.center - pose.position;
  const Vec3 sx = pose.rotation.x, sz = pose.rotation.z;
  const Vec3 bx{box.yaw.cos, 0, -box.yaw.sin}, bz{box.yaw.sin, 0, box.yaw.cos};
  const float c = absf(sx.x * bx.x + sx.z * bx.z), s = absf(sx.x * bz.x + sx.z * bz.z);
  Contact best{1e30f, {0, 1, 0}};
  if (!keepLeast(best, d.y, half.y + box.half.y, {0, 1, 0})) return best;
  const float x = d.x * sx.x + d.z * sx.z, z = d.x * sz.x + d.z * sz.z;
  if (!keepLeast(best, x, half.x + c * box.half.x + s * box.half.z, sx)) return best;
  if (!keepLeast(best, z, half.z + s * box.half.x + c * box.half.z, sz)) return best;
  const float bodyX = d.x * bx.x + d.z * bx.z, bodyZ = d.x * bz.x + d.z * bz.z;
  if (!keepLeast(best, bodyX, box.half.x + c * half.x + s * half.z, bx)) return best;
  keepLeast(best, bodyZ, box.half.z + s * half.x + c * half.z, bz);
  return best;
}

}  // namespace obby::geom
