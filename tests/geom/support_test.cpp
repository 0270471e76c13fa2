// Compares support functions and separating axes with the corners and definitions of the shapes.
#include <gtest/gtest.h>

#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::Dice;

float support(ShapeKind kind, const ShapeData& s, Vec3 d) {
  return visitShape(kind, [&](auto shape) { return decltype(shape)::support(s, d); });
}

class Support : public testing::TestWithParam<ShapeKind> {
 protected:
  ShapeData shape() {
    return {GetParam() == ShapeKind::hull ? Vec3{1, 1, 1} : dice_.half(), &hull_};
  }
  Dice dice_{100 + uint64_t(GetParam())};
  test::HullFixture fixture_ = test::octahedron();
  Hull hull_ = fixture_.hull();
};

TEST_P(Support, IsTheFarthestPoint) {
  const bool round = GetParam() == ShapeKind::ball || GetParam() == ShapeKind::cylinder;
  for (int i = 0; i < 2000; ++i) {
    const ShapeData s = shape();
    const Vec3 d = dice_.direction() * dice_.between(0.1f, 3);
    if (!round) {
      float best = -1e9f;
      for (const Vec3 p : test::corners(GetParam(), s)) best = maxf(best, dot(d, p));
      ASSERT_NEAR(support(GetParam(), s, d), best, 1e-4f);
    }
    // No point of the shape is farther in this direction.
    const Vec3 p = mul(s.half, dice_.vec(1));
    if (test::contains(GetParam(), s, p)) {
      ASSERT_LE(dot(d, p), support(GetParam(), s, d) + 1e-4f);
    }
  }
}

TEST_P(Support, RoundShapesReachTheirSupport) {
  for (int i = 0; i < 500; ++i) {
    const ShapeData s = shape();
    const Vec3 d = dice_.direction();
    const float r = minf(s.half.y, s.half.z);
    if (GetParam() == ShapeKind::ball) {
      ASSERT_NEAR(support(GetParam(), s, d), minf(s.half.x, r), 1e-4f);
    }
    if (GetParam() == ShapeKind::cylinder) {
      const Vec3 rim = normalize(Vec3{0, d.y, d.z}) * r;
      ASSERT_NEAR(support(GetParam(), s, d), dot(d, rim) + absf(d.x) * s.half.x, 1e-4f);
    }
  }
}

TEST_P(Support, AxesAndEdgesAreUnitVectors) {
  for (int i = 0; i < 50; ++i) {
    const ShapeData s = shape();
    visitShape(GetParam(), [&](auto kind) {
      using Shape = decltype(kind);
      for (int a = 0; a < Shape::axes(s); ++a) EXPECT_NEAR(length(Shape::axis(s, a)), 1, 1e-5f);
      for (int e = 0; e < Shape::edges(s); ++e) EXPECT_NEAR(length(Shape::edge(s, e)), 1, 1e-5f);
    });
  }
}

// Every edge between corners must be one of the table's directions. An edge runs along the
// intersection of two faces, so it is perpendicular to both of their normals.
TEST_P(Support, EdgesCoverTheIntersectionsOfFaces) {
  if (GetParam() == ShapeKind::ball || GetParam() == ShapeKind::cylinder) GTEST_SKIP() << "round";
  const ShapeData s = shape();
  visitShape(GetParam(), [&](auto kind) {
    using Shape = decltype(kind);
    const auto points = test::corners(GetParam(), s);
    const auto onFace = [&](Vec3 n, Vec3 p) { return dot(n, p) > Shape::support(s, n) - 1e-4f; };
    for (size_t a = 0; a < points.size(); ++a) {
      for (size_t b = a + 1; b < points.size(); ++b) {
        int common = 0;
        for (int f = 0; f < Shape::axes(s); ++f) {
          for (const Vec3 n : {Shape::axis(s, f), -Shape::axis(s, f)}) {
            int corners = 0;
            for (const Vec3 p : points) corners += onFace(n, p);
            common += corners >= 3 && onFace(n, points[a]) && onFace(n, points[b]);
          }
        }
        if (common < 2) continue;
        const Vec3 edge = normalize(points[b] - points[a]);
        bool known = false;
        for (int e = 0; e < Shape::edges(s); ++e)
          known = known || absf(dot(Shape::edge(s, e), edge)) > 0.9999f;
        EXPECT_TRUE(known) << edge.x << " " << edge.y << " " << edge.z;
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(EveryShape, Support, testing::ValuesIn(test::kKinds));

}  // namespace
}  // namespace obby::geom
