// A corner wedge: its base is a rectangle and its apex is at (+X, +Y, -Z). The faces at +X and -Z
// are vertical, and the slopes fall toward -X and +Z.
#pragma once

#include "geom/shapes/block.h"

namespace obby::geom {

struct CornerWedge {
  // Returns the normal of the slope toward -X (i = 0) or +Z (i = 1). Both pass through the apex.
  OBBY_DEVICE static Vec3 slope(const ShapeData& s, int i) {
    return i == 0 ? normalize(Vec3{-s.half.y, s.half.x, 0})
                  : normalize(Vec3{0, s.half.z, s.half.y});
  }

  OBBY_DEVICE static float support(const ShapeData& s, Vec3 d) {
    const float bottom = absf(d.x) * s.half.x + absf(d.z) * s.half.z - d.y * s.half.y;
    const float apex = d.x * s.half.x + d.y * s.half.y - d.z * s.half.z;
    return maxf(bottom, apex);
  }
  OBBY_DEVICE static int axes(const ShapeData&) { return 5; }
  OBBY_DEVICE static Vec3 axis(const ShapeData& s, int i) {
    return i < 3 ? unitAxis(i) : slope(s, i - 3);
  }
  // Edges along X, Z and Y, and from the apex to the two near corners and the far corner of the
  // base.
  OBBY_DEVICE static int edges(const ShapeData&) { return 6; }
  OBBY_DEVICE static Vec3 edge(const ShapeData& s, int i) {
    if (i < 3) return unitAxis(i);
    if (i == 3) return normalize(Vec3{s.half.x, s.half.y, 0});
    if (i == 4) return normalize(Vec3{0, s.half.y, -s.half.z});
    return normalize(Vec3{s.half.x, s.half.y, -s.half.z});
  }
  OBBY_DEVICE static Vec3 roundAxis(const ShapeData&, const LocalBox&) { return {}; }

  OBBY_DEVICE static Vec3 corner(const ShapeData& s, Vec3 d) {
    const Vec3 low = withSigns(s.half, {d.x, -1, d.z}), apex{s.half.x, s.half.y, -s.half.z};
    return dot(d, low) > dot(d, apex) ? low : apex;
  }
  OBBY_DEVICE static int feature(const ShapeData& s, Vec3 d, Vec3* out) {
    const Vec3 h = s.half;
    const float toX = dot(d, slope(s, 0)), toZ = dot(d, slope(s, 1));
    const float best = maxf(maxf(maxf(toX, toZ), maxf(d.x, -d.z)), -d.y);
    if (-d.y == best) {
      out[0] = {h.x, -h.y, h.z}, out[1] = {-h.x, -h.y, h.z};
      out[2] = {-h.x, -h.y, -h.z}, out[3] = {h.x, -h.y, -h.z};
      return 4;
    }
    // The face is a triangle: one side of the base, and the apex.
    const bool alongZ = toX == best || d.x == best;
    const float x = toX == best ? -h.x : h.x, z = toZ == best ? h.z : -h.z;
    out[0] = alongZ ? Vec3{x, -h.y, -h.z} : Vec3{-h.x, -h.y, z};
    out[1] = alongZ ? Vec3{x, -h.y, h.z} : Vec3{h.x, -h.y, z};
    out[2] = {h.x, h.y, -h.z};
    return 3;
  }

  OBBY_DEVICE static bool castRay(const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
    float enter = -1e30f, leave = 1e30f;
    Vec3 normal;
    clipToPlane({1, 0, 0}, s.half.x, o, d, enter, leave, normal);
    clipToPlane({0, 0, -1}, s.half.z, o, d, enter, leave, normal);
    clipToPlane({0, -1, 0}, s.half.y, o, d, enter, leave, normal);
    clipToPlane(slope(s, 0), 0, o, d, enter, leave, normal);
    clipToPlane(slope(s, 1), 0, o, d, enter, leave, normal);
    if (enter < 0 || enter > leave || enter > tMax) return false;
    hit = {enter, normal};
    return true;
  }
};

}  // namespace obby::geom
