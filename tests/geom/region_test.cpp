// Regions: the player's line against an oriented box, and distances to it.
#include "geom/region.h"

#include <gtest/gtest.h>

#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::Dice;

TEST(Region, MeetsALineExactlyIfItContainsAPoint) {
  Dice dice(300);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Region r{{dice.vec(3), dice.rotation()}, dice.half()};
    const Vec3 a = dice.vec(8), b = i % 2 ? a + Vec3{0, 5, 0} : dice.vec(8);
    float lowest = 1e9f;
    for (int k = 0; k <= 400; ++k) {
      const Vec3 p = toLocal(r.pose, a + (b - a) * (float(k) / 400));
      const Vec3 over = abs(p) - r.half;
      lowest = minf(lowest, maxf(over.x, maxf(over.y, over.z)));
    }
    if (lowest < -1e-4f) {
      ASSERT_TRUE(meets(r, a, b));
    }
    if (lowest > 0.05f) {
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
  EXPECT_TRUE(meets(r, {0, 1, 0}, {0, 5, 0}));  // the box includes its faces
}

TEST(Region, ASweptLineMeetsExactlyIfItMeetsAtSomePoint) {
  Dice dice(303);
  int swept = 0, between = 0;
  for (int i = 0; i < 12000; ++i) {
    const Vec3 half = dice.half();
    const Region r{{dice.vec(3), dice.rotation()}, i % 2 ? half : Vec3{half.x, half.y, 0.02f}};
    const Region larger{r.pose, r.half + Vec3{0.05f, 0.05f, 0.05f}};
    const Vec3 a = dice.vec(8), b = a + (i % 3 ? Vec3{0, 5, 0} : dice.vec(5)), shift = dice.vec(5);
    bool met = false, nearlyMet = false;
    for (int k = 0; k <= 300; ++k) {
      const Vec3 gone = shift * (float(k) / 300);
      met |= meets(r, a + gone, b + gone);
      nearlyMet |= meets(larger, a + gone, b + gone);
    }
    const bool along = meetsAlong(r, a, b, shift);
    ASSERT_GE(along, met) << i;
    ASSERT_LE(along, nearlyMet) << i;
    swept += along;
    between += along && !meets(r, a, b) && !meets(r, a + shift, b + shift);
  }
  EXPECT_GT(swept, 500);
  EXPECT_GT(between, 100);
}

TEST(Region, ASweepOfZeroLengthIsThePosition) {
  Dice dice(304);
  for (int i = 0; i < 2000; ++i) {
    const Region r{{dice.vec(3), dice.rotation()}, dice.half()};
    const Region larger{r.pose, r.half * 1.001f}, smaller{r.pose, r.half * 0.999f};
    const Vec3 a = dice.vec(6), b = a + Vec3{0, 5, 0};
    ASSERT_LE(meets(smaller, a, b), meetsAlong(r, a, b, {}));
    ASSERT_LE(meetsAlong(r, a, b, {}), meets(larger, a, b));
  }
}

TEST(Region, DistanceIsTheMinimumOverItsPoints) {
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
