// A cylinder along local X. Its diameter is the smaller of the two other extents.
#pragma once

#include "geom/shape.h"

namespace obby::geom {

struct Cylinder {
  OBBY_DEVICE static float radius(const ShapeData& s) { return minf(s.half.y, s.half.z); }
  OBBY_DEVICE static float support(const ShapeData& s, Vec3 d) {
    return absf(d.x) * s.half.x + radius(s) * sqrtf32(d.y * d.y + d.z * d.z);
  }
  OBBY_DEVICE static int axes(const ShapeData&) { return 1; }
  OBBY_DEVICE static Vec3 axis(const ShapeData&, int) { return {1, 0, 0}; }
  OBBY_DEVICE static int edges(const ShapeData&) { return 1; }
  OBBY_DEVICE static Vec3 edge(const ShapeData&, int) { return {1, 0, 0}; }

  OBBY_DEVICE static Vec3 closestPointOf(const ShapeData& s, Vec3 p) {
    const float r2 = p.y * p.y + p.z * p.z, r = radius(s);
    const float scale = r2 > r * r ? r / sqrtf32(r2) : 1.0f;
    return {clampf(p.x, -s.half.x, s.half.x), p.y * scale, p.z * scale};
  }

  // Alternates projections between the two convex sets. If they are apart, returns the direction
  // from the cylinder to the box, which also covers the rims. If they overlap, returns the radial
  // direction between the axis and the box.
  OBBY_DEVICE static Vec3 roundAxis(const ShapeData& s, const LocalBox& box) {
    Vec3 inside = closestPointOf(s, box.center), onBox{};
    for (int i = 0; i < 8; ++i) {
      onBox = closestPoint(box, inside);
      inside = closestPointOf(s, onBox);
    }
    const Vec3 apart = normalize(onBox - inside);
    const float nearest = dot(box.center, apart) - dot(abs(toLocal(box.axes, apart)), box.half);
    if (nearest > support(s, apart)) return apart;
    Vec3 onAxis{clampf(box.center.x, -s.half.x, s.half.x), 0, 0};
    for (int i = 0; i < 4; ++i) {
      onBox = closestPoint(box, onAxis);
      onAxis.x = clampf(onBox.x, -s.half.x, s.half.x);
    }
    return {0, onBox.y, onBox.z};
  }

  OBBY_DEVICE static Vec3 corner(const ShapeData& s, Vec3 d) {
    const Vec3 side = normalize(Vec3{0, d.y, d.z}, {0, 0, 0}) * radius(s);
    return {d.x < 0 ? -s.half.x : s.half.x, side.y, side.z};
  }
  // Writes a cap as an octagon with a corner toward `d`, or the line along the side.
  OBBY_DEVICE static int feature(const ShapeData& s, Vec3 d, Vec3* out) {
    const float r = radius(s);
    if (d.x * d.x < d.y * d.y + d.z * d.z) {
      const Vec3 side = normalize(Vec3{0, d.y, d.z}) * r;
      out[0] = {-s.half.x, side.y, side.z};
      out[1] = {s.half.x, side.y, side.z};
      return 2;
    }
    const float x = d.x < 0 ? -s.half.x : s.half.x;
    Vec3 at = normalize(Vec3{0, d.y, d.z}, {0, 1, 0}) * r;
    for (int i = 0; i < 8; ++i) {
      out[i] = {x, at.y, at.z};
      at = Vec3{0, at.y - at.z, at.y + at.z} * 0.70710678f;  // the next eighth of a turn
    }
    return 8;
  }

  OBBY_DEVICE static bool castRay(const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
    const float r = radius(s);
    float enter = -1e30f, leave = 1e30f;
    Vec3 normal;
    clipToPlane({1, 0, 0}, s.half.x, o, d, enter, leave, normal);
    clipToPlane({-1, 0, 0}, s.half.x, o, d, enter, leave, normal);
    const float a = d.y * d.y + d.z * d.z, b = o.y * d.y + o.z * d.z,
                c = o.y * o.y + o.z * o.z - r * r;
    if (a < 1e-12f) {
      if (c > 0) return false;  // the ray is parallel to the axis and outside
    } else {
      const float q = b * b - a * c;
      if (q < 0) return false;
      const float root = sqrtf32(q), t0 = (-b - root) / a;
      if (t0 > enter) {
        enter = t0;
        normal = normalize(Vec3{0, o.y + d.y * t0, o.z + d.z * t0});
      }
      leave = minf(leave, (-b + root) / a);
    }
    if (enter < 0 || enter > leave || enter > tMax) return false;
    hit = {enter, normal};
    return true;
  }
};

}  // namespace obby::geom
