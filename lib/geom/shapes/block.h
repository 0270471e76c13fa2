// A box, which is also the shape of a truss.
#pragma once

#include "geom/shape.h"

namespace obby::geom {

OBBY_DEVICE Vec3 unitAxis(int i) {
  return {i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f};
}

// Returns `half` with the signs of `d`.
template <class F>
OBBY_DEVICE Vec3T<F> withSigns(Vec3T<F> half, Vec3T<F> d) {
  return {select(d.x < 0.0f, -half.x, half.x), select(d.y < 0.0f, -half.y, half.y),
          select(d.z < 0.0f, -half.z, half.z)};
}

// Writes the four corners of the block's face that looks along `d`, in local coordinates.
template <class F>
OBBY_DEVICE void blockFace(Vec3T<F> half, Vec3T<F> d, Vec3T<F>* out) {
  const Vec3T<F> size = abs(d), far = withSigns(half, d);
  const MaskOf<F> isX = (size.x >= size.y) & (size.x >= size.z), isY = size.y >= size.z;
  for (int k = 0; k < 4; ++k) {
    // Signs along the two axes after the face's normal axis, in cyclic order.
    const F a = k == 0 || k == 3 ? 1.0f : -1.0f, b = k < 2 ? 1.0f : -1.0f;
    const Vec3T<F> x{far.x, half.y * a, half.z * b}, y{half.x * b, far.y, half.z * a},
        z{half.x * a, half.y * b, far.z};
    out[k] = select(isX, x, select(isY, y, z));
  }
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
    blockFace(s.half, d, out);
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
