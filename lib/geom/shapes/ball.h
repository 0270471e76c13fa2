// A sphere whose diameter is the smallest extent.
#pragma once

#include "geom/shape.h"

namespace obby::geom {

struct Ball {
  OBBY_DEVICE static float radius(const ShapeData& s) {
    return minf(s.half.x, minf(s.half.y, s.half.z));
  }
  OBBY_DEVICE static float support(const ShapeData& s, Vec3 d) { return radius(s) * length(d); }
  OBBY_DEVICE static int axes(const ShapeData&) { return 0; }
  OBBY_DEVICE static Vec3 axis(const ShapeData&, int) { return {}; }
  OBBY_DEVICE static int edges(const ShapeData&) { return 0; }
  OBBY_DEVICE static Vec3 edge(const ShapeData&, int) { return {}; }
  // Only the direction from the centre to the closest point of the box can separate them.
  OBBY_DEVICE static Vec3 roundAxis(const ShapeData&, const LocalBox& box) {
    return closestPoint(box, {});
  }

  OBBY_DEVICE static Vec3 corner(const ShapeData& s, Vec3 d) { return normalize(d) * radius(s); }
  OBBY_DEVICE static int feature(const ShapeData& s, Vec3 d, Vec3* out) {
    out[0] = corner(s, d);
    return 1;
  }

  OBBY_DEVICE static bool castRay(const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
    const float r = radius(s);
    const float a = dot(d, d), b = dot(o, d), c = dot(o, o) - r * r;
    const float q = b * b - a * c;
    if (c < 0 || q < 0 || b > 0) return false;  // the ray starts inside, misses, or points away
    const float t = (-b - sqrtf32(q)) / a;
    if (t > tMax) return false;
    hit.t = maxf(t, 0.0f);
    hit.normal = normalize(o + d * t);
    return true;
  }
};

}  // namespace obby::geom
