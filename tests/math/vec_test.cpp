// Properties of vectors, rotations, poses and boxes over random values.
#include "math/vec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

namespace obby {
namespace {

constexpr int kRounds = 20000;

class Dice {
 public:
  explicit Dice(uint64_t stream) : random_(1, stream) {}
  float number(float size) { return (2 * random_.unit() - 1) * size; }
  Vec3 vec(float size) { return {number(size), number(size), number(size)}; }
  Quat quat() {
    while (true) {
      const Quat q{number(1), number(1), number(1), number(1)};
      const float n2 = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
      if (n2 > 0.01f && n2 < 1) return normalize(q);
    }
  }
  Pose pose(float size) { return {vec(size), toMat3(quat())}; }

 private:
  Random random_;
};

void expectNear(Vec3 a, Vec3 b, float tolerance) {
  ASSERT_LE(length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

TEST(Vec3, CrossIsPerpendicularAndRightHanded) {
  EXPECT_TRUE(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}) == (Vec3{0, 0, 1}));
  Dice dice(1);
  for (int i = 0; i < kRounds; ++i) {
    const Vec3 a = dice.vec(10), b = dice.vec(10), c = cross(a, b);
    ASSERT_NEAR(dot(a, c), 0, 1e-3f);
    ASSERT_NEAR(dot(b, c), 0, 1e-3f);
    ASSERT_NEAR(dot(c, c) + dot(a, b) * dot(a, b), dot(a, a) * dot(b, b), 0.1f);
  }
}

TEST(Vec3, NormalizeGivesLengthOneOrTheFallback) {
  Dice dice(2);
  for (int i = 0; i < kRounds; ++i) {
    ASSERT_NEAR(length(normalize(dice.vec(i % 2 ? 1e4f : 1e-4f))), 1, 3e-7f);
  }
  EXPECT_TRUE(normalize(Vec3{}) == (Vec3{0, 1, 0}));
  EXPECT_TRUE(normalize(Vec3{}, {1, 0, 0}) == (Vec3{1, 0, 0}));
}

TEST(Quat, YieldsAProperRotationMatrix) {
  Dice dice(3);
  for (int i = 0; i < kRounds; ++i) {
    const Mat3 m = toMat3(dice.quat());
    for (const Vec3 axis : {m.x, m.y, m.z}) ASSERT_NEAR(length(axis), 1, 1e-6f);
    expectNear(cross(m.x, m.y), m.z, 2e-6f);
  }
}

TEST(Quat, ProductIsTheProductOfTheMatrices) {
  Dice dice(4);
  for (int i = 0; i < kRounds; ++i) {
    const Quat a = dice.quat(), b = dice.quat();
    const Vec3 v = dice.vec(1);
    expectNear(toMat3(a * b) * v, toMat3(a) * (toMat3(b) * v), 3e-6f);
    expectNear((toMat3(a) * toMat3(b)) * v, toMat3(a) * (toMat3(b) * v), 3e-6f);
  }
}

TEST(Quat, TurnsRightHandedAboutItsAxis) {
  const float h = std::sqrt(0.5f);
  expectNear(toMat3(Quat{0, h, 0, h}) * Vec3{0, 0, -1}, {-1, 0, 0}, 1e-6f);
  expectNear(toMat3(Quat{h, 0, 0, h}) * Vec3{0, 1, 0}, {0, 0, 1}, 1e-6f);
  expectNear(toMat3(Quat{0, 0, h, h}) * Vec3{1, 0, 0}, {0, 1, 0}, 1e-6f);
}

TEST(Quat, NormalizeOfZeroIsNoRotation) {
  const Quat q = normalize(Quat{0, 0, 0, 0});
  EXPECT_EQ(q.w, 1);
  EXPECT_EQ(q.x, 0);
}

TEST(Pose, ToLocalUndoesToWorld) {
  Dice dice(5);
  for (int i = 0; i < kRounds; ++i) {
    const Pose p = dice.pose(100);
    const Vec3 v = dice.vec(20);
    // The rounding error is a few units in the last place of the largest intermediate value.
    const float tolerance = 2e-6f * (length(p.position) + length(v));
    expectNear(toLocal(p, toWorld(p, v)), v, tolerance);
    expectNear(toWorld(p, toLocal(p, v)), v, tolerance);
    expectNear(toLocal(p.rotation, p.rotation * v), v, 2e-6f * length(v));
  }
}

TEST(Box, OverlapIsSymmetricAndIncludesTouching) {
  const Box a{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(overlaps(a, {{1, 0, 0}, {2, 1, 1}}));
  EXPECT_FALSE(overlaps(a, {{1.001f, 0, 0}, {2, 1, 1}}));
  Dice dice(6);
  for (int i = 0; i < kRounds; ++i) {
    const Vec3 p = dice.vec(3), q = dice.vec(3);
    const Box b{p, p + abs(dice.vec(3))}, c{q, q + abs(dice.vec(3))};
    const bool expected = maxf(b.lo.x, c.lo.x) <= minf(b.hi.x, c.hi.x) &&
                          maxf(b.lo.y, c.lo.y) <= minf(b.hi.y, c.hi.y) &&
                          maxf(b.lo.z, c.lo.z) <= minf(b.hi.z, c.hi.z);
    ASSERT_EQ(overlaps(b, c), expected);
    ASSERT_EQ(overlaps(c, b), expected);
    const Box both = join(b, c);
    ASSERT_TRUE(overlaps(both, b) && overlaps(both, c));
    ASSERT_TRUE(min(both.lo, b.lo) == both.lo && max(both.hi, c.hi) == both.hi);
  }
}

TEST(Box, GrowsOnEverySide) {
  const Box b = grow(Box{{0, 0, 0}, {1, 2, 3}}, {1, 2, 3});
  EXPECT_TRUE(b.lo == (Vec3{-1, -2, -3}) && b.hi == (Vec3{2, 4, 6}));
}

TEST(Box, BoundsOfATurnedBoxTouchItsCorners) {
  Dice dice(7);
  for (int i = 0; i < 2000; ++i) {
    const Pose p = dice.pose(10);
    const Vec3 half = abs(dice.vec(5));
    Box corners{{1e9f, 1e9f, 1e9f}, {-1e9f, -1e9f, -1e9f}};
    for (int c = 0; c < 8; ++c) {
      const Vec3 at =
          toWorld(p, mul(half, {c & 1 ? 1.f : -1.f, c & 2 ? 1.f : -1.f, c & 4 ? 1.f : -1.f}));
      corners = join(corners, {at, at});
    }
    const Box bounds = boundsOf(p, half);
    expectNear(bounds.lo, corners.lo, 1e-5f);
    expectNear(bounds.hi, corners.hi, 1e-5f);
  }
}

}  // namespace
}  // namespace obby
