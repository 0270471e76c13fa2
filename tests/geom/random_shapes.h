// Random shapes, poses and boxes for the tests of geom. Points of a shape, by its definition, are
// the reference for the code under test.
#pragma once

#include <cmath>
#include <vector>

#include "base/random.h"
#include "geom/contact.h"
#include "geom/shapes/table.h"

namespace obby::geom::test {

constexpr ShapeKind kKinds[] = {ShapeKind::block, ShapeKind::ball,        ShapeKind::cylinder,
                                ShapeKind::wedge, ShapeKind::cornerWedge, ShapeKind::truss,
                                ShapeKind::hull};

// The tables of an octahedron with its corners at -1 and 1 on the axes, and of a cube of half
// extent 1.
struct HullFixture {
  std::vector<Vec3> vertices, normals, edges;
  std::vector<float> offsets;
  Hull hull() const {
    return {
        vertices.data(),           normals.data(),           offsets.data(),        edges.data(),
        uint32_t(vertices.size()), uint32_t(normals.size()), uint32_t(edges.size())};
  }
};

inline HullFixture octahedron() {
  HullFixture f;
  for (int i = 0; i < 3; ++i) {
    f.vertices.push_back(unitAxis(i));
    f.vertices.push_back(-unitAxis(i));
    for (int sign = -1; sign <= 1; sign += 2) {
      f.edges.push_back(normalize(unitAxis(i) + unitAxis((i + 1) % 3) * float(sign)));
    }
  }
  for (int c = 0; c < 8; ++c) {
    f.normals.push_back(
        normalize(Vec3{c & 1 ? 1.f : -1.f, c & 2 ? 1.f : -1.f, c & 4 ? 1.f : -1.f}));
    f.offsets.push_back(1 / std::sqrt(3.0f));
  }
  return f;
}

inline HullFixture cube() {
  HullFixture f;
  for (int c = 0; c < 8; ++c) {
    f.vertices.push_back({c & 1 ? 1.f : -1.f, c & 2 ? 1.f : -1.f, c & 4 ? 1.f : -1.f});
  }
  for (int i = 0; i < 3; ++i) {
    f.edges.push_back(unitAxis(i));
    f.normals.push_back(unitAxis(i));
    f.normals.push_back(-unitAxis(i));
    f.offsets.insert(f.offsets.end(), {1, 1});
  }
  return f;
}

class Dice {
 public:
  explicit Dice(uint64_t stream) : random_(20, stream) {}
  float between(float lo, float hi) { return lo + (hi - lo) * random_.unit(); }
  Vec3 vec(float size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  Vec3 direction() {
    while (true) {
      const Vec3 v = vec(1);
      const float n = length(v);
      if (n > 0.1f && n < 1) return v * (1 / n);
    }
  }
  Vec3 half() { return {between(0.1f, 4), between(0.1f, 4), between(0.1f, 4)}; }
  Mat3 rotation() {
    const Vec3 x = direction(), z = normalize(cross(x, direction()), {0, 0, 1});
    return toMat3Axes(x, z);
  }
  Turns turns() { return Turns(random_.next()); }
  UprightBox body(float spread) {
    return {vec(spread), {between(0.2f, 2), between(0.2f, 2), between(0.2f, 2)}, sinCos(turns())};
  }
  Random& random() { return random_; }

 private:
  static Mat3 toMat3Axes(Vec3 x, Vec3 z) { return {x, normalize(cross(z, x)), z}; }
  Random random_;
};

// Returns true if a local point lies in the shape grown by `slack` studs, by the shape's
// definition.
inline bool contains(ShapeKind kind, const ShapeData& s, Vec3 p, float slack = 0) {
  const Vec3 h = s.half + Vec3{slack, slack, slack};
  const bool inBox = absf(p.x) <= h.x && absf(p.y) <= h.y && absf(p.z) <= h.z;
  switch (kind) {
    case ShapeKind::block:
    case ShapeKind::truss: return inBox;
    case ShapeKind::ball: return length(p) <= minf(s.half.x, minf(s.half.y, s.half.z)) + slack;
    case ShapeKind::cylinder:
      return absf(p.x) <= h.x && std::hypot(p.y, p.z) <= minf(s.half.y, s.half.z) + slack;
    case ShapeKind::wedge: {  // below the plane from the edge at -Z to the edge at +Z
      const Vec3 up = normalize(Vec3{0, s.half.z, -s.half.y});
      return inBox && dot(up, p) <= slack;
    }
    case ShapeKind::cornerWedge: {
      const Vec3 a = normalize(Vec3{-s.half.y, s.half.x, 0});
      const Vec3 b = normalize(Vec3{0, s.half.z, s.half.y});
      return inBox && dot(a, p) <= slack && dot(b, p) <= slack;
    }
    case ShapeKind::hull:
      for (uint32_t f = 0; f < s.hull->faceCount; ++f) {
        if (dot(s.hull->normals[f], p) > s.hull->offsets[f] + slack) return false;
      }
      return true;
  }
  return false;
}

// Returns the shape's corners. The shape must have corners.
inline std::vector<Vec3> corners(ShapeKind kind, const ShapeData& s) {
  std::vector<Vec3> out;
  if (kind == ShapeKind::hull) {
    out.assign(s.hull->vertices, s.hull->vertices + s.hull->vertexCount);
    return out;
  }
  for (int c = 0; c < 8; ++c) {
    const Vec3 sign{c & 1 ? 1.f : -1.f, c & 2 ? 1.f : -1.f, c & 4 ? 1.f : -1.f};
    if (kind == ShapeKind::wedge && sign.y > 0 && sign.z < 0) continue;
    if (kind == ShapeKind::cornerWedge && sign.y > 0 && (sign.x < 0 || sign.z > 0)) continue;
    out.push_back(mul(s.half, sign));
  }
  return out;
}

}  // namespace obby::geom::test
