// Distance or overlap of two blocks and its axis, for one pair or for lanes of pairs. The
// separating axes are the face normals and the cross products of edges.
#pragma once

#include "geom/shape.h"

namespace obby::geom {

template <class F>
struct SeparationT {
  F distance;       // studs; negative when they overlap
  Vec3T<F> normal;  // unit, from a to b; moving b by -distance along it makes them touch
};

using Separation = SeparationT<float>;

namespace internal {

// Studs by which an edge axis must beat a face axis, and a later face axis an earlier one. Without
// this preference a resting contact would switch axes from tick to tick.
constexpr float kPreference = 1e-3f;
// Edges count as parallel if the squared sine of their angle is smaller: the faces then separate as
// well. The bound is tight because long edges cross at very small angles.
constexpr float kParallel = 1e-6f;

template <class F>
OBBY_DEVICE void keepFarthest(SeparationT<F>& best, MaskOf<F> counts, F distance, Vec3T<F> normal) {
  best.distance = select(counts, distance, best.distance);
  best.normal = select(counts, normal, best.normal);
}

template <class F>
OBBY_DEVICE void keepFarthest(SeparationT<F>& best, F distance, Vec3T<F> normal, float bonus) {
  keepFarthest<F>(best, distance > best.distance + bonus, distance, normal);
}

template <class F>
OBBY_DEVICE void tryFaces(SeparationT<F>& best, Vec3T<F> distance, Vec3T<F> toward,
                          const Mat3T<F>& axes, float firstBonus) {
  const auto outward = [](F side, Vec3T<F> axis) { return select(side < 0.0f, -axis, axis); };
  keepFarthest<F>(best, distance.x, outward(toward.x, axes.x), firstBonus);
  keepFarthest<F>(best, distance.y, outward(toward.y, axes.y), kPreference);
  keepFarthest<F>(best, distance.z, outward(toward.z, axes.z), kPreference);
}

// Tries the cross products of a's edges and `e`, an edge of b. All vectors are in a's frame, as are
// b's axes `r`.
template <class F>
OBBY_DEVICE void tryCrosses(SeparationT<F>& best, const BlockT<F>& a, Vec3T<F> halfB,
                            const Mat3T<F>& r, Vec3T<F> e, Vec3T<F> toward) {
  const F zero = 0.0f;
  const Vec3T<F> crosses[3] = {{zero, -e.z, e.y}, {e.z, zero, -e.x}, {-e.y, e.x, zero}};
  for (const Vec3T<F>& n : crosses) {
    const F n2 = dot(n, n);
    const MaskOf<F> counts = n2 >= kParallel;
    if (!any(counts)) continue;
    const F inverse = 1.0f / sqrtf32(n2), along = dot(n, toward);
    const F radii = dot(abs(n), a.half) + dot(abs(toLocal(r, n)), halfB);
    const F apart = (absf(along) - radii) * inverse;
    const MaskOf<F> farther = counts & (apart > best.distance + kPreference);
    if (!any(farther)) continue;
    const F scale = select(along < 0.0f, -inverse, inverse);
    keepFarthest<F>(best, farther, apart, a.pose.rotation * (n * scale));
  }
}

}  // namespace internal

// Returns early once all lanes are more than `margin` apart. The distance is then a lower bound.
template <class F>
OBBY_DEVICE SeparationT<F> blocksApart(const BlockT<F>& a, const BlockT<F>& b, F margin) {
  const Mat3T<F>&ra = a.pose.rotation, &rb = b.pose.rotation;
  const Vec3T<F> t = b.pose.position - a.pose.position;
  const Vec3T<F> ta = toLocal(ra, t), tb = toLocal(rb, t);
  const Mat3T<F> r{toLocal(ra, rb.x), toLocal(ra, rb.y), toLocal(ra, rb.z)};
  const Vec3T<F> rx = abs(r.x), ry = abs(r.y), rz = abs(r.z);
  const Vec3T<F> reachB = rx * b.half.x + ry * b.half.y + rz * b.half.z;
  SeparationT<F> best{-1e30f, {0, 1, 0}};
  internal::tryFaces<F>(best, abs(ta) - a.half - reachB, ta, ra, 0);
  if (all(best.distance > margin)) return best;
  const Vec3T<F> reachA{dot(rx, a.half), dot(ry, a.half), dot(rz, a.half)};
  internal::tryFaces<F>(best, abs(tb) - b.half - reachA, tb, rb, internal::kPreference);
  if (all(best.distance > margin)) return best;
  const Vec3T<F>* const edges[3] = {&r.x, &r.y, &r.z};
  for (int j = 0; j < 3; ++j) internal::tryCrosses<F>(best, a, b.half, r, *edges[j], ta);
  return best;
}

}  // namespace obby::geom
