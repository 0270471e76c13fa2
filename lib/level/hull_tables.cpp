// Every triple of vertices with all others on one side is a face: cubic in the vertex count, at
// most 255, and run once a level. Exactness matters more than speed here: no incremental structure
// that could go wrong.
#include "level/hull_tables.h"

#include <cmath>
#include <utility>

namespace obby::level {
namespace {

constexpr float kTolerance = 1e-4f;  // share of the hull's size

std::vector<Vec3> distinct(const std::vector<Vec3>& points, float tolerance) {
  std::vector<Vec3> out;
  for (const Vec3 p : points) {
    bool fresh = true;
    for (const Vec3 q : out) fresh = fresh && length(p - q) > tolerance;
    if (fresh) out.push_back(p);
  }
  return out;
}

// Is dot(n, p) <= offset for all vertices?
bool isFace(const std::vector<Vec3>& vertices, Vec3 n, float offset, float tolerance) {
  for (const Vec3 p : vertices) {
    if (dot(n, p) > offset + tolerance) return false;
  }
  return true;
}

// A face through three corners, unless they lie on one that is known.
void addFace(HullTables& hull, Vec3 n, const Vec3 (&corners)[3], float tolerance) {
  for (size_t f = 0; f < hull.normals.size(); ++f) {
    bool same = dot(hull.normals[f], n) > 1 - 1e-5f;
    for (const Vec3 p : corners) {
      same = same && dot(hull.normals[f], p) > hull.offsets[f] - tolerance;
    }
    if (same) return;
  }
  const float offset = dot(n, corners[0]);
  hull.normals.push_back(n);
  hull.offsets.push_back(offset);
}

// Two vertices that lie on two common faces are joined by an edge.
void findEdges(HullTables& hull, float tolerance) {
  const auto on = [&](size_t f, Vec3 p) {
    return dot(hull.normals[f], p) > hull.offsets[f] - tolerance;
  };
  for (size_t a = 0; a < hull.vertices.size(); ++a) {
    for (size_t b = a + 1; b < hull.vertices.size(); ++b) {
      int common = 0;
      for (size_t f = 0; f < hull.normals.size() && common < 2; ++f) {
        common += on(f, hull.vertices[a]) && on(f, hull.vertices[b]);
      }
      if (common < 2) continue;
      const Vec3 e = normalize(hull.vertices[b] - hull.vertices[a]);
      bool fresh = true;
      for (const Vec3 known : hull.edges) fresh = fresh && std::fabs(dot(known, e)) < 1 - 1e-5f;
      if (fresh) hull.edges.push_back(e);
      if (hull.edges.size() > kMaxHullEdges) {
        hull.edges.clear();
        return;
      }
    }
  }
}

}  // namespace

HullTables hullTables(const std::vector<Vec3>& vertices) {
  float size = 0;
  for (const Vec3 p : vertices) size = maxf(size, length(p - vertices[0]));
  const float tolerance = size * kTolerance;
  HullTables hull;
  hull.vertices = distinct(vertices, tolerance);
  const auto& v = hull.vertices;
  for (size_t a = 0; a < v.size(); ++a) {
    for (size_t b = a + 1; b < v.size(); ++b) {
      for (size_t c = b + 1; c < v.size(); ++c) {
        const Vec3 area = cross(v[b] - v[a], v[c] - v[a]);
        if (length(area) < tolerance * size) continue;  // a sliver
        const Vec3 n = normalize(area);
        const Vec3 corners[3] = {v[a], v[b], v[c]};
        if (isFace(v, n, dot(n, v[a]), tolerance)) addFace(hull, n, corners, tolerance);
        if (isFace(v, -n, dot(-n, v[a]), tolerance)) addFace(hull, -n, corners, tolerance);
      }
    }
  }
  if (hull.normals.size() < 4) hull.normals.clear(), hull.offsets.clear();
  findEdges(hull, tolerance);
  return hull;
}

geom::Hull viewOf(const HullTables& t) {
  return {t.vertices.data(),
          t.normals.data(),
          t.offsets.data(),
          t.edges.data(),
          uint32_t(t.vertices.size()),
          uint32_t(t.normals.size()),
          uint32_t(t.edges.size())};
}

const geom::Hull* HullStore::hullOf(const std::vector<Vec3>& vertices) {
  const auto* const bytes = reinterpret_cast<const char*>(vertices.data());
  const auto [known, isNew] =
      known_.try_emplace(std::string(bytes, vertices.size() * sizeof(Vec3)), nullptr);
  if (!isNew) return known->second;
  HullTables tables = hullTables(vertices);
  if (tables.normals.empty()) return nullptr;
  tables_.push_back(std::move(tables));
  views_.push_back(viewOf(tables_.back()));
  known->second = &views_.back();
  return known->second;
}

}  // namespace obby::level
