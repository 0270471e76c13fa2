#include "view/picture/facets.h"

#include <algorithm>

namespace obby::view {

namespace {

constexpr float kFlat = 1e-3f;  // studs that a corner may be below its face

// A convex polytope in its own frame. Normals need not be unit vectors.
struct Polytope {
  std::vector<Vec3> corners, normals;
};

Polytope blockOf(Vec3 h) {
  Polytope out;
  for (int i = 0; i < 8; ++i)
    out.corners.push_back({i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z});
  out.normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  return out;
}

// The slope rises to +z.
Polytope wedgeOf(Vec3 h) {
  return {{{-h.x, -h.y, -h.z},
           {h.x, -h.y, -h.z},
           {h.x, -h.y, h.z},
           {-h.x, -h.y, h.z},
           {-h.x, h.y, h.z},
           {h.x, h.y, h.z}},
          {{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, h.z, -h.y}}};
}

// The upper corner is at +x, -z.
Polytope cornerWedgeOf(Vec3 h) {
  return {{{-h.x, -h.y, -h.z},
           {h.x, -h.y, -h.z},
           {h.x, -h.y, h.z},
           {-h.x, -h.y, h.z},
           {h.x, h.y, -h.z}},
          {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {-h.y, h.x, 0}, {0, h.z, h.y}}};
}

Polytope polytopeOf(const Solid& solid) {
  switch (solid.kind) {
    case geom::ShapeKind::block:
    case geom::ShapeKind::truss: return blockOf(solid.shape.half);
    case geom::ShapeKind::wedge: return wedgeOf(solid.shape.half);
    case geom::ShapeKind::cornerWedge: return cornerWedgeOf(solid.shape.half);
    case geom::ShapeKind::hull: {
      const geom::Hull& hull = *solid.shape.hull;
      return {{hull.vertices, hull.vertices + hull.vertexCount},
              {hull.normals, hull.normals + hull.faceCount}};
    }
    default: return {};
  }
}

}  // namespace

std::vector<Facet> facetsOf(const Solid& solid) {
  const Polytope polytope = polytopeOf(solid);
  std::vector<Facet> out;
  for (const Vec3 along : polytope.normals) {
    const Vec3 normal = normalize(along);
    float top = -1e30f;
    for (const Vec3 corner : polytope.corners) top = std::max(top, dot(corner, normal));
    Facet& facet = out.emplace_back();
    facet.normal = solid.pose.rotation * normal;
    for (const Vec3 corner : polytope.corners) {
      if (dot(corner, normal) >= top - kFlat) facet.corners.push_back(toWorld(solid.pose, corner));
    }
  }
  return out;
}

}  // namespace obby::view
