// The corners of a convex hull's face, in the order in which they lie around it.
#pragma once

#include "geom/shape.h"

namespace obby::geom {

namespace internal {

constexpr int kMaxRing = 32;  // max corners of a face that are considered

// Returns a number from 0 to 4 that grows with the angle of (x, y), without trigonometry.
OBBY_DEVICE float pseudoAngle(float x, float y) {
  const float size = absf(x) + absf(y);
  const float turn = size > 0 ? y / size : 0.0f;
  return x < 0 ? 2.0f - turn : (turn < 0 ? 4.0f + turn : turn);
}

// Sorts the ring around its middle by insertion.
OBBY_DEVICE void sortRing(Vec3* ring, int count, Vec3 normal) {
  Vec3 middle{};
  for (int i = 0; i < count; ++i) middle += ring[i];
  middle = middle * (1.0f / float(count));
  const Vec3 u = normalize(ring[0] - middle), v = cross(normal, u);
  float angle[kMaxRing];
  for (int i = 0; i < count; ++i) {
    const Vec3 at = ring[i], d = at - middle;
    const float a = pseudoAngle(dot(d, u), dot(d, v));
    int k = i;
    for (; k > 0 && angle[k - 1] > a; --k) angle[k] = angle[k - 1], ring[k] = ring[k - 1];
    angle[k] = a;
    ring[k] = at;
  }
}

}  // namespace internal

// Writes the corners of the face that looks most along `d`, and returns their number. If the face
// has more than kMaxFeature corners, the ones kept are evenly spread.
OBBY_DEVICE int hullFace(const Hull& hull, Vec3 d, Vec3* out) {
  uint32_t face = 0;
  for (uint32_t i = 1; i < hull.faceCount; ++i) {
    if (dot(d, hull.normals[i]) > dot(d, hull.normals[face])) face = i;
  }
  const Vec3 normal = hull.normals[face];
  Vec3 ring[internal::kMaxRing];
  int count = 0;
  for (uint32_t i = 0; i < hull.vertexCount && count < internal::kMaxRing; ++i) {
    const Vec3 v = hull.vertices[i];
    const float below = hull.offsets[face] - dot(normal, v);
    // The offset is negative if the face looks toward the part's centre, which may be outside the
    // hull.
    if (below < 1e-3f + 1e-5f * absf(hull.offsets[face])) ring[count++] = v;
  }
  if (count == 0) return 0;
  internal::sortRing(ring, count, normal);
  const int kept = count < kMaxFeature ? count : kMaxFeature;
  for (int i = 0; i < kept; ++i) out[i] = ring[i * count / kept];
  return kept;
}

}  // namespace obby::geom
