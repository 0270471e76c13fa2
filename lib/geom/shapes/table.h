// The table of shapes, with one row for each. All code that depends on the kind of a shape goes
// through visitShape.
#pragma once

#include "geom/shapes/ball.h"
#include "geom/shapes/block.h"
#include "geom/shapes/convex_hull.h"
#include "geom/shapes/corner_wedge.h"
#include "geom/shapes/cylinder.h"
#include "geom/shapes/wedge.h"

// X(kind, type)
#define OBBY_SHAPES(X)        \
  X(block, Block)             \
  X(ball, Ball)               \
  X(cylinder, Cylinder)       \
  X(wedge, Wedge)             \
  X(cornerWedge, CornerWedge) \
  X(truss, Block)             \
  X(hull, ConvexHull)

namespace obby::geom {

// Calls f with an object of the shape's type: visitShape(kind, [&](auto shape) { return
// shape.support(data, d); }).
template <class F>
OBBY_DEVICE auto visitShape(ShapeKind kind, F&& f) {
  switch (kind) {
#define OBBY_SHAPE_CASE(name, Type) \
  case ShapeKind::name: return f(Type{});
    OBBY_SHAPES(OBBY_SHAPE_CASE)
#undef OBBY_SHAPE_CASE
  }
  return f(Block{});
}

}  // namespace obby::geom
