// A wedge: a full rectangle at the bottom, a vertical face at +Z, and a slope that rises from -Z to
// +Z (docs/parts.md, shapes).
#pragma once

#include "geom/shapes/block.h"

namespace obby::geom {

struct Wedge {
  OBBY_DEVICE static Vec3 slope(const ShapeData& s) {
    return normalize(Vec3{0, s.half.z, -s.half.y});
  }

  OBBY_DEVICE static float support(const ShapeData& s, Vec3 d) {
    const float bottom = -d.y * s.half.y + absf(d.z) * s.half.z;
    const float top = d.y * s.half.y + d.z * s.half.z;
    return absf(d.x) * s.half.x + maxf(bottom, top);
  }
  OBBY_DEVICE static int axes(const ShapeData&) { return 4; }
  OBBY_DEVICE static Vec3 axis(const ShapeData& s, int i) { return i < 3 ? unitAxis(i) : slope(s); }
  OBBY_DEVICE static int edges(const ShapeData&) { return 4; }
  OBBY_DEVICE static Vec3 edge(const ShapeData& s, int i) {
    return i < 3 ? unitAxis(i) : normalize(Vec3{0, s.half.y, s.half.z});
  }
  OBBY_DEVICE static Vec3 roundAxis(const ShapeData&, const LocalBox&) { return {}; }

  OBBY_DEVICE static Vec3 corner(const ShapeData& s, Vec3 d) {
    const Vec3 low = withSigns(s.half, {d.x, -1, d.z}), top = withSigns(s.half, {d.x, 1, 1});
    return dot(d, low) > dot(d, top) ? low : top;
  }
  OBBY_DEVICE static int feature(const ShapeData& s, Vec3 d, Vec3* out) {
    const Vec3 h = s.half;
    const float x = d.x < 0 ? -h.x : h.x;
    const float side = absf(d.x), rise = dot(d, slope(s));
    if (side >= rise && side >= d.z && side >= -d.y) {
      out[0] = {x, -h.y, -h.z}, out[1] = {x, -h.y, h.z}, out[2] = {x, h.y, h.z};
      return 3;
    }
    // Two of three parallel edges bound a face: the foot of the slope, the foot of the back, and
    // the top.
    const bool isSlope = rise >= d.z && rise >= -d.y, isBack = !isSlope && d.z >= -d.y;
    const Vec3 a = isBack ? Vec3{h.x, -h.y, h.z} : Vec3{h.x, -h.y, -h.z};
    const Vec3 b = isSlope || isBack ? Vec3{h.x, h.y, h.z} : Vec3{h.x, -h.y, h.z};
    out[0] = a, out[1] = b, out[2] = {-b.x, b.y, b.z}, out[3] = {-a.x, a.y, a.z};
    return 4;
  }

  OBBY_DEVICE static bool castRay(const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
    float enter = -1e30f, leave = 1e30f;
    Vec3 normal;
    clipToPlane({1, 0, 0}, s.half.x, o, d, enter, leave, normal);
    clipToPlane({-1, 0, 0}, s.half.x, o, d, enter, leave, normal);
    clipToPlane({0, -1, 0}, s.half.y, o, d, enter, leave, normal);
    clipToPlane({0, 0, 1}, s.half.z, o, d, enter, leave, normal);
    clipToPlane(slope(s), 0, o, d, enter, leave, normal);
    if (enter < 0 || enter > leave || enter > tMax) return false;
    hit = {enter, normal};
    return true;
  }
};

}  // namespace obby::geom
