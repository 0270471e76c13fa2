// Where two convex shapes touch: the faces (or lines, or points) that look at each other are cut to
// what lies over both, seen along the normal, and the points with the least gaps are kept.
#pragma once

#include "geom/separation.h"

namespace obby::geom {

constexpr int kMaxPoints = 4;

struct ManifoldPoint {
  Vec3 position;   // half way between both surfaces, world
  float distance;  // gap along the normal; negative: overlap
};

struct Manifold {
  Vec3 normal;  // unit, from a to b
  int count = 0;
  ManifoldPoint points[kMaxPoints];
};

// Two unit vectors that span the plane across n.
OBBY_DEVICE void tangentsOf(Vec3 n, Vec3& u, Vec3& v) {
  u = normalize(absf(n.y) < 0.7f ? Vec3{n.z, 0, -n.x} : Vec3{0, -n.z, n.y});
  v = cross(n, u);
}

namespace internal {

constexpr int kMaxCut = 2 * kMaxFeature;  // corners of a ring that was cut by another

// A ring seen along the normal: (x, y) across it, z along it.
struct Ring {
  union {  // keeps the array from being filled
    Vec3 p[kMaxCut];
  };
  int count = 0;

  OBBY_DEVICE Ring() {}
};

OBBY_DEVICE void see(Ring& ring, const Convex& c, Vec3 toward, Vec3 u, Vec3 v, Vec3 n,
                     Vec3 origin) {
  Vec3 corners[kMaxFeature];
  ring.count = feature(c, toward, corners);
  for (int i = 0; i < ring.count; ++i) {
    const Vec3 d = corners[i] - origin;
    ring.p[i] = {dot(d, u), dot(d, v), dot(d, n)};
  }
}

OBBY_DEVICE float area2(Vec3 a, Vec3 b, Vec3 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// What of `subject` lies to the left of the line from a to b, or to the right where `side` is -1
// (Sutherland and Hodgman).
OBBY_DEVICE void cut(const Ring& subject, Vec3 a, Vec3 b, float side, Ring& out) {
  out.count = 0;
  const bool closed = subject.count > 2;
  Vec3 p = subject.p[0];
  float dp = area2(a, b, p) * side;
  const Vec3 first = p;
  const float firstSide = dp;
  for (int i = 0; i < subject.count; ++i) {
    const bool last = i + 1 == subject.count;
    const Vec3 q = last ? first : subject.p[i + 1];
    const float dq = last ? firstSide : area2(a, b, q) * side;
    if (dp >= 0 && out.count < kMaxCut) out.p[out.count++] = p;
    if (!(last && !closed) && (dp >= 0) != (dq >= 0) && out.count < kMaxCut) {
      out.p[out.count++] = p + (q - p) * (dp / (dp - dq));
    }
    p = q, dp = dq;
  }
}

// Height of the ring's plane at (x, y): a face, or a line or point that is as high as it is there.
struct Plane {
  float height, x, y;
  OBBY_DEVICE float at(Vec3 p) const { return height + x * p.x + y * p.y; }
};

OBBY_DEVICE Plane planeOf(const Ring& r) {
  const Vec3 a = r.p[0];
  if (r.count == 1) return {a.z, 0, 0};
  const Vec3 e = r.p[1] - a;
  if (r.count == 2) {
    const float size = e.x * e.x + e.y * e.y;
    const float rise = size > 1e-12f ? e.z / size : 0.0f;
    return {a.z - rise * (e.x * a.x + e.y * a.y), rise * e.x, rise * e.y};
  }
  const Vec3 n = cross(e, r.p[2] - a);
  if (absf(n.z) < 1e-6f) return {a.z, 0, 0};
  const float x = -n.x / n.z, y = -n.y / n.z;
  return {a.z - x * a.x - y * a.y, x, y};
}

// What of `subject` lies within `frame`, a ring of three corners or more.
OBBY_DEVICE const Ring& cutToRing(const Ring& subject, const Ring& frame, Ring (&work)[2]) {
  const float side = area2(frame.p[0], frame.p[1], frame.p[2]) < 0 ? -1.0f : 1.0f;
  const Ring* left = &subject;
  for (int i = 0; i < frame.count && left->count > 0; ++i) {
    const Vec3 end = frame.p[i + 1 < frame.count ? i + 1 : 0];
    cut(*left, frame.p[i], end, side, work[i & 1]);
    left = &work[i & 1];
  }
  return *left;
}

// Two lines: the part of `subject` beside the other where they are parallel, else where they cross.
OBBY_DEVICE const Ring& cutToLine(const Ring& subject, const Ring& line, Ring (&work)[2]) {
  if (subject.count != 2) return subject;
  const Vec3 a = line.p[0], b = line.p[1], d = b - a, p = subject.p[0], e = subject.p[1] - p;
  const float size = d.x * d.x + d.y * d.y, own = e.x * e.x + e.y * e.y;
  const float turn = d.x * e.y - d.y * e.x;
  if (turn * turn > 1e-4f * size * own) {
    const float t = clampf(((p.x - a.x) * d.y - (p.y - a.y) * d.x) / turn, 0.0f, 1.0f);
    work[0].p[0] = p + e * t;
    work[0].count = 1;
    return work[0];
  }
  const Vec3 across{-d.y, d.x, 0};
  cut(subject, a + across, a, 1, work[0]);
  if (work[0].count == 0) return work[0];
  cut(work[0], b, b + across, 1, work[1]);
  return work[1];
}

// The corner of a ring that lies farthest along the normal (`side` 1) or against it (-1), or the
// ends of the edge that does.
OBBY_DEVICE void farthest(const Ring& ring, float side, Ring& out) {
  int best = 0;
  for (int i = 1; i < ring.count; ++i) {
    if (ring.p[i].z * side > ring.p[best].z * side) best = i;
  }
  out.p[0] = ring.p[best], out.count = 1;
  float least = 1e-3f;  // slope
  for (int i = 0; i < 2 && ring.count > 1; ++i) {
    const int beside = (best + (i == 0 ? 1 : ring.count - 1)) % ring.count;
    const Vec3 d = ring.p[beside] - ring.p[best];
    const float slope = absf(d.z) / maxf(length(d), 1e-6f);
    if (slope < least) least = slope, out.p[1] = ring.p[beside], out.count = 2;
  }
}

// Where they meet beside the faces that look at each other: edge to edge, or a corner. Seen along
// the normal, half way between both.
OBBY_DEVICE Vec3 meetingPoint(const Ring& ringA, const Ring& ringB, float distance) {
  Ring a, b, work[2];
  farthest(ringA, 1, a);
  farthest(ringB, -1, b);
  if (a.count == 2 && b.count == 1) return b.p[0] - Vec3{0, 0, 0.5f * distance};
  const Ring& crossing = b.count == 2 ? cutToLine(a, b, work) : a;
  return (crossing.count > 0 ? crossing.p[0] : a.p[0]) + Vec3{0, 0, 0.5f * distance};
}

struct Gaps {
  union {
    ManifoldPoint points[kMaxCut];
  };
  int count = 0;

  OBBY_DEVICE Gaps() {}
};

// The four that hold best: the deepest, the one farthest from it, and the widest to both sides.
OBBY_DEVICE void reduce(const Gaps& all, Vec3 n, Manifold& out) {
  if (all.count <= kMaxPoints) {
    out.count = all.count;
    for (int i = 0; i < all.count; ++i) out.points[i] = all.points[i];
    return;
  }
  int first = 0, second = 0, left = 0, right = 0;
  for (int i = 1; i < all.count; ++i) {
    if (all.points[i].distance < all.points[first].distance) first = i;
  }
  const Vec3 a = all.points[first].position;
  float farthest = -1, most = 0, least = 0;
  for (int i = 0; i < all.count; ++i) {
    const Vec3 d = all.points[i].position - a;
    if (dot(d, d) > farthest) farthest = dot(d, d), second = i;
  }
  const Vec3 b = all.points[second].position;
  for (int i = 0; i < all.count; ++i) {
    const float area = dot(cross(b - a, all.points[i].position - a), n);
    if (area > most) most = area, left = i;
    if (area < least) least = area, right = i;
  }
  out.points[out.count++] = all.points[first];
  out.points[out.count++] = all.points[second];
  if (most > 0) out.points[out.count++] = all.points[left];
  if (least < 0) out.points[out.count++] = all.points[right];
}

}  // namespace internal

// Points with gaps of at most `margin`. `s` is what separation(a, b) gave.
OBBY_APART Manifold manifold(const Convex& a, const Convex& b, const Separation& s, float margin) {
  using namespace internal;
  Manifold out;
  out.normal = s.normal;
  Vec3 u, v;
  tangentsOf(s.normal, u, v);
  // Rings are seen from a point between both: heights are small, and floats precise.
  const Vec3 origin = corner(a, s.normal);
  Ring ringA, ringB;
  see(ringA, a, s.normal, u, v, s.normal, origin);
  see(ringB, b, -s.normal, u, v, s.normal, origin);
  const Plane planeA = planeOf(ringA), planeB = planeOf(ringB);
  const bool aIsFrame = ringA.count >= 3;
  const Ring &whole = aIsFrame ? ringB : ringA, &frame = aIsFrame ? ringA : ringB;
  Ring work[2];
  const Ring& subject = frame.count >= 3   ? cutToRing(whole, frame, work)
                        : frame.count == 2 ? cutToLine(whole, frame, work)
                                           : whole;
  Gaps gaps;
  for (int i = 0; i < subject.count; ++i) {
    const Vec3 p = subject.p[i];
    const float za = planeA.at(p), zb = planeB.at(p), gap = zb - za;
    if (gap > margin) continue;
    gaps.points[gaps.count++] = {origin + u * p.x + v * p.y + s.normal * (0.5f * (za + zb)), gap};
  }
  if (gaps.count == 0 && s.distance <= margin) {
    const Vec3 p = meetingPoint(ringA, ringB, s.distance);
    gaps.points[gaps.count++] = {origin + u * p.x + v * p.y + s.normal * p.z, s.distance};
  }
  reduce(gaps, s.normal, out);
  return out;
}

}  // namespace obby::geom
