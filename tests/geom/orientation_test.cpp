// The orientation of each shape in its own frame. No other test would detect a mirrored shape.
#include <gtest/gtest.h>

#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::contains;

const ShapeData kPart{{2, 1, 3}, nullptr};

// Returns the height of the surface at local (x, z), from a ray straight down, or -9 if the ray
// misses.
template <class Shape>
float heightAt(float x, float z) {
  RayHit hit{};
  if (!Shape::castRay(kPart, {x, 5, z}, {0, -1, 0}, 20, hit)) return -9;
  return 5 - hit.t;
}

TEST(WedgeOrientation, RisesFromMinusZToPlusZ) {
  EXPECT_NEAR(heightAt<Wedge>(0, -2.999f), -1, 1e-3f);
  EXPECT_NEAR(heightAt<Wedge>(0, 0), 0, 1e-6f);
  EXPECT_NEAR(heightAt<Wedge>(0, 2.999f), 1, 1e-3f);
  EXPECT_NEAR(heightAt<Wedge>(1.9f, 1.5f), 0.5f, 1e-5f);
}

TEST(WedgeOrientation, HasItsVerticalFaceAtPlusZ) {
  RayHit hit{};
  ASSERT_TRUE(Wedge::castRay(kPart, {0, 0.9f, 10}, {0, 0, -1}, 20, hit));
  EXPECT_NEAR(hit.t, 7, 1e-5f);
  EXPECT_TRUE(hit.normal == (Vec3{0, 0, 1}));
}

TEST(WedgeOrientation, ItsSlopeLooksUpAndTowardMinusZ) {
  const Vec3 n = Wedge::slope(kPart);
  EXPECT_GT(n.y, 0);
  EXPECT_LT(n.z, 0);
  EXPECT_EQ(n.x, 0);
}

TEST(WedgeOrientation, HasAFullBottom) {
  for (const float x : {-1.9f, 1.9f}) {
    for (const float z : {-2.9f, 2.9f}) EXPECT_NE(heightAt<Wedge>(x, z), -9);
  }
}

TEST(CornerWedgeOrientation, HasItsApexAtPlusXPlusYMinusZ) {
  EXPECT_NEAR(heightAt<CornerWedge>(1.999f, -2.999f), 1, 2e-3f);
  for (const auto& [x, z] : {std::pair{-1.999f, -2.999f}, {-1.999f, 2.999f}, {1.999f, 2.999f}}) {
    EXPECT_NEAR(heightAt<CornerWedge>(x, z), -1, 2e-3f) << x << " " << z;
  }
}

TEST(CornerWedgeOrientation, HasVerticalFacesAtPlusXAndMinusZ) {
  RayHit hit{};
  ASSERT_TRUE(CornerWedge::castRay(kPart, {10, -0.5f, -2.5f}, {-1, 0, 0}, 20, hit));
  EXPECT_TRUE(hit.normal == (Vec3{1, 0, 0}));
  ASSERT_TRUE(CornerWedge::castRay(kPart, {1.8f, -0.5f, -10}, {0, 0, 1}, 20, hit));
  EXPECT_TRUE(hit.normal == (Vec3{0, 0, -1}));
}

TEST(CornerWedgeOrientation, SlopesFallTowardMinusXAndPlusZ) {
  const Vec3 a = CornerWedge::slope(kPart, 0), b = CornerWedge::slope(kPart, 1);
  EXPECT_TRUE(a.x < 0 && a.y > 0 && a.z == 0);
  EXPECT_TRUE(b.x == 0 && b.y > 0 && b.z > 0);
}

TEST(CylinderOrientation, LiesAlongXWithTheSmallerOtherExtentAsDiameter) {
  const ShapeData s{{4, 1, 2}, nullptr};
  RayHit hit{};
  EXPECT_TRUE(Cylinder::castRay(s, {3.9f, 9, 0}, {0, -1, 0}, 20, hit));
  EXPECT_NEAR(hit.t, 8, 1e-5f);
  EXPECT_FALSE(Cylinder::castRay(s, {0, 9, 1.01f}, {0, -1, 0}, 20, hit));
  ASSERT_TRUE(Cylinder::castRay(s, {9, 0.5f, 0.5f}, {-1, 0, 0}, 20, hit));
  EXPECT_NEAR(hit.t, 5, 1e-5f);
}

TEST(BallOrientation, HasTheSmallestExtentAsDiameter) {
  const ShapeData s{{4, 1.5f, 2}, nullptr};
  RayHit hit{};
  ASSERT_TRUE(Ball::castRay(s, {0, 0, 9}, {0, 0, -1}, 20, hit));
  EXPECT_NEAR(hit.t, 7.5f, 1e-5f);
}

TEST(TrussShape, CollidesAsABlock) {
  RayHit block{}, truss{};
  const auto cast = [](ShapeKind kind, RayHit& hit) {
    return visitShape(kind, [&](auto shape) {
      return decltype(shape)::castRay(kPart, {1, 5, 1}, {0.1f, -1, 0.2f}, 20, hit);
    });
  };
  ASSERT_TRUE(cast(ShapeKind::block, block) && cast(ShapeKind::truss, truss));
  EXPECT_EQ(block.t, truss.t);
}

}  // namespace
}  // namespace obby::geom
