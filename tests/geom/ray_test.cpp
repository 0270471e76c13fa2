// Rays against every shape. Their hits are compared with points along the ray and the shape's
// definition.
#include <gtest/gtest.h>

#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::contains;
using test::Dice;

bool cast(ShapeKind kind, const ShapeData& s, Vec3 o, Vec3 d, float tMax, RayHit& hit) {
  return visitShape(kind, [&](auto shape) { return decltype(shape)::castRay(s, o, d, tMax, hit); });
}

class Rays : public testing::TestWithParam<ShapeKind> {
 protected:
  ShapeData shape() {
    return {GetParam() == ShapeKind::hull ? Vec3{1, 1, 1} : dice_.half(), &hull_};
  }
  // Returns a ray from outside towards a point near the shape.
  std::pair<Vec3, Vec3> ray(const ShapeData& s) {
    const Vec3 from = dice_.direction() * dice_.between(8, 12);
    return {from, normalize(mul(s.half, dice_.vec(1.2f)) - from)};
  }
  Dice dice_{uint64_t(GetParam())};
  test::HullFixture fixture_ = test::octahedron();
  Hull hull_ = fixture_.hull();
};

TEST_P(Rays, HitTheSurfaceAtTheirFirstEntry) {
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const ShapeData s = shape();
    const auto [o, d] = ray(s);
    RayHit hit{};
    if (!cast(GetParam(), s, o, d, 40, hit)) continue;
    ++hits;
    const Vec3 at = o + d * hit.t;
    ASSERT_TRUE(contains(GetParam(), s, at, 1e-3f));
    ASSERT_NEAR(length(hit.normal), 1, 1e-4f);
    ASSERT_LE(dot(hit.normal, d), 1e-4f) << "the normal looks against the ray";
    // No earlier point is inside the shape. The tangent plane at the hit supports the shape, which
    // is convex.
    for (float t = 0; t < hit.t - 0.02f; t += 0.05f)
      ASSERT_FALSE(contains(GetParam(), s, o + d * t, -1e-3f)) << t << " before " << hit.t;
    const float support =
        visitShape(GetParam(), [&](auto kind) { return decltype(kind)::support(s, hit.normal); });
    ASSERT_NEAR(dot(hit.normal, at), support, 5e-3f);
  }
  EXPECT_GT(hits, 500);
}

TEST_P(Rays, MissOnlyShapesThatTheyDoNotEnter) {
  int misses = 0;
  for (int i = 0; i < 3000; ++i) {
    const ShapeData s = shape();
    const auto [o, d] = ray(s);
    RayHit hit{};
    if (cast(GetParam(), s, o, d, 40, hit)) continue;
    ++misses;
    for (float t = 0; t < 30; t += 0.05f)
      ASSERT_FALSE(contains(GetParam(), s, o + d * t, -1e-3f)) << t;
  }
  EXPECT_GT(misses, 100);
}

TEST_P(Rays, MissFromInside) {
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const ShapeData s = shape();
    const Vec3 o = mul(s.half, dice_.vec(1));
    if (!contains(GetParam(), s, o, -1e-3f)) continue;
    ++inside;
    RayHit hit{};
    ASSERT_FALSE(cast(GetParam(), s, o, dice_.direction(), 40, hit));
  }
  EXPECT_GT(inside, 100);
}

TEST_P(Rays, MissIfTheyPointAwayOrAreTooShort) {
  for (int i = 0; i < 3000; ++i) {
    const ShapeData s = shape();
    const auto [o, d] = ray(s);
    RayHit hit{}, other{};
    if (!cast(GetParam(), s, o, d, 40, hit)) continue;
    EXPECT_FALSE(cast(GetParam(), s, o, -d, 40, other));
    EXPECT_FALSE(cast(GetParam(), s, o, d, hit.t * 0.999f, other));
    EXPECT_TRUE(cast(GetParam(), s, o, d, hit.t * 1.001f, other));
    // The result t is in units of the direction's length.
    ASSERT_TRUE(cast(GetParam(), s, o, d * 2, 40, other));
    EXPECT_NEAR(other.t * 2, hit.t, 2e-3f);
  }
}

TEST_P(Rays, HitTheBoundingFacesAlongAnAxis) {
  const ShapeData s{{1, 1, 1}, &hull_};
  RayHit hit{};
  ASSERT_TRUE(cast(GetParam(), s, {0.001f, -5, 0.001f}, {0, 1, 0}, 20, hit));
  EXPECT_NEAR(hit.t, 4, 3e-3f);
}

INSTANTIATE_TEST_SUITE_P(EveryShape, Rays, testing::ValuesIn(test::kKinds));

}  // namespace
}  // namespace obby::geom
