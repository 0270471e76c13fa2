// Finds the faces of a convex hull. Every triple of vertices with all others on one side is a face.
// This is cubic in the vertex count, which is at most 255, and runs once per level. Exactness
// matters more than speed, so there is no incremental structure that could fail. SIMD lanes reject
// most triples, with the same bits as scalar code: outermost vertices lie on both sides, or the
// face is known. Scalar code tests the other triples.
#include "level/hull_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "simd/wide.h"

namespace obby::level {
namespace {

using WideVec = Vec3T<WideFloat>;

constexpr float kSame = 1 - 1e-5f;  // cosine above which two directions count as equal

OBBY_LANES WideVec inAllLanes(Vec3 p) { return {p.x, p.y, p.z}; }

// Returns true if dot(n, p) <= offset + tolerance for all vertices.
bool isFace(const std::vector<Vec3>& vertices, Vec3 n, float offset, float tolerance) {
  for (const Vec3 p : vertices) {
    if (dot(n, p) > offset + tolerance) return false;
  }
  return true;
}

class FaceFinder {
 public:
  FaceFinder(HullTables& hull, float size, float tolerance)
      : hull_(hull),
        tolerance_(tolerance),
        sliver_(tolerance * size),
        facesAt_(hull.vertices.size()) {
    for (const Vec3 p : hull.vertices) x_.push_back(p.x), y_.push_back(p.y), z_.push_back(p.z);
    for (std::vector<float>* lane : {&x_, &y_, &z_}) lane->resize(lane->size() + size_t(kLanes));
    findOutermost();
  }

  void findFaces() {
    const size_t count = hull_.vertices.size();
    for (size_t a = 0; a < count; ++a) {
      for (size_t b = a + 1; b < count; ++b) {
        findShared(a, b);
        for (size_t c = b + 1; c < count; c += size_t(kLanes)) tryCorners(a, b, c);
      }
    }
  }

  // An edge joins two vertices that share two faces.
  void findEdges() {
    for (size_t a = 0; a < hull_.vertices.size(); ++a) {
      for (size_t b = a + 1; b < hull_.vertices.size(); ++b) {
        findShared(a, b);
        if (shared_.size() < 2) continue;
        const Vec3 e = normalize(hull_.vertices[b] - hull_.vertices[a]);
        bool fresh = true;
        for (const Vec3 known : hull_.edges) fresh = fresh && std::fabs(dot(known, e)) < kSame;
        if (fresh) hull_.edges.push_back(e);
        if (hull_.edges.size() > kMaxHullEdges) {
          hull_.edges.clear();
          return;
        }
      }
    }
  }

 private:
  // Finds the farthest vertices along 26 directions, with opposite ones next to each other.
  void findOutermost() {
    for (int i = 14; i < 27; ++i) {
      const Vec3 d{float(i % 3 - 1), float(i / 3 % 3 - 1), float(i / 9 - 1)};
      for (const Vec3 along : {d, -d}) {
        const auto nearer = [&](Vec3 p, Vec3 q) { return dot(along, p) < dot(along, q); };
        const Vec3 p = *std::max_element(hull_.vertices.begin(), hull_.vertices.end(), nearer);
        const auto same = std::find(outermost_.begin(), outermost_.end(), p);
        if (same == outermost_.end()) outermost_.push_back(p);
      }
    }
  }

  bool isOn(size_t face, Vec3 p) const {
    return dot(hull_.normals[face], p) > hull_.offsets[face] - tolerance_;
  }

  // Sets shared_ to the faces that contain both vertices.
  void findShared(size_t a, size_t b) {
    shared_.clear();
    std::set_intersection(facesAt_[a].begin(), facesAt_[a].end(), facesAt_[b].begin(),
                          facesAt_[b].end(), std::back_inserter(shared_));
  }

  // Tries the triangles of a, b and each vertex of the lanes from `first` on.
  void tryCorners(size_t a, size_t b, size_t first) {
    const size_t known = hull_.normals.size();
    for (uint32_t left = undecided(a, b, first); left != 0; left &= left - 1) {
      tryTriangle(a, b, first + size_t(__builtin_ctz(left)));
    }
    if (hull_.normals.size() != known) findShared(a, b);
  }

  // Returns a bit for each of these triangles that may add a face. tryTriangle() would reject the
  // others: each is a sliver, or has on either side a vertex beyond it or a known face.
  uint32_t undecided(size_t a, size_t b, size_t first) const {
    const WideVec from = inAllLanes(hull_.vertices[a]);
    const WideVec corner{load(&x_[first]), load(&y_[first]), load(&z_[first])};
    const WideVec area = cross(inAllLanes(hull_.vertices[b] - hull_.vertices[a]), corner - from);
    const WideVec n = normalize(area);
    WideMask up = !(length(area) < WideFloat(sliver_)), down = up;
    for (const uint32_t f : shared_) {
      const WideVec normal = inAllLanes(hull_.normals[f]);
      const WideMask on = dot(normal, corner) > WideFloat(hull_.offsets[f] - tolerance_);
      const WideFloat along = dot(normal, n);
      up &= !(on & (along > WideFloat(kSame)));
      down &= !(on & (-along > WideFloat(kSame)));
      if (!any(up | down)) return 0;
    }
    const WideFloat offset = dot(n, from);
    const WideFloat above = offset + WideFloat(tolerance_), below = WideFloat(tolerance_) - offset;
    for (const Vec3 p : outermost_) {
      const WideFloat at = dot(n, inAllLanes(p));
      up &= !(at > above);
      down &= !(-at > below);
      if (!any(up | down)) return 0;
    }
    const size_t left = hull_.vertices.size() - first;
    return bitsOf(up | down) & (left < size_t(kLanes) ? (1u << left) - 1 : ~0u);
  }

  void tryTriangle(size_t a, size_t b, size_t c) {
    const std::vector<Vec3>& v = hull_.vertices;
    const Vec3 area = cross(v[b] - v[a], v[c] - v[a]);
    if (length(area) < sliver_) return;
    const Vec3 n = normalize(area);
    const Vec3 corners[3] = {v[a], v[b], v[c]};
    if (isFace(v, n, dot(n, v[a]), tolerance_)) addFace(n, corners);
    if (isFace(v, -n, dot(-n, v[a]), tolerance_)) addFace(-n, corners);
  }

  // Adds a face through three corners, unless they lie on a known one.
  void addFace(Vec3 n, const Vec3 (&corners)[3]) {
    for (size_t f = 0; f < hull_.normals.size(); ++f) {
      bool same = dot(hull_.normals[f], n) > kSame;
      for (const Vec3 p : corners) same = same && isOn(f, p);
      if (same) return;
    }
    const size_t added = hull_.normals.size();
    hull_.normals.push_back(n);
    hull_.offsets.push_back(dot(n, corners[0]));
    for (size_t i = 0; i < hull_.vertices.size(); ++i) {
      if (isOn(added, hull_.vertices[i])) facesAt_[i].push_back(uint32_t(added));
    }
  }

  HullTables& hull_;
  const float tolerance_, sliver_;  // tolerance in studs; areas below `sliver_` count as zero
  std::vector<float> x_, y_, z_;    // the vertices, padded for the last lanes
  std::vector<Vec3> outermost_;
  std::vector<std::vector<uint32_t>> facesAt_;  // faces of each vertex, ascending
  std::vector<uint32_t> shared_;                // see findShared()
};

}  // namespace

void findFaces(HullTables& hull, float size, float tolerance) {
  FaceFinder finder(hull, size, tolerance);
  finder.findFaces();
  if (hull.normals.size() < 4) {
    hull.normals.clear();
    hull.offsets.clear();
    return;
  }
  finder.findEdges();
}

}  // namespace obby::level
