// Intersections of parts with vertical lines, from which the policy sees heights. The templates
// take a number type (math/lanes.h), with a line in each lane.
#pragma once

#include "geom/shapes/ball.h"
#include "geom/shapes/cylinder.h"
#include "math/lanes.h"

namespace obby::policy {

// A part that vertical lines cut. Shapes other than wedges, cylinders and balls are cut as their
// box.
struct Solid {
  Vec3 center;  // relative to the feet
  Mat3 axes;
  geom::ShapeData shape;
  geom::ShapeKind kind = geom::ShapeKind::block;
};

// The interval of a vertical line that is in a solid, heights from the feet; empty if bottom > top.
template <class F>
struct Stretch {
  F bottom = F(-1e9f), top = F(1e9f);

  OBBY_DEVICE void clip(F from, F to) {
    bottom = maxf(bottom, from);
    top = minf(top, to);
  }
};

// Clips to -half <= dot(axis, o + (0, y, 0)) <= half. `oy` is o.y, which is equal in every lane.
template <class F>
OBBY_DEVICE void clipToSlab(const Vec3T<F>& o, float oy, Vec3 axis, float half, Stretch<F>& s) {
  const float inverse = 1.0f / geom::awayFromZero(axis.y);
  if (axis.x == 0 && axis.z == 0) {  // most parts are upright, with one result for all lanes
    const float at = oy * axis.y;
    const float a = (-half - at) * inverse, b = (half - at) * inverse;
    s.clip(F(minf(a, b)), F(maxf(a, b)));
    return;
  }
  const F at = (o.x * axis.x + o.y * axis.y) + o.z * axis.z;
  const F a = (-half - at) * inverse, b = (half - at) * inverse;
  s.clip(minf(a, b), maxf(a, b));
}

// Clips to the points within `radius` of the line through the origin along the unit vector `axis`,
// or of the origin if the axis is zero.
template <class F>
OBBY_DEVICE void clipToRound(const Vec3T<F>& o, Vec3 axis, float radius, Stretch<F>& s) {
  const F along = (o.x * axis.x + o.y * axis.y) + o.z * axis.z;
  const F x = o.x - along * axis.x, y = o.y - along * axis.y, z = o.z - along * axis.z;
  // Solves a h^2 + 2 y h + c <= 0.
  const float a = maxf(1 - axis.y * axis.y, 1e-6f), inverse = 1.0f / a;
  const F c = ((x * x + y * y) + z * z) - radius * radius;
  const F square = y * y - a * c;
  const F half = sqrtf32(maxf(square, F(0))) * inverse, middle = -y * inverse;
  const MaskOf<F> met = square >= 0.0f;
  s.clip(select(met, middle - half, F(1e9f)), select(met, middle + half, F(-1e9f)));
}

// Clips to a wedge's slope: local y * half.z <= z * half.y.
template <class F>
OBBY_DEVICE void clipToSlope(const Vec3T<F>& o, const Solid& solid, Stretch<F>& s) {
  const Vec3 normal = solid.axes.y * solid.shape.half.z - solid.axes.z * solid.shape.half.y;
  const F at =
      -((o.x * normal.x + o.y * normal.y) + o.z * normal.z) * (1.0f / geom::awayFromZero(normal.y));
  if (normal.y > 0) {
    s.top = minf(s.top, at);
  } else {
    s.bottom = maxf(s.bottom, at);
  }
}

// Returns the interval of the vertical line through (x, z) that is in the solid.
template <class F>
OBBY_DEVICE Stretch<F> cut(const Solid& solid, F x, F z) {
  const float oy = -solid.center.y;
  const Vec3T<F> o{x - solid.center.x, F(oy), z - solid.center.z};
  const Mat3& axes = solid.axes;
  const Vec3 half = solid.shape.half;
  Stretch<F> s;
  if (solid.kind == geom::ShapeKind::ball) {
    clipToRound<F>(o, {}, geom::Ball::radius(solid.shape), s);
    return s;
  }
  clipToSlab<F>(o, oy, axes.x, half.x, s);
  if (solid.kind == geom::ShapeKind::cylinder) {
    clipToRound<F>(o, axes.x, geom::Cylinder::radius(solid.shape), s);
    return s;
  }
  clipToSlab<F>(o, oy, axes.y, half.y, s);
  clipToSlab<F>(o, oy, axes.z, half.z, s);
  if (solid.kind == geom::ShapeKind::wedge) clipToSlope<F>(o, solid, s);
  return s;
}

}  // namespace obby::policy
