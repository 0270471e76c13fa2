// The exact answer for two polytopes, in double precision and from their corners alone. It decides
// when an outside library and lib/geom differ. It finds faces and edges by brute force, so it
// depends on no table of lib/.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "geom/random_shapes.h"

namespace obby::parity {

using V3 = Eigen::Vector3d;

inline V3 wide(Vec3 v) { return {double(v.x), double(v.y), double(v.z)}; }

// Corners in the world, unit normals of faces, and unit directions of edges. Directions may repeat.
struct Polytope {
  std::vector<V3> points, faces, edges;
};

inline void addDirection(std::vector<V3>& known, const V3& n) {
  for (const V3& k : known) {
    if (std::abs(k.dot(n)) > 1 - 1e-12) return;
  }
  known.push_back(n);
}

// Fills in faces and edges. A triple of corners is a face if all other corners lie on one side. Two
// corners that share two faces are joined by an edge.
inline void findFacesAndEdges(Polytope& p) {
  double size = 0;
  for (const V3& a : p.points) size = std::max(size, (a - p.points[0]).norm());
  const double near = 1e-9 * size;
  std::vector<std::vector<bool>> onFace;
  const size_t count = p.points.size();
  for (size_t a = 0; a < count; ++a) {
    for (size_t b = a + 1; b < count; ++b) {
      for (size_t c = b + 1; c < count; ++c) {
        const V3 area = (p.points[b] - p.points[a]).cross(p.points[c] - p.points[a]);
        if (area.norm() < near * size) continue;
        const V3 n = area.normalized();
        double max = -1e300, min = 1e300;
        for (const V3& q : p.points) {
          const double at = n.dot(q - p.points[a]);
          max = std::max(max, at), min = std::min(min, at);
        }
        if (max > near && min < -near) continue;
        addDirection(p.faces, n);
        std::vector<bool> on;
        for (const V3& q : p.points) on.push_back(std::abs(n.dot(q - p.points[a])) <= near);
        if (std::find(onFace.begin(), onFace.end(), on) == onFace.end()) onFace.push_back(on);
      }
    }
  }
  for (size_t a = 0; a < count; ++a) {
    for (size_t b = a + 1; b < count; ++b) {
      int common = 0;
      for (const auto& face : onFace) common += face[a] && face[b];
      if (common >= 2) addDirection(p.edges, (p.points[b] - p.points[a]).normalized());
    }
  }
}

inline Polytope polytopeOf(geom::ShapeKind kind, const geom::ShapeData& shape, const Pose& pose) {
  Polytope p;
  const Mat3& r = pose.rotation;
  const V3 x = wide(r.x), y = wide(r.y), z = wide(r.z), at = wide(pose.position);
  for (const Vec3 c : geom::test::corners(kind, shape)) {
    p.points.push_back(at + x * double(c.x) + y * double(c.y) + z * double(c.z));
  }
  if (kind == geom::ShapeKind::block || kind == geom::ShapeKind::truss) {
    p.faces = p.edges = {x.normalized(), y.normalized(), z.normalized()};
  } else {
    findFacesAndEdges(p);
  }
  return p;
}

inline Polytope polytopeOf(const geom::UprightBox& box) {
  return polytopeOf(geom::ShapeKind::block, {box.half, nullptr}, {box.center, box.axes()});
}

inline Polytope moved(Polytope p, const Pose& pose) {
  const Mat3& r = pose.rotation;
  Eigen::Matrix3d m;
  m << wide(r.x), wide(r.y), wide(r.z);
  for (V3& q : p.points) q = m * q + wide(pose.position);
  for (V3& n : p.faces) n = (m * n).normalized();
  for (V3& e : p.edges) e = (m * e).normalized();
  return p;
}

// The minimum translation that separates the two, exact up to the rounding of doubles.
struct Exact {
  double depth = 1e300;  // if negative, the two are apart by at least this much
  V3 normal;             // moving the second polytope along the normal separates the two
  double next = 1e300;   // depth along the best axis in a clearly different direction
};

class SeparatingAxes {
 public:
  SeparatingAxes(const Polytope& a, const Polytope& b) : a_(a), b_(b) {
    for (const V3& n : a.faces) test(n);
    for (const V3& n : b.faces) test(n);
    for (const V3& e : a.edges) {
      for (const V3& f : b.edges) {
        const V3 n = e.cross(f);
        if (n.norm() > 1e-10) test(n.normalized());
      }
    }
  }

  Exact result() const {
    Exact best;
    for (const auto& [depth, n] : axes_) {
      if (depth < best.depth) best.depth = depth, best.normal = n;
    }
    for (const auto& [depth, n] : axes_) {
      if (n.dot(best.normal) < 0.999) best.next = std::min(best.next, depth);
    }
    return best;
  }

 private:
  void test(const V3& n) {
    const auto [aLow, aHigh] = span(a_, n);
    const auto [bLow, bHigh] = span(b_, n);
    axes_.emplace_back(aHigh - bLow, n);
    axes_.emplace_back(bHigh - aLow, -n);
  }
  static std::pair<double, double> span(const Polytope& p, const V3& n) {
    double low = 1e300, high = -1e300;
    for (const V3& q : p.points) {
      const double at = n.dot(q);
      low = std::min(low, at), high = std::max(high, at);
    }
    return {low, high};
  }

  const Polytope& a_;
  const Polytope& b_;
  std::vector<std::pair<double, V3>> axes_;
};

inline Exact exactPenetration(const Polytope& shape, const Polytope& box) {
  return SeparatingAxes(shape, box).result();
}

}  // namespace obby::parity
