// Contact points of two convex shapes. The features that face each other (faces, lines or points)
// are projected along the normal and clipped to their overlap. The points with the smallest gaps
// are kept.
#pragma once

#include "geom/ring.h"
#include "geom/separation.h"

namespace obby::geom {

namespace internal {

OBBY_DEVICE void see(Ring& ring, const Convex& c, Vec3 toward, const ViewT<float>& view) {
  Vec3 corners[kMaxFeature];
  const int count = feature(c, toward, corners);
  for (int i = 0; i < count; ++i) ring.add(true, view.see(corners[i]));
}

// Returns the plane of a ring. The plane of a line is level across the line, and the plane of a
// point is level.
OBBY_DEVICE PlaneT<float> planeOf(const Ring& r) {
  const Vec3 a = r.at(0);
  if (r.count == 1) return {a.z, 0, 0};
  if (r.count > 2) return planeOfFace<float>(r);
  const Vec3 e = r.at(1) - a;
  const float size = e.x * e.x + e.y * e.y;
  const float rise = size > 1e-12f ? e.z / size : 0.0f;
  return {a.z - rise * (e.x * a.x + e.y * a.y), rise * e.x, rise * e.y};
}

// Clips the line `subject` to the part next to `line` if they are parallel, otherwise to the point
// where they cross.
OBBY_DEVICE const Ring& cutToLine(const Ring& subject, const Ring& line, Ring (&work)[2]) {
  if (subject.count != 2) return subject;
  const Vec3 a = line.at(0), b = line.at(1), d = b - a, p = subject.at(0), e = subject.at(1) - p;
  const float size = d.x * d.x + d.y * d.y, own = e.x * e.x + e.y * e.y;
  const float turn = d.x * e.y - d.y * e.x;
  if (turn * turn > 1e-4f * size * own) {
    const float t = clampf(((p.x - a.x) * d.y - (p.y - a.y) * d.x) / turn, 0.0f, 1.0f);
    work[0].clear();
    work[0].add(true, p + e * t);
    return work[0];
  }
  const Vec3 across{-d.y, d.x, 0};
  cut<float>(subject, a + across, a, 1, work[0]);
  if (work[0].count == 0) return work[0];
  cut<float>(work[0], b, b + across, 1, work[1]);
  return work[1];
}

// Adds the corner of a ring that lies farthest along the normal (`side` 1) or against it (-1). Adds
// a second corner if an edge from there is level.
OBBY_DEVICE void farthest(const Ring& ring, float side, Ring& out) {
  int best = 0;
  for (int i = 1; i < ring.count; ++i) {
    if (ring.at(i).z * side > ring.at(best).z * side) best = i;
  }
  const Vec3 corner = ring.at(best);
  out.add(true, corner);
  float slopes[2] = {1, 1};
  const Vec3 neighbours[2] = {ring.next(best), ring.at((best + ring.count - 1) % ring.count)};
  for (int i = 0; i < 2 && ring.count > 1; ++i) {
    const Vec3 d = neighbours[i] - corner;
    slopes[i] = absf(d.z) / maxf(length(d), 1e-6f);
  }
  const int flatter = slopes[1] < slopes[0] ? 1 : 0;
  out.add(slopes[flatter] < 1e-3f, neighbours[flatter]);
}

// Returns the meeting point of shapes whose facing features do not overlap: edge to edge, or at a
// corner. It is in the coordinates of the view, half way between both surfaces.
OBBY_DEVICE Vec3 meetingPoint(const Ring& ringA, const Ring& ringB, float distance) {
  Ring a, b, work[2];
  farthest(ringA, 1, a);
  farthest(ringB, -1, b);
  if (a.count == 2 && b.count == 1) return b.at(0) - Vec3{0, 0, 0.5f * distance};
  const Ring& crossing = b.count == 2 ? cutToLine(a, b, work) : a;
  return (crossing.count > 0 ? crossing.at(0) : a.at(0)) + Vec3{0, 0, 0.5f * distance};
}

}  // namespace internal

// Returns the points with gaps of at most `margin`. `s` is the result of separation(a, b).
OBBY_APART Manifold manifold(const Convex& a, const Convex& b, const Separation& s, float margin) {
  using namespace internal;
  Manifold out;
  out.normal = s.normal;
  const ViewT<float> view(corner(a, s.normal), s.normal);
  Ring ringA, ringB;
  see(ringA, a, s.normal, view);
  see(ringB, b, -s.normal, view);
  if (ringA.count == 0 || ringB.count == 0) return out;  // a hull without a face on that side
  // The second of two blocks is the frame: bodies usually lie on larger parts, and a ring inside
  // the frame is not cut. For other shapes the first is the frame if it has a face.
  const bool aIsFrame = ringA.count >= 3 && !(isBlock(a.kind) && isBlock(b.kind));
  const Ring &whole = aIsFrame ? ringB : ringA, &frame = aIsFrame ? ringA : ringB;
  Ring work[2];
  const Ring& subject = frame.count >= 3   ? cutToRing<float>(whole, frame, work)
                        : frame.count == 2 ? cutToLine(whole, frame, work)
                                           : whole;
  Gaps gaps;
  findGaps<float>(subject, planeOf(ringA), planeOf(ringB), view, margin, gaps);
  if (gaps.count == 0 && s.distance <= margin) {
    gaps.add(true, {view.toWorld(meetingPoint(ringA, ringB, s.distance)), s.distance});
  }
  reduce<float>(gaps, out);
  return out;
}

// Returns the contact points of two blocks, for one pair or lanes of pairs. Finds no points if they
// meet edge to edge or at a corner.
template <class F>
OBBY_DEVICE ManifoldT<F> blockManifold(const BlockT<F>& a, const BlockT<F>& b,
                                       const SeparationT<F>& s, F margin) {
  using namespace internal;
  const auto cornerOf = [](const BlockT<F>& block, Vec3T<F> toward) {
    return toWorld(block.pose, withSigns(block.half, toLocal(block.pose.rotation, toward)));
  };
  const ViewT<F> view(cornerOf(a, s.normal), s.normal);
  const auto see = [&](RingT<F>& ring, const BlockT<F>& block, Vec3T<F> toward) {
    Vec3T<F> corners[4];
    blockFace(block.half, toLocal(block.pose.rotation, toward), corners);
    for (const Vec3T<F>& c : corners) ring.add(MaskOf<F>(true), view.see(toWorld(block.pose, c)));
  };
  RingT<F> ringA, ringB, work[2];
  see(ringA, a, s.normal);
  see(ringB, b, -s.normal);
  GapsT<F> gaps;
  findGaps<F>(cutToRing<F>(ringA, ringB, work), planeOfFace<F>(ringA), planeOfFace<F>(ringB), view,
              margin, gaps);
  ManifoldT<F> out;
  out.normal = s.normal;
  reduce<F>(gaps, out);
  return out;
}

}  // namespace obby::geom
