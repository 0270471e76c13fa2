// Convex hull of a mesh or union. level/hull_tables makes its face and edge tables.
#pragma once

#include "geom/hull_face.h"

namespace obby::geom {

struct ConvexHull {
  OBBY_DEVICE static float support(const ShapeData& s, Vec3 d) {
    float best = -1e30f;
    for (uint32_t i = 0; i < s.hull->vertexCount; ++i)
      best = maxf(best, dot(d, s.hull->vertices[i]));
    return best;
  }
  OBBY_DEVICE static int axes(const ShapeData& s) { return int(s.hull->faceCount); }
  OBBY_DEVICE static Vec3 axis(const ShapeData& s, int i) { return s.hull->normals[i]; }
  OBBY_DEVICE static int edges(const ShapeData& s) { return int(s.hull->edgeCount); }
  OBBY_DEVICE static Vec3 edge(const ShapeData& s, int i) { return s.hull->edges[i]; }
  OBBY_DEVICE static Vec3 roundAxis(const ShapeData&, const LocalBox&) { return {}; }

  OBBY_DEVICE static Vec3 corner(const ShapeData& s, Vec3 d) {
    uint32_t best = 0;
    for (uint32_t i = 1; i < s.hull->vertexCount; ++i) {
      if (dot(d, s.hull->vertices[i]) > dot(d, s.hull->vertices[best])) best = i;
    }
    return s.hull->vertices[best];
  }
  OBBY_DEVICE static int feature(const ShapeData& s, Vec3 d, Vec3* out) {
    return hullFace(*s.hull, d, out);
  }

  OBBY_DEVICE static bool castRay(const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
    float enter = -1e30f, leave = 1e30f;
    Vec3 normal;
    for (uint32_t i = 0; i < s.hull->faceCount; ++i) {
      clipToPlane(s.hull->normals[i], s.hull->offsets[i], o, d, enter, leave, normal);
    }
    if (enter < 0 || enter > leave || enter > tMax) return false;
    hit = {enter, normal};
    return true;
  }
};

}  // namespace obby::geom
