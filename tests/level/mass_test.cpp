// Compares mass, centre and inertia of dynamic parts with textbook formulas.
#include "level/mass.h"

#include <gtest/gtest.h>

#include "level/hull_tables.h"

namespace obby::level {
namespace {

using geom::ShapeKind;

MassProperties of(ShapeKind kind, Vec3 size, float density = 1) {
  const SolidShape shape{kind, {size * 0.5f, nullptr}};
  return massOf({&shape, 1}, density);
}

// Checks that the inertia tensor is diagonal, and returns the diagonal.
Vec3 inertiaOf(const MassProperties& m) {
  EXPECT_NEAR(m.inverseInertia.x.y, 0, 1e-6);
  EXPECT_NEAR(m.inverseInertia.x.z, 0, 1e-6);
  EXPECT_NEAR(m.inverseInertia.y.z, 0, 1e-6);
  return {1 / m.inverseInertia.x.x, 1 / m.inverseInertia.y.y, 1 / m.inverseInertia.z.z};
}

TEST(Mass, BlockIsDensityTimesVolumeAndTwelfthsOfSquares) {
  const MassProperties m = of(ShapeKind::block, {2, 4, 6}, 0.7f);
  EXPECT_FLOAT_EQ(m.mass, 0.7f * 48);
  const Vec3 i = inertiaOf(m);
  EXPECT_NEAR(i.x, m.mass / 12 * (16 + 36), 1e-3);
  EXPECT_NEAR(i.y, m.mass / 12 * (4 + 36), 1e-3);
  EXPECT_NEAR(i.z, m.mass / 12 * (4 + 16), 1e-3);
}

TEST(Mass, BallIsTwoFifths) {
  const MassProperties m = of(ShapeKind::ball, {4, 4, 4});
  EXPECT_NEAR(m.mass, 4.0 / 3 * 3.14159265 * 8, 1e-4);
  EXPECT_NEAR(inertiaOf(m).x, 0.4f * m.mass * 4, 1e-3);
}

TEST(Mass, CylinderHasOneHalfAlongItsAxis) {
  const MassProperties m = of(ShapeKind::cylinder, {6, 4, 4});
  EXPECT_NEAR(m.mass, 3.14159265 * 4 * 6, 1e-4);
  EXPECT_NEAR(inertiaOf(m).x, 0.5f * m.mass * 4, 1e-2);
  EXPECT_NEAR(inertiaOf(m).y, m.mass / 12 * (3 * 4 + 36), 1e-2);
}

TEST(Mass, WedgeIsHalfABlockWithItsCentreAThirdUp) {
  const MassProperties m = of(ShapeKind::wedge, {2, 3, 6});
  EXPECT_NEAR(m.mass, 18, 1e-4);
  EXPECT_NEAR(m.center.x, 0, 1e-5);
  EXPECT_NEAR(m.center.y, -1.5 + 1, 1e-5);
  EXPECT_NEAR(m.center.z, 3 - 2, 1e-5);
}

TEST(Mass, CornerWedgeIsAPyramid) {
  const MassProperties m = of(ShapeKind::cornerWedge, {2, 3, 6});
  EXPECT_NEAR(m.mass, 12, 1e-4);
  EXPECT_NEAR(m.center.y, -1.5 + 0.75, 1e-5);
  EXPECT_NEAR(m.center.x, 0.25, 1e-5);  // a quarter of the way to the apex
  EXPECT_NEAR(m.center.z, -0.75, 1e-5);
}

TEST(Mass, HullOfABlocksCornersIsTheBlock) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 2.0f : -2.0f, i & 4 ? 3.0f : -3.0f});
  const HullTables tables = hullTables(corners);
  const geom::Hull hull = viewOf(tables);
  const SolidShape shape{ShapeKind::hull, {{1, 2, 3}, &hull}};
  const MassProperties m = massOf({&shape, 1}, 0.7f), block = of(ShapeKind::block, {2, 4, 6}, 0.7f);
  EXPECT_NEAR(m.mass, block.mass, 1e-3);
  EXPECT_NEAR(m.inverseInertia.x.x, block.inverseInertia.x.x, 1e-6);
  EXPECT_NEAR(m.inverseInertia.z.z, block.inverseInertia.z.z, 1e-6);
}

TEST(Mass, ThinHullOfABlocksCornersIsTheBlock) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? 200.0f : -200.0f, i & 2 ? 0.025f : -0.025f, i & 4 ? 150.f : -150.f});
  const HullTables tables = hullTables(corners);
  const geom::Hull hull = viewOf(tables);
  const SolidShape shape{ShapeKind::hull, {{200, 0.025f, 150}, &hull}};
  const MassProperties m = massOf({&shape, 1}, 0.7f);
  EXPECT_NEAR(m.mass, 0.7 * 400 * 0.05 * 300, 4);
  EXPECT_NEAR(m.center.y, 0, 1e-3);
}

TEST(Mass, NothingWeighsNothing) { EXPECT_EQ(massOf({}, 1).mass, 0); }

}  // namespace
}  // namespace obby::level
