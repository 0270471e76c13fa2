// Distance or overlap of two convex shapes, and its axis. The separating axes are the face normals
// of both, the cross products of their edges, and the closest approach of round shapes.
#pragma once

#include "geom/blocks_apart.h"
#include "geom/closest.h"

namespace obby::geom {

namespace internal {

OBBY_APART Separation twoBlocksApart(const Convex& a, const Convex& b, float margin) {
  return blocksApart<float>({a.pose, a.shape.half}, {b.pose, b.shape.half}, margin);
}

OBBY_DEVICE void tryAxis(Separation& best, const Convex& a, const Convex& b, Vec3 n) {
  const float forward = -support(b, -n) - support(a, n);
  const float backward = -support(b, n) - support(a, -n);
  keepFarthest<float>(best, forward, n, kPreference);
  keepFarthest<float>(best, backward, -n, kPreference);
}

OBBY_APART void tryCrosses(Separation& best, const Convex& a, const Convex& b) {
  for (int i = 0; i < edges(a); ++i) {
    const Vec3 edge1 = edge(a, i);
    for (int j = 0; j < edges(b); ++j) {
      const Vec3 n = cross(edge1, edge(b, j));
      const float n2 = dot(n, n);
      if (n2 > kParallel) tryAxis(best, a, b, n * (1.0f / sqrtf32(n2)));
    }
  }
}

// Tries the axes of round shapes, from core to core. For a rim against an edge, a corner or another
// rim, a slightly smaller cylinder is also tried. It is apart from the other shape unless the two
// overlap deeply.
OBBY_APART void tryRound(Separation& best, const Convex& a, const Convex& b) {
  const auto toward = [&](Vec3 v) {
    if (dot(v, v) > 0) tryAxis(best, a, b, normalize(v));
  };
  if (isRound(a.kind) || isRound(b.kind)) toward(closestApproach(a, b, 0));
  const bool aHasRim = a.kind == ShapeKind::cylinder, bHasRim = b.kind == ShapeKind::cylinder;
  if (aHasRim && b.kind == ShapeKind::ball) {
    toward(fromCylinder(a, b.pose.position));
  } else if (bHasRim && a.kind == ShapeKind::ball) {
    toward(-fromCylinder(b, a.pose.position));
  } else if (aHasRim || bHasRim) {
    toward(closestApproach(a, b, kRimInset));
  }
}

OBBY_APART Separation shapesApart(const Convex& a, const Convex& b, float margin) {
  Separation best{-1e30f, {0, 1, 0}};
  tryRound(best, a, b);
  for (int i = 0; i < axes(a) && best.distance <= margin; ++i) tryAxis(best, a, b, axis(a, i));
  for (int i = 0; i < axes(b) && best.distance <= margin; ++i) tryAxis(best, a, b, axis(b, i));
  if (best.distance <= margin) tryCrosses(best, a, b);
  return best;
}

}  // namespace internal

// Returns the distance of two shapes and its axis. The distance is exact if they overlap, or if
// faces or round parts are closest. It is a lower bound if corners or edges are closest. Returns
// early once they are more than `margin` apart.
OBBY_DEVICE Separation separation(const Convex& a, const Convex& b, float margin) {
  if (isBlock(a.kind) && isBlock(b.kind)) return internal::twoBlocksApart(a, b, margin);
  // Positions are relative to a: far from the world's origin, floats are coarser than these
  // distances.
  Convex fromA = a, seen = b;
  fromA.pose.position = {};
  seen.pose.position = b.pose.position - a.pose.position;
  return internal::shapesApart(fromA, seen, margin);
}

}  // namespace obby::geom
