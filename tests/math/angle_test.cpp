// Compares angles in turns / 65536 with libm in double precision, for all 65536 angles.
#include "math/angle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace obby {
namespace {

constexpr double kTurn = 6.283185307179586476925;

double radians(int units) { return kTurn * units / 65536; }

// Returns the distance between two angles, at most half a turn, in units of 1/65536 turn.
int apart(Turns a, Turns b) { return std::abs(int(int16_t(uint16_t(a - b)))); }

TEST(SinCos, AgreesWithLibmForAllAngles) {
  double worst = 0;
  for (int a = 0; a < 65536; ++a) {
    const SinCos sc = sinCos(Turns(a));
    worst = std::max(worst, std::fabs(double(sc.sin) - std::sin(radians(a))));
    worst = std::max(worst, std::fabs(double(sc.cos) - std::cos(radians(a))));
  }
  EXPECT_LT(worst, 1.5e-7);
}

TEST(SinCos, IsExactAtQuarterTurns) {
  const float sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
  for (int q = 0; q < 4; ++q) {
    const SinCos sc = sinCos(Turns(q * 0x4000));
    EXPECT_EQ(sc.sin, sines[q]);
    EXPECT_EQ(sc.cos, cosines[q]);
  }
}

TEST(SinCos, LiesOnTheUnitCircleAndIsOddAndEven) {
  for (int a = 0; a < 65536; ++a) {
    const SinCos sc = sinCos(Turns(a)), mirrored = sinCos(Turns(-a));
    ASSERT_NEAR(double(sc.sin) * double(sc.sin) + double(sc.cos) * double(sc.cos), 1, 3e-7);
    if (a % 0x4000 == 0x2000) continue;  // an eighth of a turn lies on the border of two quarters
    ASSERT_EQ(mirrored.sin, -sc.sin) << a;
    ASSERT_EQ(mirrored.cos, sc.cos) << a;
  }
}

TEST(Heading, ZeroLooksAlongMinusZAndTurnsCounterClockwise) {
  const Vec3 ahead = directionOf(sinCos(0)), left = directionOf(sinCos(0x4000));
  EXPECT_EQ(ahead.z, -1);
  EXPECT_EQ(ahead.x, 0);
  EXPECT_EQ(left.x, -1);
  EXPECT_EQ(left.z, 0);
}

TEST(Heading, IsTheInverseOfDirectionForAllAnglesAndLengths) {
  int worst = 0;
  for (int a = 0; a < 65536; ++a) {
    const Vec3 d = directionOf(sinCos(Turns(a)));
    for (const float scale : {1.0f, 1e-3f, 750.0f}) {
      worst = std::max(worst, apart(headingOf(d.x * scale, d.z * scale), Turns(a)));
    }
  }
  EXPECT_LE(worst, 2);
}

TEST(Heading, IsZeroForNoDirection) { EXPECT_EQ(headingOf(0, 0), 0); }

TEST(Turns, RoundRadiansToTheNearestUnitAndWrap) {
  for (int a = -3 * 65536; a < 3 * 65536; a += 7) {
    ASSERT_LE(apart(turnsFromRadians(float(radians(a))), Turns(a)), 1) << a;
  }
  EXPECT_EQ(turnsFromRadians(0), 0);
  EXPECT_EQ(turnsFromRadians(kPi), 0x8000);
  EXPECT_EQ(turnsFromRadians(-kPi), 0x8000);
  EXPECT_EQ(turnsFromRadians(kPi / 2), 0x4000);
  EXPECT_EQ(turnsFromRadians(-kPi / 2), 0xc000);
}

TEST(Turns, RoundTripThroughRadians) {
  for (int a = 0; a < 65536; ++a) {
    const float r = radiansFromTurns(Turns(a));
    ASSERT_LE(absf(r), kPi * 1.000001f);
    ASSERT_EQ(turnsFromRadians(r), Turns(a));
  }
}

}  // namespace
}  // namespace obby
