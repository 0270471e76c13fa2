// How far apart two convex shapes are, or how deep in each other, and along which axis: separating
// axes over the faces of both, the cross products of their edges, and the closest approach of round
// ones.
#pragma once

#include "geom/closest.h"

namespace obby::geom {

struct Separation {
  float distance;  // studs; negative: they overlap by that much
  Vec3 normal;     // unit, from a to b: moving b by -distance along it makes them touch
};

namespace internal {

// Faces are preferred to edges and the first shape to the second where they are as good, so that a
// resting contact does not change its mind from one tick to the next.
constexpr float kPreference = 1e-3f;
// Squared sine of an angle between edges below which the faces are as good. Long edges cross at
// angles far smaller than those that can be seen.
constexpr float kParallel = 1e-6f;

OBBY_DEVICE void keepFarthest(Separation& best, float distance, Vec3 normal, float bonus) {
  if (distance <= best.distance + bonus) return;
  best = {distance, normal};
}

OBBY_APART Separation blocksApart(const Convex& a, const Convex& b, float margin) {
  const Mat3 &ra = a.pose.rotation, &rb = b.pose.rotation;
  const Vec3 ha = a.shape.half, hb = b.shape.half, t = b.pose.position - a.pose.position;
  const Vec3 ta = toLocal(ra, t), tb = toLocal(rb, t);
  const Mat3 r{toLocal(ra, rb.x), toLocal(ra, rb.y), toLocal(ra, rb.z)};  // b's axes in a's frame
  const Vec3 rx = abs(r.x), ry = abs(r.y), rz = abs(r.z);
  const Vec3 reachB = rx * hb.x + ry * hb.y + rz * hb.z;
  Separation best{-1e30f, {0, 1, 0}};
  const Vec3 da = abs(ta) - ha - reachB;
  keepFarthest(best, da.x, ta.x < 0 ? -ra.x : ra.x, 0);
  keepFarthest(best, da.y, ta.y < 0 ? -ra.y : ra.y, kPreference);
  keepFarthest(best, da.z, ta.z < 0 ? -ra.z : ra.z, kPreference);
  if (best.distance > margin) return best;
  const Vec3 db = abs(tb) - hb - Vec3{dot(rx, ha), dot(ry, ha), dot(rz, ha)};
  keepFarthest(best, db.x, tb.x < 0 ? -rb.x : rb.x, kPreference);
  keepFarthest(best, db.y, tb.y < 0 ? -rb.y : rb.y, kPreference);
  keepFarthest(best, db.z, tb.z < 0 ? -rb.z : rb.z, kPreference);
  if (best.distance > margin) return best;
  const Vec3* const columns[3] = {&r.x, &r.y, &r.z};
  for (int j = 0; j < 3; ++j) {
    const Vec3 e = *columns[j];
    const Vec3 crosses[3] = {{0, -e.z, e.y}, {e.z, 0, -e.x}, {-e.y, e.x, 0}};
    for (const Vec3& n : crosses) {
      const float n2 = dot(n, n);
      if (n2 < kParallel) continue;
      const float inverse = 1.0f / sqrtf32(n2), along = dot(n, ta);
      const float radii = dot(abs(n), ha) + dot(abs(toLocal(r, n)), hb);
      const float apart = (absf(along) - radii) * inverse;
      if (apart <= best.distance + kPreference) continue;
      best = {apart, ra * (n * (along < 0 ? -inverse : inverse))};
    }
  }
  return best;
}

OBBY_DEVICE void tryAxis(Separation& best, const Convex& a, const Convex& b, Vec3 n) {
  const float forward = -support(b, -n) - support(a, n);
  const float backward = -support(b, n) - support(a, -n);
  keepFarthest(best, forward, n, kPreference);
  keepFarthest(best, backward, -n, kPreference);
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

// Round parts: from core to core, and where a rim meets an edge, a corner or another rim from a
// slightly smaller cylinder, which is apart from what does not overlap deeply.
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

// Exact where they overlap or faces or round parts are closest; a lower bound where they are apart
// by corners or edges. Gives up early once they are more than `margin` apart.
OBBY_DEVICE Separation separation(const Convex& a, const Convex& b, float margin) {
  if (isBlock(a.kind) && isBlock(b.kind)) return internal::blocksApart(a, b, margin);
  // Seen from a: far from the world's origin floats are coarser than what is measured.
  Convex fromA = a, seen = b;
  fromA.pose.position = {};
  seen.pose.position = b.pose.position - a.pose.position;
  return internal::shapesApart(fromA, seen, margin);
}

}  // namespace obby::geom
