// Closest approach of the cores of two shapes, by the algorithm of Gilbert, Johnson and Keerthi.
// The core of a ball is its centre. The core of a cylinder is its axis, or a slightly smaller
// cylinder. Other shapes are their own core.
#pragma once

#include "geom/convex.h"

namespace obby::geom {

// Inset of a cylinder's core, as a share of its radius or half length, whichever is smaller. A
// larger inset allows deeper overlap but makes the separating direction less exact.
constexpr float kRimInset = 0.125f;

namespace internal {

// Up to four corners of the Minkowski difference, of which the first `count` are valid.
struct Simplex {
  Vec3 p[4];
  int count = 0;
};

// Returns the point of the segment closest to the origin. Reduces `s` to the ends that define it.
OBBY_DEVICE Vec3 closestOnSegment(Simplex& s) {
  const Vec3 a = s.p[0], b = s.p[1], ab = b - a;
  const float t = -dot(a, ab), size = dot(ab, ab);
  if (t <= 0 || size <= 0) {
    s.count = 1;
    return a;
  }
  if (t >= size) {
    s.p[0] = b;
    s.count = 1;
    return b;
  }
  return a + ab * (t / size);
}

// Tests the Voronoi regions of the triangle (Ericson, Real-Time Collision Detection, 5.1.5).
OBBY_DEVICE Vec3 closestOnTriangle(Simplex& s) {
  const Vec3 a = s.p[0], b = s.p[1], c = s.p[2], ab = b - a, ac = c - a;
  const Vec3 n = cross(ab, ac);
  const float n2 = dot(n, n);
  const bool insideAb = dot(cross(ab, n), -a) <= 0, insideBc = dot(cross(c - b, n), -b) <= 0,
             insideCa = dot(cross(-ac, n), -c) <= 0;
  if (n2 > 1e-20f && insideAb && insideBc && insideCa) return n * (dot(a, n) / n2);
  // The closest of the three sides.
  Vec3 best{};
  float min = 1e30f;
  Simplex kept = s;
  for (int i = 0; i < 3; ++i) {
    Simplex side;
    side.p[0] = s.p[i], side.p[1] = s.p[(i + 1) % 3], side.count = 2;
    const Vec3 at = closestOnSegment(side);
    if (dot(at, at) >= min) continue;
    min = dot(at, at), best = at, kept = side;
  }
  s = kept;
  return best;
}

// Returns the point of the tetrahedron closest to the origin, zero if the origin is inside.
OBBY_DEVICE Vec3 closestOnTetrahedron(Simplex& s) {
  Vec3 best{};
  float min = 1e30f;
  Simplex kept = s;
  for (int i = 0; i < 4; ++i) {
    const Vec3 a = s.p[i], b = s.p[(i + 1) & 3], c = s.p[(i + 2) & 3], d = s.p[(i + 3) & 3];
    const Vec3 n = cross(b - a, c - a);
    // The origin is not beyond this face if it lies on the side of the fourth corner.
    if (dot(n, -a) * dot(n, d - a) > 0) continue;
    Simplex face;
    face.p[0] = a, face.p[1] = b, face.p[2] = c, face.count = 3;
    const Vec3 at = closestOnTriangle(face);
    if (dot(at, at) >= min) continue;
    min = dot(at, at), best = at, kept = face;
  }
  s = kept;
  return best;
}

OBBY_DEVICE Vec3 closestToOrigin(Simplex& s) {
  if (s.count == 1) return s.p[0];
  if (s.count == 2) return closestOnSegment(s);
  return s.count == 3 ? closestOnTriangle(s) : closestOnTetrahedron(s);
}

OBBY_DEVICE bool has(const Simplex& s, Vec3 w) {
  for (int i = 0; i < s.count; ++i) {
    if (s.p[i].x == w.x && s.p[i].y == w.y && s.p[i].z == w.z) return true;
  }
  return false;
}

// Returns a corner of a round shape's core, or of the shape itself if it is not round.
OBBY_DEVICE Vec3 coreCorner(const Convex& c, Vec3 d, float inset) {
  if (c.kind == ShapeKind::ball) return c.pose.position;
  if (c.kind != ShapeKind::cylinder) return corner(c, d);
  if (inset > 0) {
    Convex core = c;
    const float r = Cylinder::radius(c.shape), less = minf(r, c.shape.half.x) * inset;
    core.shape.half = {c.shape.half.x - less, r - less, r - less};
    return corner(core, d);
  }
  const Vec3 half = c.pose.rotation.x * c.shape.half.x;
  return c.pose.position + (dot(half, d) < 0 ? -half : half);
}

}  // namespace internal

// Returns the vector from the closest point of a cylinder to a point, zero inside.
OBBY_DEVICE Vec3 fromCylinder(const Convex& cylinder, Vec3 point) {
  const Vec3 local = toLocal(cylinder.pose, point);
  return cylinder.pose.rotation * (local - Cylinder::closestPointOf(cylinder.shape, local));
}

// Returns the vector from the closest point of a's core to that of b's, zero if the cores meet. If
// `inset` is 0, the core of a cylinder is its axis.
OBBY_APART Vec3 closestApproach(const Convex& a, const Convex& b, float inset) {
  internal::Simplex s;
  Vec3 v = b.pose.position - a.pose.position;
  for (int i = 0; i < 24; ++i) {
    const Vec3 w = internal::coreCorner(b, -v, inset) - internal::coreCorner(a, v, inset);
    const float gap = dot(v, v);
    // No corner is closer by more than rounding.
    if (i > 0 && (gap - dot(v, w) <= 1e-6f * gap || internal::has(s, w))) return v;
    s.p[s.count++] = w;
    const Vec3 next = internal::closestToOrigin(s);
    if (s.count == 4 || dot(next, next) < 1e-10f) return {};
    if (i > 0 && dot(next, next) >= gap) return v;
    v = next;
  }
  return v;
}

}  // namespace obby::geom
