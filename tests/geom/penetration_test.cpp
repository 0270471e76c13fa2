// Penetration depths. Special forms agree with the general one, and moving the body out by depth
// times normal separates the two shapes.
#include "geom/penetration.h"

#include <gtest/gtest.h>

#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::Dice;

LocalBox localOf(const Pose& pose, const UprightBox& box) {
  const Mat3 axes = box.axes();
  return {toLocal(pose, box.center),
          {toLocal(pose.rotation, axes.x), toLocal(pose.rotation, axes.y),
           toLocal(pose.rotation, axes.z)},
          box.half};
}

UprightBox moved(UprightBox box, Vec3 by) {
  box.center += by;
  return box;
}

TEST(BoxBlock, EqualsTheSeparatingAxesOfTheGeneralForm) {
  Dice dice(200);
  int overlapping = 0;
  for (int i = 0; i < 250000; ++i) {
    const ShapeData s{dice.half(), nullptr};
    const Pose pose{dice.vec(3), i % 3 ? dice.rotation() : Mat3{}};
    const LocalBox local = localOf(pose, dice.body(3));
    const Contact fast = boxBlock<float>(s.half, local),
                  general = internal::penetration<Block>(s, local);
    if (general.depth < 1e-4f && general.depth > -1e-4f)
      continue;  // the shapes touch, so either answer is right
    ASSERT_EQ(fast.depth >= 0, general.depth >= 0) << fast.depth << " " << general.depth;
    if (general.depth < 0) continue;
    ++overlapping;
    ASSERT_NEAR(fast.depth, general.depth, 1e-4f);
  }
  EXPECT_GT(overlapping, 100000);
}

TEST(BoxUprightBlock, EqualsBothOtherForms) {
  Dice dice(201);
  int overlapping = 0;
  for (int i = 0; i < 200000; ++i) {
    const ShapeData s{dice.half(), nullptr};
    const Pose pose{dice.vec(3),
                    UprightBox{{}, {}, sinCos(i % 3 ? dice.turns() : Turns(0))}.axes()};
    const UprightBox box = dice.body(3);
    const Contact fast = boxUprightBlock<float>({pose, s.half}, box);
    const LocalBox local = localOf(pose, box);
    const Contact general = internal::penetration<Block>(s, local),
                  block = boxBlock<float>(s.half, local);
    if (general.depth < 1e-4f && general.depth > -1e-4f) continue;
    ASSERT_EQ(fast.depth >= 0, general.depth >= 0) << fast.depth << " " << general.depth;
    if (general.depth < 0) continue;
    ++overlapping;
    ASSERT_NEAR(fast.depth, general.depth, 1e-4f);
    ASSERT_NEAR(fast.depth, block.depth, 1e-4f);
    ASSERT_NEAR(length(fast.normal), 1, 1e-5f);
  }
  EXPECT_GT(overlapping, 50000);
}

TEST(BoxUprightBlock, PushesAFootUpAndASideSideways) {
  const Pose pose{{0, 0, 0}, {}};
  const UprightBox above{{0, 1.9f, 0}, {1, 1, 0.5f}, sinCos(0)};
  const Contact up = boxUprightBlock<float>({pose, {4, 1, 4}}, above);
  EXPECT_NEAR(up.depth, 0.1f, 1e-5f);
  EXPECT_TRUE(up.normal == (Vec3{0, 1, 0}));
  const UprightBox atSide{{-4.9f, 0, 0}, {1, 1, 0.5f}, sinCos(0)};
  const Contact out = boxUprightBlock<float>({pose, {4, 1, 4}}, atSide);
  EXPECT_NEAR(out.depth, 0.1f, 1e-5f);
  EXPECT_TRUE(out.normal == (Vec3{-1, 0, 0}));
}

class Penetration : public testing::TestWithParam<ShapeKind> {
 protected:
  ShapeData shape() {
    return {GetParam() == ShapeKind::hull ? Vec3{1, 1, 1} : dice_.half(), &hull_};
  }
  // Returns true if any of 400 random points of the box lies in the shape.
  bool anyPointInside(const ShapeData& s, const Pose& pose, const UprightBox& box, float slack) {
    const Mat3 axes = box.axes();
    for (int k = 0; k < 400; ++k) {
      const Vec3 world = box.center + axes * mul(box.half, dice_.vec(1));
      if (test::contains(GetParam(), s, toLocal(pose, world), slack)) return true;
    }
    return false;
  }
  Dice dice_{210 + uint64_t(GetParam())};
  test::HullFixture fixture_ = test::octahedron();
  Hull hull_ = fixture_.hull();
};

TEST_P(Penetration, MovingOutByTheDepthSeparatesThePair) {
  int overlapping = 0;
  for (int i = 0; i < 60000; ++i) {
    const ShapeData s = shape();
    const Pose pose{dice_.vec(2), dice_.rotation()};
    const UprightBox box = dice_.body(3);
    const Contact c = penetration(GetParam(), s, pose, box);
    if (c.depth < 0) continue;
    ++overlapping;
    ASSERT_NEAR(length(c.normal), 1, 1e-4f);
    ASSERT_LE(penetration(GetParam(), s, pose, moved(box, c.normal * c.depth)).depth, 1e-3f);
  }
  EXPECT_GT(overlapping, 10000);
}

TEST_P(Penetration, ReportsSeparationOnlyIfNoPointIsShared) {
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const ShapeData s = shape();
    const Pose pose{dice_.vec(3), dice_.rotation()};
    const UprightBox box = dice_.body(4);
    if (penetration(GetParam(), s, pose, box).depth >= 0) continue;
    ++apart;
    ASSERT_FALSE(anyPointInside(s, pose, box, -1e-4f));
  }
  EXPECT_GT(apart, 300);
}

TEST_P(Penetration, ReportsSeparationForPairsOutOfReach) {
  for (int i = 0; i < 3000; ++i) {
    const ShapeData s = shape();
    const Pose pose{dice_.vec(3), dice_.rotation()};
    UprightBox box = dice_.body(3);
    box.center = pose.position + dice_.direction() * (length(s.half) + length(box.half) + 0.01f);
    ASSERT_LT(penetration(GetParam(), s, pose, box).depth, 0);
  }
}

TEST_P(Penetration, IsTranslationInvariant) {
  for (int i = 0; i < 2000; ++i) {
    const ShapeData s = shape();
    const Pose pose{dice_.vec(2), dice_.rotation()};
    const UprightBox box = dice_.body(3);
    const float depth = penetration(GetParam(), s, pose, box).depth;
    const Vec3 shift{64, -32, 128};
    const float shifted =
        penetration(GetParam(), s, {pose.position + shift, pose.rotation}, moved(box, shift)).depth;
    if (depth > 1e-3f) {
      ASSERT_NEAR(shifted, depth, 1e-3f);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryShape, Penetration, testing::ValuesIn(test::kKinds));

TEST(HullOfACube, IsTheBlock) {
  Dice dice(250);
  const test::HullFixture fixture = test::cube();
  const Hull hull = fixture.hull();
  const ShapeData block{{1, 1, 1}, nullptr}, asHull{{1, 1, 1}, &hull};
  for (int i = 0; i < 50000; ++i) {
    const Pose pose{dice.vec(2), dice.rotation()};
    const UprightBox box = dice.body(2);
    const Contact a = penetration(ShapeKind::block, block, pose, box);
    const Contact b = penetration(ShapeKind::hull, asHull, pose, box);
    if (absf(a.depth) < 1e-4f) continue;
    ASSERT_EQ(a.depth >= 0, b.depth >= 0);
    if (a.depth >= 0) {
      ASSERT_NEAR(a.depth, b.depth, 1e-4f);
    }
    const Vec3 d = dice.direction();
    ASSERT_NEAR(Block::support(block, d), ConvexHull::support(asHull, d), 1e-5f);
  }
}

}  // namespace
}  // namespace obby::geom
