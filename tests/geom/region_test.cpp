// Regions: the player's line against an oriented box, and distances to it.
#include "geom/region.h"

#include <gtest/gtest.h>

#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::Dice;

TEST(Region, MeetsALineExactlyWhereAPointOfItIsInside) {
  Dice dice(300);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Region r{{dice.vec(3), dice.rotation()}, dice.half()};
    const Vec3 a = dice.vec(8), b = i % 2 ? a + Vec3{0, 5, 0} : dice.vec(8);
    float least = 1e9f;
    for (int k = 0; k <= 400; ++k) {
      const Vec3 p = toLocal(r.pose, a + (b - a) * (float(k) / 400));
      const Vec3 over = abs(p) - r.half;
      least = minf(least, maxf(over.x, maxf(over.y, over.z)));
    }
    if (least < -1e-4f) {
      ASSERT_TRUE(meets(r, a, b));
    }
    if (least > 0.05f) {
      ASSERT_FALSE(meets(r, a, b));
    }
    met += meets(r, a, b);
  }
  EXPECT_GT(met, 300);
}

TEST(Region, MeetsIsSymmetricAndWorksForAPoint) {
  Dice dice(301);
  const Region r{{{1, 2, 3}, {}}, {1, 1, 1}};
  EXPECT_TRUE(meets(r, {1, 2, 3}, {1, 2, 3}));
  EXPECT_FALSE(meets(r, {3, 2, 3}, {3, 2, 3}));
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = dice.vec(6), b = dice.vec(6);
    ASSERT_EQ(meets(r, a, b), meets(r, b, a));
  }
}

TEST(Region, ALineThroughWithBothEndsOutsideMeets) {
  const Region r{{{0, 0, 0}, {}}, {1, 1, 1}};
  EXPECT_TRUE(meets(r, {0, -5, 0}, {0, 5, 0}));
  EXPECT_FALSE(meets(r, {2, -5, 0}, {2, 5, 0}));
  EXPECT_FALSE(meets(r, {0, 2, 0}, {0, 5, 0}));
  EXPECT_TRUE(meets(r, {0, 1, 0}, {0, 5, 0}));  // faces belong to it
}

TEST(Region, DistanceIsTheLeastOverItsPoints) {
  Dice dice(302);
  for (int i = 0; i < 2000; ++i) {
    const Region r{{dice.vec(3), dice.rotation()}, dice.half()};
    const Vec3 p = dice.vec(10);
    const float d = distance(r, p);
    for (int k = 0; k < 40; ++k) {
      ASSERT_LE(d, length(toWorld(r.pose, mul(r.half, dice.vec(1))) - p) + 1e-4f);
    }
    const Vec3 local = toLocal(r.pose, p);
    const Vec3 closest = max(min(local, r.half), -r.half);
    ASSERT_NEAR(d, length(local - closest), 1e-4f);
    ASSERT_EQ(d == 0, meets(r, p, p));
  }
}

}  // namespace
}  // namespace obby::geom
