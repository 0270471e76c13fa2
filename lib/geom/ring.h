// Clips facing polygons, projected along the normal of a contact, and finds the points with the
// smallest gaps between them. The code is for one pair or lanes of pairs.
#pragma once

#include "geom/shape.h"
#include "math/lane_list.h"

namespace obby::geom {

constexpr int kMaxPoints = 4;

template <class F>
struct ManifoldPointT {
  Vec3T<F> position;  // half way between both surfaces, world
  F distance;         // gap along the normal; negative when they overlap
};

template <class F>
struct ManifoldT {
  Vec3T<F> normal;  // unit, from a to b
  IntOf<F> count = 0;
  ManifoldPointT<F> points[kMaxPoints];
};

using ManifoldPoint = ManifoldPointT<float>;
using Manifold = ManifoldT<float>;

// Sets u and v to unit vectors that span the plane perpendicular to n.
template <class F>
OBBY_DEVICE void tangentsOf(Vec3T<F> n, Vec3T<F>& u, Vec3T<F>& v) {
  const F zero = 0.0f;
  u = normalize(select(absf(n.y) < 0.7f, Vec3T<F>{n.z, zero, -n.x}, Vec3T<F>{zero, -n.z, n.y}));
  v = cross(n, u);
}

namespace internal {

constexpr int kMaxCut = 2 * kMaxFeature;  // max corners of a ring that another ring cut

// Corners with (x, y) across the normal and z along it.
template <class F>
using RingT = LaneList<Vec3T<F>, F, kMaxCut>;
template <class F>
using GapsT = LaneList<ManifoldPointT<F>, F, kMaxCut>;

using Ring = RingT<float>;
using Gaps = GapsT<float>;

// Coordinates for rings. The origin is close to the contact, so that heights are small and floats
// precise.
template <class F>
struct ViewT {
  Vec3T<F> origin, u, v, n;

  OBBY_DEVICE ViewT(Vec3T<F> from, Vec3T<F> normal) : origin(from), n(normal) {
    tangentsOf<F>(normal, u, v);
  }
  OBBY_DEVICE Vec3T<F> see(Vec3T<F> corner) const {
    const Vec3T<F> d = corner - origin;
    return {dot(d, u), dot(d, v), dot(d, n)};
  }
  OBBY_DEVICE Vec3T<F> toWorld(Vec3T<F> p) const { return origin + u * p.x + v * p.y + n * p.z; }
};

template <class F>
OBBY_DEVICE F area2(Vec3T<F> a, Vec3T<F> b, Vec3T<F> c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Keeps the part of `subject` to the left of the line from a to b, or to the right if `side` is -1
// (Sutherland and Hodgman).
template <class F>
OBBY_DEVICE void cut(const RingT<F>& subject, Vec3T<F> a, Vec3T<F> b, F side, RingT<F>& out) {
  out.clear();
  const MaskOf<F> closed = subject.count > 2;
  Vec3T<F> p = subject.at(0);
  F dp = area2<F>(a, b, p) * side;
  for (int i = 0; i < kMaxCut && any(subject.count > i); ++i) {
    const MaskOf<F> here = subject.count > i;
    const Vec3T<F> q = subject.next(i);
    const F dq = area2<F>(a, b, q) * side;
    const MaskOf<F> inside = dp >= 0.0f, nextInside = dq >= 0.0f;
    out.add(here & inside, p);
    const MaskOf<F> crosses = here & (closed | (subject.count > i + 1)) &
                              ((inside & !nextInside) | (nextInside & !inside));
    if (any(crosses)) out.add(crosses, p + (q - p) * (dp / (dp - dq)));
    p = q, dp = dq;
  }
}

// Returns true if the whole ring is to the left of the line, or to the right if `side` is -1.
template <class F>
OBBY_DEVICE bool isWithin(const RingT<F>& ring, Vec3T<F> a, Vec3T<F> b, F side) {
  MaskOf<F> within = true;
  for (int i = 0; i < kMaxCut && any(ring.count > i); ++i) {
    within = within & ((area2<F>(a, b, ring.at(i)) * side >= 0.0f) | (ring.count <= i));
  }
  return all(within);
}

// Clips `subject` to `frame`, a ring of at least three corners, as many in all lanes. The frame
// should be the larger ring: a ring inside it is not cut.
template <class F>
OBBY_DEVICE const RingT<F>& cutToRing(const RingT<F>& subject, const RingT<F>& frame,
                                      RingT<F> (&work)[2]) {
  const F side = select(area2<F>(frame.at(0), frame.at(1), frame.at(2)) < 0.0f, F(-1.0f), F(1.0f));
  const RingT<F>* left = &subject;
  int next = 0;
  for (int i = 0; any(frame.count > i) && any(left->count > 0); ++i) {
    const Vec3T<F> a = frame.at(i), b = frame.next(i);
    if (isWithin<F>(*left, a, b, side)) continue;
    cut<F>(*left, a, b, side, work[next]);
    left = &work[next];
    next = 1 - next;
  }
  return *left;
}

// A plane. at() returns its height at (x, y).
template <class F>
struct PlaneT {
  F height, x, y;
  OBBY_DEVICE F at(Vec3T<F> p) const { return height + x * p.x + y * p.y; }
};

// Returns the plane through the first three corners of a ring.
template <class F>
OBBY_DEVICE PlaneT<F> planeOfFace(const RingT<F>& r) {
  const Vec3T<F> a = r.at(0), n = cross(r.at(1) - a, r.at(2) - a);
  const MaskOf<F> upright = absf(n.z) < 1e-6f;  // the plane is vertical, and any plane serves
  const F x = select(upright, F(0.0f), -n.x / n.z), y = select(upright, F(0.0f), -n.y / n.z);
  return {a.z - x * a.x - y * a.y, x, y};
}

// Adds the corners of `subject` where the gap between both planes is at most `margin`.
template <class F>
OBBY_DEVICE void findGaps(const RingT<F>& subject, const PlaneT<F>& a, const PlaneT<F>& b,
                          const ViewT<F>& view, F margin, GapsT<F>& out) {
  for (int i = 0; i < kMaxCut && any(subject.count > i); ++i) {
    const Vec3T<F> p = subject.at(i);
    const F za = a.at(p), zb = b.at(p), gap = zb - za;
    out.add((subject.count > i) & (gap <= margin),
            {view.toWorld({p.x, p.y, 0.5f * (za + zb)}), gap});
  }
}

// Keeps the four most stable points: the deepest point, the farthest from it, and the outermost to
// both sides of their line.
template <class F>
OBBY_DEVICE void reduce(const GapsT<F>& gaps, ManifoldT<F>& out) {
  using Int = IntOf<F>;
  const MaskOf<F> few = gaps.count <= kMaxPoints;
  out.count = gaps.count;
  if (all(few)) {
    for (int k = 0; k < kMaxPoints && any(gaps.count > k); ++k) out.points[k] = gaps.at(k);
    return;
  }
  Int first = 0, second = 0, left = 0, right = 0;
  F lowest = gaps.at(0).distance, farthest = -1.0f, max = 0.0f, min = 0.0f;
  const auto keep = [](MaskOf<F> better, F value, int i, F& best, Int& index) {
    best = select(better, value, best);
    index = select(better, Int(i), index);
  };
  for (int i = 1; i < kMaxCut && any(gaps.count > i); ++i) {
    const F d = gaps.at(i).distance;
    keep((gaps.count > i) & (d < lowest), d, i, lowest, first);
  }
  const Vec3T<F> a = gaps.at(first).position;
  for (int i = 0; i < kMaxCut && any(gaps.count > i); ++i) {
    const Vec3T<F> d = gaps.at(i).position - a;
    keep((gaps.count > i) & (dot(d, d) > farthest), dot(d, d), i, farthest, second);
  }
  const Vec3T<F> b = gaps.at(second).position;
  for (int i = 0; i < kMaxCut && any(gaps.count > i); ++i) {
    const F area = dot(cross(b - a, gaps.at(i).position - a), out.normal);
    const MaskOf<F> here = gaps.count > i;
    keep(here & (area > max), area, i, max, left);
    keep(here & (area < min), area, i, min, right);
  }
  const MaskOf<F> toLeft = max > 0.0f, toRight = min < 0.0f;
  const Int third = select(toLeft, left, right);
  out.points[0] = gaps.at(select(few, Int(0), first));
  out.points[1] = gaps.at(select(few, Int(1), second));
  out.points[2] = gaps.at(select(few, Int(2), third));
  out.points[3] = gaps.at(select(few, Int(3), right));
  const Int more = select(toLeft, Int(1), Int(0)) + select(toRight, Int(1), Int(0));
  out.count = select(few, gaps.count, more + 2);
}

}  // namespace internal

}  // namespace obby::geom
