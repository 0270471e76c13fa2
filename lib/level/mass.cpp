// Volume integrals over tetrahedra from the origin to the faces, in double precision. Rounding to
// float hides differences that come from the order of summation.
#include "level/mass.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "level/hull_tables.h"

namespace obby::level {
namespace {

constexpr double kTwoPi = 2 * 3.14159265358979323846;

// Integrals of 1, x and x x^T over a volume.
struct Moments {
  double volume = 0, first[3] = {}, second[3][3] = {};

  void add(const Moments& m) {
    volume += m.volume;
    for (int i = 0; i < 3; ++i) {
      first[i] += m.first[i];
      for (int j = 0; j < 3; ++j) second[i][j] += m.second[i][j];
    }
  }
};

Moments diagonal(double volume, double xx, double yy, double zz) {
  Moments m;
  m.volume = volume;
  m.second[0][0] = volume * xx, m.second[1][1] = volume * yy, m.second[2][2] = volume * zz;
  return m;
}

// Returns the moments of the tetrahedron of the origin and three corners. They are negative if the
// corners have the opposite orientation.
Moments tetrahedron(Vec3 a, Vec3 b, Vec3 c) {
  const double p[3][3] = {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
  const double det = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                     p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                     p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  Moments m;
  m.volume = det / 6;
  double sum[3];
  for (int i = 0; i < 3; ++i) sum[i] = p[0][i] + p[1][i] + p[2][i];
  for (int i = 0; i < 3; ++i) {
    m.first[i] = det / 24 * sum[i];
    for (int j = 0; j < 3; ++j) {
      double products = sum[i] * sum[j];
      for (const auto& corner : p) products += corner[i] * corner[j];
      m.second[i][j] = det / 120 * products;
    }
  }
  return m;
}

// Returns the max distance by which a corner of a face may lie below it. It is less than the
// thickness of a thin hull.
float slackOf(const geom::Hull& hull) {
  float size = 0;
  for (uint32_t i = 0; i < hull.vertexCount; ++i) size = maxf(size, length(hull.vertices[i]));
  const float max = 1e-3f * size;
  float slack = max;
  for (uint32_t f = 0; f < hull.faceCount; ++f) {
    float width = 0;
    for (uint32_t i = 0; i < hull.vertexCount; ++i)
      width = maxf(width, hull.offsets[f] - dot(hull.normals[f], hull.vertices[i]));
    if (width < max) slack = minf(slack, 0.1f * width);
  }
  return slack;
}

// Returns the corners of a face, counter-clockwise as seen from outside.
std::vector<Vec3> ringOf(const geom::Hull& hull, uint32_t face, float slack) {
  const Vec3 n = hull.normals[face];
  std::vector<Vec3> ring;
  for (uint32_t i = 0; i < hull.vertexCount; ++i) {
    if (dot(n, hull.vertices[i]) > hull.offsets[face] - slack) ring.push_back(hull.vertices[i]);
  }
  if (ring.empty()) return ring;
  Vec3 middle;
  for (const Vec3 p : ring) middle += p * (1.0f / float(ring.size()));
  const Vec3 u = normalize(ring[0] - middle), v = cross(n, u);
  const auto angle = [&](Vec3 p) {
    return std::atan2(double(dot(p - middle, v)), double(dot(p - middle, u)));
  };
  std::sort(ring.begin(), ring.end(), [&](Vec3 a, Vec3 b) { return angle(a) < angle(b); });
  return ring;
}

Moments polytope(const geom::Hull& hull) {
  Moments m;
  const float slack = slackOf(hull);
  for (uint32_t f = 0; f < hull.faceCount; ++f) {
    const std::vector<Vec3> ring = ringOf(hull, f, slack);
    for (size_t i = 1; i + 1 < ring.size(); ++i) m.add(tetrahedron(ring[0], ring[i], ring[i + 1]));
  }
  return m;
}

std::vector<Vec3> wedgeCorners(Vec3 h) {
  return {{-h.x, -h.y, -h.z}, {h.x, -h.y, -h.z}, {-h.x, -h.y, h.z},
          {h.x, -h.y, h.z},   {-h.x, h.y, h.z},  {h.x, h.y, h.z}};
}
std::vector<Vec3> cornerWedgeCorners(Vec3 h) {
  return {
      {-h.x, -h.y, -h.z}, {h.x, -h.y, -h.z}, {-h.x, -h.y, h.z}, {h.x, -h.y, h.z}, {h.x, h.y, -h.z}};
}

Moments momentsOf(const SolidShape& s) {
  using geom::ShapeKind;
  const double x = s.data.half.x, y = s.data.half.y, z = s.data.half.z;
  switch (s.kind) {
    case ShapeKind::ball: {
      const double r = std::min({x, y, z}), square = r * r / 5;
      return diagonal(kTwoPi * 2 / 3 * r * r * r, square, square, square);
    }
    case ShapeKind::cylinder: {
      const double r = std::min(y, z);
      return diagonal(kTwoPi * r * r * x, x * x / 3, r * r / 4, r * r / 4);
    }
    case ShapeKind::wedge: return polytope(viewOf(hullTables(wedgeCorners(s.data.half))));
    case ShapeKind::cornerWedge:
      return polytope(viewOf(hullTables(cornerWedgeCorners(s.data.half))));
    case ShapeKind::hull: return polytope(*s.data.hull);
    case ShapeKind::block:
    case ShapeKind::truss: break;
  }
  return diagonal(8 * x * y * z, x * x / 3, y * y / 3, z * z / 3);
}

// Returns the inverse of a symmetric matrix.
Mat3 inverse(const double (&m)[3][3]) {
  const auto minor = [&](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  const auto row = [&](int i) {
    return Vec3{float(minor(i, 0) / det), float(minor(i, 1) / det), float(minor(i, 2) / det)};
  };
  return {row(0), row(1), row(2)};
}

}  // namespace

MassProperties massOf(std::span<const SolidShape> shapes, float density) {
  Moments m;
  for (const SolidShape& s : shapes) m.add(momentsOf(s));
  if (!(m.volume > 1e-9) || !(density > 0)) return {};
  double center[3], inertia[3][3];
  for (int i = 0; i < 3; ++i) center[i] = m.first[i] / m.volume;
  double spread = 0;
  for (int i = 0; i < 3; ++i) spread += m.second[i][i] - m.volume * center[i] * center[i];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double own = m.second[i][j] - m.volume * center[i] * center[j];
      inertia[i][j] = density * ((i == j ? spread : 0) - own);
    }
  }
  return {float(m.volume * density),
          {float(center[0]), float(center[1]), float(center[2])},
          inverse(inertia)};
}

}  // namespace obby::level
