// Common to all shapes: their kinds, their data, and the tables of a convex hull.
//
// A shape is one header in geom/shapes/ with these static functions over local coordinates (the
// shape's own frame, centred, half extents `half`), and one row in geom/shapes/table.h:
//   support(s, d)       largest dot(d, p) over the points p of the shape; d has any length
//   corner(s, d)        a point with that largest product
//   feature(s, d, out)  the face that looks along the unit vector d, as a ring of at most
//                       kMaxFeature corners; a line or a point where the shape is curved;
//                       returns the number of corners
//   axes(s), axis(s,i)  unit normals of faces, one for two parallel faces
//   edges(s), edge(s,i) unit directions of edges
//   roundAxis(s, body)  direction of the closest approach of curved faces; zero if there are none
//   castRay(s, o, d, tMax, hit)
//                       first entry of the ray o + t d, 0 <= t <= tMax, from outside
#pragma once

#include <stdint.h>

#include "math/vec.h"

namespace obby::geom {

// The values have the order of the schema's Shape.
enum class ShapeKind : uint8_t { block, ball, cylinder, wedge, cornerWedge, truss, hull };

constexpr int kMaxFeature = 8;

// A convex polytope, as spans of the level's tables.
struct Hull {
  const Vec3* vertices = nullptr;  // (vertexCount), studs, local frame
  const Vec3* normals = nullptr;   // (faceCount), unit, outward
  const float* offsets = nullptr;  // (faceCount), dot(normal, p) <= offset inside
  const Vec3* edges = nullptr;     // (edgeCount), unit, each direction once
  uint32_t vertexCount = 0, faceCount = 0, edgeCount = 0;
};

// Calls table(pointer, count) for every table that the struct points to, with one line for each
// table. base/flatten.h uses this to copy levels to other memory.
template <class Table>
OBBY_DEVICE void forTables(Hull& h, Table&& table) {
  table(h.vertices, h.vertexCount);
  table(h.normals, h.faceCount);
  table(h.offsets, h.faceCount);
  table(h.edges, h.edgeCount);
}

struct ShapeData {
  Vec3 half;                   // half extents of the bounding box, studs
  const Hull* hull = nullptr;  // only for ShapeKind::hull
};

// The first point of a shape that a ray meets.
struct RayHit {
  float t;      // along the ray, in units of its direction
  Vec3 normal;  // unit, local, outward
};

// A block at any pose, for one world or for lanes of worlds.
template <class F>
struct BlockT {
  PoseT<F> pose;
  Vec3T<F> half;  // half extents, studs
};

// An oriented box in a shape's local frame. The shape's curved faces are tested against it.
template <class F>
struct LocalBoxT {
  Vec3T<F> center;  // studs
  Mat3T<F> axes;
  Vec3T<F> half;  // half extents, studs
};

using LocalBox = LocalBoxT<float>;

// Returns the point of the box that is closest to p: p itself if it is inside.
OBBY_DEVICE Vec3 closestPoint(const LocalBox& box, Vec3 p) {
  const Vec3 d = toLocal(box.axes, p - box.center);
  return box.center + box.axes * max(min(d, box.half), -box.half);
}

// Returns `v`, or a tiny divisor instead of zero, so that slab tests need no branches. 1e-20 studs
// is far below any float position.
template <class F>
OBBY_DEVICE F awayFromZero(F v) {
  return select(absf(v) < 1e-20f, select(v < 0.0f, F(-1e-20f), F(1e-20f)), v);
}

// Clips the ray o + t d, with t in [enter, leave], to the half space dot(n, p) <= offset. Updates
// `enter`, `leave` and the normal of the entry. Nothing is left if enter > leave afterwards.
OBBY_DEVICE void clipToPlane(Vec3 n, float offset, Vec3 o, Vec3 d, float& enter, float& leave,
                             Vec3& normal) {
  const float speed = dot(n, d);
  const float t = (offset - dot(n, o)) / awayFromZero(speed);
  if (speed < 0) {
    if (t > enter) {
      enter = t;
      normal = n;
    }
  } else {
    leave = minf(leave, t);
  }
}

}  // namespace obby::geom
