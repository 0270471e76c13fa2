// What the shapes have in common: the kinds, the data a shape reads, and a convex hull's tables.
//
// A shape is one header in geom/shapes/ with these static functions over local coordinates (the
// shape's own frame, centred, half extents `half`), and one row in geom/shapes/table.h:
//   support(s, d)       largest dot(d, p) over the points p of the shape; d: any length
//   corner(s, d)        a point with that largest product
//   feature(s, d, out)  the face that looks along the unit vector d, as a ring of corners: at most
//                       kMaxFeature; a line or a point where the shape is curved; gives how many
//   axes(s), axis(s,i)  unit normals of faces, each direction once for parallel faces
//   edges(s), edge(s,i) unit directions of edges
//   roundAxis(s, body)  for shapes with curved faces: the direction of the closest approach, or
//   zero castRay(s, o, d, tMax, hit)  first entry of the ray o + t d, 0 <= t <= tMax, from outside
#pragma once

#include <stdint.h>

#include "math/vec.h"

namespace obby::geom {

// The order of schema Shape.
enum class ShapeKind : uint8_t { block, ball, cylinder, wedge, cornerWedge, truss, hull };

constexpr int kMaxFeature = 8;

// A convex polytope: spans into the level's tables.
struct Hull {
  const Vec3* vertices = nullptr;  // (vertexCount), studs, local frame
  const Vec3* normals = nullptr;   // (faceCount), unit, outward
  const float* offsets = nullptr;  // (faceCount), dot(normal, p) <= offset inside
  const Vec3* edges = nullptr;     // (edgeCount), unit, each direction once
  uint32_t vertexCount = 0, faceCount = 0, edgeCount = 0;
};

// forTables(holder, table) calls table(pointer, count) for every table that a struct points to: one
// line a table. base/flatten.h copies levels to other memory by it.
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

struct RayHit {
  float t;      // along the ray, in units of its direction
  Vec3 normal;  // unit, local, outward
};

// A block anywhere, for one world or lanes of them.
template <class F>
struct BlockT {
  PoseT<F> pose;
  Vec3T<F> half;
};

// An oriented box in a shape's local frame: what the shape's curved faces are tested against.
template <class F>
struct LocalBoxT {
  Vec3T<F> center;
  Mat3T<F> axes;
  Vec3T<F> half;
};

using LocalBox = LocalBoxT<float>;

// The point of the box that is closest to p.
OBBY_DEVICE Vec3 closestPoint(const LocalBox& box, Vec3 p) {
  const Vec3 d = toLocal(box.axes, p - box.center);
  return box.center + box.axes * max(min(d, box.half), -box.half);
}

// A divisor that is never zero, so that slab tests need no branches: 1e-20 studs is far below any
// float position.
template <class F>
OBBY_DEVICE F awayFromZero(F v) {
  return select(absf(v) < 1e-20f, select(v < 0.0f, F(-1e-20f), F(1e-20f)), v);
}

// Clips the ray o + t d to the half space dot(n, p) <= offset. `enter`, `leave` and the entering
// normal are updated.
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
