// Oriented boxes of a query. A player is inside a region if the vertical line from the feet to the
// top of the head meets it. The test ignores facing, is generous with height, and is exact
// sideways.
#pragma once

#include "math/vec.h"

namespace obby::geom {

struct Region {
  Pose pose;  // centre and axes
  Vec3 half;  // half extents, studs
};

// Returns true if the segment a..b meets the region or its surface. a and b may be equal.
OBBY_DEVICE bool meets(const Region& region, Vec3 a, Vec3 b) {
  const Vec3 o = toLocal(region.pose, a), d = toLocal(region.pose.rotation, b - a);
  float enter = 0, leave = 1;
  for (int i = 0; i < 3; ++i) {
    const float oi = component(o, i), di = component(d, i), h = component(region.half, i);
    if (absf(di) < 1e-9f) {
      if (absf(oi) > h) return false;
      continue;
    }
    const float inv = 1.0f / di, t0 = (-h - oi) * inv, t1 = (h - oi) * inv;
    enter = maxf(enter, minf(t0, t1));
    leave = minf(leave, maxf(t0, t1));
  }
  return enter <= leave;
}

// Returns true if the segment a..b meets the region anywhere while it moves by `shift`. The segment
// sweeps a parallelogram. Unless it meets the box, one of ten axes separates the two: the box's
// three, the parallelogram's normal, and the cross products of edges.
OBBY_DEVICE bool meetsAlong(const Region& region, Vec3 a, Vec3 b, Vec3 shift) {
  const Vec3 u = toLocal(region.pose.rotation, (b - a) * 0.5f);
  const Vec3 v = toLocal(region.pose.rotation, shift * 0.5f);
  const Vec3 middle = toLocal(region.pose, a) + u + v;
  const auto apart = [&](Vec3 along) {
    return absf(dot(middle, along)) >
           absf(dot(u, along)) + absf(dot(v, along)) + dot(region.half, abs(along));
  };
  const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec3& axis : axes) {
    if (apart(axis) || apart(cross(u, axis)) || apart(cross(v, axis))) return false;
  }
  return !apart(cross(u, v));
}

// Returns the distance from a point to the region, studs; 0 inside.
OBBY_DEVICE float distance(const Region& region, Vec3 p) {
  const Vec3 d = abs(toLocal(region.pose, p)) - region.half;
  return length(max(d, Vec3{0, 0, 0}));
}

}  // namespace obby::geom
