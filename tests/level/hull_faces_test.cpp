// The faces of a hull equal, bit for bit, those found by testing every triple of its vertices.
#include "level/hull_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "base/random.h"

namespace obby::level {
namespace {

constexpr float kTolerance = 1e-4f, kSame = 1 - 1e-5f;

// The reference: tests every triple against all vertices, and every face against all faces.
class Plainly {
 public:
  Plainly(const std::vector<Vec3>& vertices, float size) : size_(size) {
    hull.vertices = vertices;
    for (size_t a = 0; a < vertices.size(); ++a) {
      for (size_t b = a + 1; b < vertices.size(); ++b) {
        for (size_t c = b + 1; c < vertices.size(); ++c) tryTriangle(a, b, c);
      }
    }
    if (hull.normals.size() < 4) hull.normals.clear(), hull.offsets.clear();
    findEdges();
  }

  HullTables hull;

 private:
  float tolerance() const { return size_ * kTolerance; }
  bool isOn(size_t f, Vec3 p) const {
    return dot(hull.normals[f], p) > hull.offsets[f] - tolerance();
  }

  void tryTriangle(size_t a, size_t b, size_t c) {
    const auto& v = hull.vertices;
    const Vec3 area = cross(v[b] - v[a], v[c] - v[a]);
    if (length(area) < tolerance() * size_) return;
    const Vec3 up = normalize(area);
    for (const Vec3 n : {up, -up}) {
      const float offset = dot(n, v[a]);
      bool adds = true;
      for (const Vec3 p : v) adds = adds && !(dot(n, p) > offset + tolerance());
      for (size_t f = 0; f < hull.normals.size() && adds; ++f) {
        const bool holds = isOn(f, v[a]) && isOn(f, v[b]) && isOn(f, v[c]);
        adds = !(holds && dot(hull.normals[f], n) > kSame);
      }
      if (adds) hull.normals.push_back(n), hull.offsets.push_back(offset);
    }
  }

  void findEdges() {
    for (size_t a = 0; a < hull.vertices.size(); ++a) {
      for (size_t b = a + 1; b < hull.vertices.size(); ++b) {
        const Vec3 p = hull.vertices[a], q = hull.vertices[b];
        int common = 0;
        for (size_t f = 0; f < hull.normals.size(); ++f) common += isOn(f, p) && isOn(f, q);
        if (common < 2) continue;
        const Vec3 e = normalize(q - p);
        bool fresh = true;
        for (const Vec3 known : hull.edges) fresh = fresh && std::fabs(dot(known, e)) < kSame;
        if (fresh) hull.edges.push_back(e);
        if (hull.edges.size() > kMaxHullEdges) {
          hull.edges.clear();
          return;
        }
      }
    }
  }

  float size_;
};

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectPlain(const std::vector<Vec3>& vertices, const char* what) {
  float size = 0;
  for (const Vec3 p : vertices) size = maxf(size, length(p - vertices[0]));
  HullTables hull;
  hull.vertices = vertices;
  findFaces(hull, size, size * kTolerance);
  const HullTables plain = Plainly(vertices, size).hull;
  EXPECT_TRUE(sameBytes(hull.normals, plain.normals))
      << what << ": " << hull.normals.size() << " faces, not " << plain.normals.size();
  EXPECT_TRUE(sameBytes(hull.offsets, plain.offsets)) << what;
  EXPECT_TRUE(sameBytes(hull.edges, plain.edges)) << what;
}

class HullFaces : public testing::Test {
 protected:
  float number(float size) { return (2 * random.unit() - 1) * size; }
  Vec3 vec(float size) { return {number(size), number(size), number(size)}; }

  // Returns the vertices rotated and moved at random, in random order.
  std::vector<Vec3> placed(std::vector<Vec3> vertices, float away) {
    const Mat3 axes = toMat3(normalize(Quat{number(1), number(1), number(1), 0.3f}));
    const Vec3 at = vec(away);
    for (size_t i = vertices.size(); i > 1; --i) {
      std::swap(vertices[i - 1], vertices[size_t(random.next()) % i]);
    }
    for (Vec3& p : vertices) p = axes * p + at;
    return vertices;
  }

  Random random{15, 0};
};

// Returns two rings of `sides` vertices, `height` studs apart. If the upper ring has radius 0, it
// is a single vertex.
std::vector<Vec3> drum(int sides, float lower, float upper, float height) {
  std::vector<Vec3> out;
  for (int i = 0; i < sides; ++i) {
    const float turn = 6.2831853f * float(i) / float(sides);
    const Vec3 direction{std::cos(turn), 0, std::sin(turn)};
    out.push_back(direction * lower);
    if (upper > 0 || i == 0) out.push_back(direction * upper + Vec3{0, height, 0});
  }
  return out;
}

TEST_F(HullFaces, RoundHullsMatchTheFacesOfAllTriples) {
  for (const size_t count : {4u, 5u, 9u, 33u, 90u}) {
    std::vector<Vec3> ball, cloud;
    for (size_t i = 0; i < count; ++i) {
      ball.push_back(normalize(vec(1)) * 3);
      cloud.push_back(vec(2));
    }
    expectPlain(ball, "ball");
    expectPlain(placed(ball, 4000), "ball far away");
    expectPlain(cloud, "cloud");
    for (Vec3& p : cloud) p = mul(p, {50, 1, 0.3f});
    expectPlain(placed(cloud, 10), "beam");
  }
}

TEST_F(HullFaces, LargeHullsMatchTheFacesOfAllTriples) {
  for (const int sides : {3, 8, 40}) {
    expectPlain(placed(drum(sides, 2, 2, 1), 10), "prism");
    expectPlain(placed(drum(sides, 2, 1, 1), 900), "frustum");
    expectPlain(placed(drum(sides, 2, 0, 3), 10), "cone");
    expectPlain(placed(drum(sides, 20, 20, 0.01f), 10), "disc");
  }
  std::vector<Vec3> grid;
  for (int i = 0; i < 64; ++i) grid.push_back({float(i % 4), float(i / 4 % 4), float(i / 16)});
  expectPlain(grid, "grid");
  expectPlain(placed(grid, 100), "grid turned");
}

TEST_F(HullFaces, FlatHullsMatchTheFacesOfAllTriples) {
  std::vector<Vec3> flat, line;
  for (int i = 0; i < 40; ++i) {
    flat.push_back({number(5), 0, number(5)});
    line.push_back({number(5), 0, 0});
  }
  expectPlain(flat, "flat");
  expectPlain(placed(flat, 300), "flat, turned");
  expectPlain(placed(line, 10), "line");
  for (Vec3& p : flat) p.y = number(1e-3f);
  expectPlain(placed(flat, 10), "nearly flat");
  expectPlain({{1, 2, 3}}, "point");
}

}  // namespace
}  // namespace obby::level
