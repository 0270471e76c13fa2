// Depth of an upright box (the player's body) in a shape, and the direction that separates them.
// The separating axes are the face normals of both, the cross products of their edges, and the
// closest approach of curved faces.
#pragma once

#include "geom/box_box.h"
#include "geom/contact.h"
#include "geom/shapes/table.h"

namespace obby::geom {

namespace internal {

// Tests the unit vector `n` as a separating axis in the shape's frame. Keeps the smallest overlap
// in `best`. Returns false if the axis separates box and shape.
template <class Shape>
OBBY_DEVICE bool testAxis(const ShapeData& shape, const LocalBox& box, Vec3 n, Contact& best) {
  const float c = dot(box.center, n);
  const float r = dot(abs(toLocal(box.axes, n)), box.half);
  const float up = Shape::support(shape, n) - (c - r);     // move the box along +n
  const float down = (c + r) + Shape::support(shape, -n);  // move the box along -n
  if (up < best.depth) best = {up, n};
  if (down < best.depth) best = {down, -n};
  return best.depth >= 0;
}

template <class Shape>
OBBY_DEVICE bool testCrossAxis(const ShapeData& shape, const LocalBox& box, Vec3 a, Vec3 b,
                               Contact& best) {
  const Vec3 n = cross(a, b);
  const float n2 = dot(n, n);
  if (n2 < 1e-6f) return true;  // parallel edges, a case that the faces cover
  return testAxis<Shape>(shape, box, n * (1.0f / sqrtf32(n2)), best);
}

template <class Shape>
OBBY_DEVICE Contact penetration(const ShapeData& shape, const LocalBox& box) {
  Contact best{1e30f, {0, 1, 0}};
  for (int i = 0; i < Shape::axes(shape); ++i) {
    if (!testAxis<Shape>(shape, box, Shape::axis(shape, i), best)) return best;
  }
  if (!testAxis<Shape>(shape, box, box.axes.x, best)) return best;
  if (!testAxis<Shape>(shape, box, box.axes.y, best)) return best;
  if (!testAxis<Shape>(shape, box, box.axes.z, best)) return best;
  const Vec3 round = Shape::roundAxis(shape, box);
  if (dot(round, round) > 1e-12f && !testAxis<Shape>(shape, box, normalize(round), best))
    return best;
  for (int i = 0; i < Shape::edges(shape); ++i) {
    const Vec3 e = Shape::edge(shape, i);
    if (!testCrossAxis<Shape>(shape, box, e, box.axes.x, best)) return best;
    if (!testCrossAxis<Shape>(shape, box, e, box.axes.y, best)) return best;
    if (!testCrossAxis<Shape>(shape, box, e, box.axes.z, best)) return best;
  }
  return best;
}

// Blocks have a faster form (geom/box_box.h).
template <class Shape>
OBBY_DEVICE Contact dispatch(Shape, const ShapeData& shape, const LocalBox& box) {
  return penetration<Shape>(shape, box);
}
OBBY_DEVICE Contact dispatch(Block, const ShapeData& shape, const LocalBox& box) {
  return boxBlock<float>(shape.half, box);
}

}  // namespace internal

// Tests a box with any rotation. Box and normal are in the frame of the shape. The depth is >= 0 if
// they overlap. Otherwise the result is that of the first separating axis found.
OBBY_DEVICE Contact penetration(ShapeKind kind, const ShapeData& shape, const LocalBox& box) {
  return visitShape(kind, [&](auto s) { return internal::dispatch(s, shape, box); });
}

// Tests an upright box in world space.
OBBY_DEVICE Contact penetration(ShapeKind kind, const ShapeData& shape, const Pose& pose,
                                const UprightBox& box) {
  const Mat3 axes = box.axes();
  const LocalBox local{toLocal(pose, box.center),
                       {toLocal(pose.rotation, axes.x), toLocal(pose.rotation, axes.y),
                        toLocal(pose.rotation, axes.z)},
                       box.half};
  Contact c = penetration(kind, shape, local);
  c.normal = pose.rotation * c.normal;
  return c;
}

}  // namespace obby::geom
