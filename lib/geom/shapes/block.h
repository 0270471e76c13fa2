// Box; also the shape of a truss.
#pragma once

#include "geom/shape.h"

namespace obby::geom {

OBBY_DEVICE Vec3 unitAxis(int i) {
  return {i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f};
}

// The size of `half` with the signs of `d`.
OBBY_DEVICE Vec3 withSigns(Vec3 half, Vec3 d) {
  return {d.x < 0 ? -half.x : half.x, d.y < 0 ? -half.y : half.y, d.z < 0 ? -half.z : half.z};
}

struct Block {
  OBBY_DEVICE static float support(const ShapeData& s, Vec3 d) { return dot(abs(d), s.half); }
  OBBY_DEVICE static int axes(const ShapeData&) { return 3; }
  OBBY_DEVICE static Vec3 axis(const ShapeData&, int i) { return unitAxis(i); }
  OBBY_DEVICE static int edges(const ShapeData&) { return 3; }
  OBBY_DEVICE static Vec3 edge(const ShapeData&, int i) { return unitAxis(i); }
  OBBY_DEVICE static Vec3 roundAxis(const ShapeData&, const LocalBox&) { return {}; }

  OBBY_DEVICE static Vec3 corner(const ShapeData& s, Vec3 d) { return withSigns(s.half, d); }
  OBBY_DEVICE static int feature(const ShapeData& s, Vec3 d, Vec3* out) {
    const Vec3 size = abs(d);
    const int i = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const Vec3 a = mul(unitAxis((i + 1) % 3), s.half), b = mul(unitAxis((i + 2) % 3), s.half);
    const Vec3 face = mul(unitAxis(i), s.half) * (component(d, i) < 0 ? -1.0f : 1.0f);
    out[0] = face + a + b, out[1] = face - a + b, out[2] = face - a - b, out[3] = face + a - b;
    return 4;
  }

  OBBY_DEVICE static bool castRay(const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
    float enter = -1e30f, leave = 1e30f;
    int axisIndex = 0;
    for (int i = 0; i < 3; ++i) {
      const float di = awayFromZero(component(d, i)), inv = 1.0f / di;
      const float a = (-component(s.half, i) - component(o, i)) * inv;
      const float b = (component(s.half, i) - component(o, i)) * inv;
      const float nearT = minf(a, b);
      if (nearT > enter) {
        enter = nearT;
        axisIndex = i;
      }
      leave = minf(leave, maxf(a, b));
    }
    if (enter < 0 || enter > leave || enter > tMax) return false;
    hit.t = enter;
    hit.normal = unitAxis(axisIndex) * (component(d, axisIndex) < 0 ? 1.0f : -1.0f);
    return true;
  }
};

}  // namespace obby::geom
