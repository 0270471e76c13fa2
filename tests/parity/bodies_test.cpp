// Dynamic bodies against formulas where these exist, and against Bullet's rigid bodies. After an
// impact on an edge, rounding decides the motion, so the tests compare only the height and the face
// on which a body rests. If nothing tumbles, the tests compare the whole pose.
#include <gtest/gtest.h>

#include <cmath>

#include "parity/bodies.h"

namespace obby::parity {
namespace {

constexpr double kGravity = 196.2;
// Studs; our contacts rest 0.005 deep, and Bullet's differ by as much.
constexpr double kRest = 0.02;

BodySpec floorOf(float friction = 0.5f) {
  return {.position = {0, -1, 0}, .size = {400, 2, 400}, .friction = friction, .anchored = true};
}

BodySpec slopeOf(float pitch, float friction) {
  return {.position = {0, 40, 0},
          .size = {20, 2, 200},
          .pitch = pitch,
          .friction = friction,
          .anchored = true};
}

// Returns a body on the slope with its centre `up` above the surface. +Z of the slope is downhill.
BodySpec onSlope(float pitch, float friction, float up, float along) {
  const double s = std::sin(double(pitch)), c = std::cos(double(pitch));
  const double y = 1 + double(up), z = double(along);
  return {.position = {0, float(40 + c * y - s * z), float(s * y + c * z)},
          .size = {4, 2 * up, 4},
          .pitch = pitch,
          .friction = friction};
}

// Returns the body's axis that points most upward: 1 to 3, negative if it points down.
int faceUp(const BodyState& s) {
  const float y[3] = {s.axes.x.y, s.axes.y.y, s.axes.z.y};
  int best = 0;
  for (int i = 1; i < 3; ++i) {
    if (absf(y[i]) > absf(y[best])) best = i;
  }
  return y[best] < 0 ? -best - 1 : best + 1;
}

void expectSamePose(const BodyState& a, const BodyState& b, double tolerance) {
  EXPECT_NEAR(double(length(a.position - b.position)), 0, tolerance);
  EXPECT_GT(dot(a.axes.x, b.axes.x), 0.999f);
  EXPECT_GT(dot(a.axes.y, b.axes.y), 0.999f);
}

TEST(BodiesParity, FallByTheFormulaInSubsteps) {
  Both both({floorOf(), {.position = {0, 60, 0}, .size = {4, 4, 4}}});
  for (int tick = 1; tick <= 40; ++tick) {
    both.run(1);
    const double n = 4.0 * tick, y = 60 - kGravity / (240 * 240) * n * (n + 1) / 2;
    ASSERT_NEAR(double(both.ours.state(0).position.y), y, 1e-4);
    ASSERT_NEAR(double(both.bullet.state(0).position.y), y, 1e-4);
  }
}

TEST(BodiesParity, RestWhereTheyFallWhenDroppedFlat) {
  Both both({floorOf(), {.position = {3, 8, -5}, .size = {4, 2, 6}, .yaw = 0.4f}});
  both.run(180);
  expectSamePose(both.ours.state(0), both.bullet.state(0), kRest);
  EXPECT_TRUE(both.ours.asleep());
}

TEST(BodiesParity, DroppedOnAnEdgeOrTiltedRestOnTheSameFace) {
  for (const float pitch : {0.1f, 0.3f, 0.6f, 0.95f, 1.2f, 2.0f}) {
    Both both({floorOf(), {.position = {0, 6, 0}, .size = {4, 3, 5}, .pitch = pitch}});
    both.run(300);
    const BodyState a = both.ours.state(0), b = both.bullet.state(0);
    EXPECT_EQ(faceUp(a), faceUp(b)) << pitch;
    EXPECT_NEAR(double(a.position.y), double(b.position.y), kRest) << pitch;
    EXPECT_NEAR(double(length(a.position - b.position)), 0, 1) << pitch;
    EXPECT_TRUE(both.ours.asleep()) << pitch;
  }
}

TEST(BodiesParity, DroppedOnACornerRestOnAFace) {
  for (const float yaw : {0.2f, 0.5f, 0.7f, 1.0f}) {
    Both both({floorOf(), {.position = {0, 6, 0}, .size = {4, 4, 4}, .yaw = yaw, .pitch = yaw}});
    both.run(300);
    EXPECT_NEAR(double(both.ours.state(0).position.y), 2, kRest) << yaw;
    EXPECT_NEAR(double(both.bullet.state(0).position.y), 2, kRest) << yaw;
    EXPECT_TRUE(both.ours.asleep()) << yaw;
  }
}

TEST(BodiesParity, WedgesRestOnTheSameFace) {
  for (const auto shape : {schema::Shape::WEDGE, schema::Shape::CORNER_WEDGE}) {
    for (const float pitch : {0.0f, 0.5f, 1.2f, 2.4f}) {
      Both both(
          {floorOf(), {.shape = shape, .position = {0, 6, 0}, .size = {4, 4, 6}, .pitch = pitch}});
      both.run(400);
      const BodyState a = both.ours.state(0), b = both.bullet.state(0);
      EXPECT_NEAR(double(a.position.y), double(b.position.y), kRest) << int(shape) << pitch;
      EXPECT_GT(dot(a.axes.y, b.axes.y), 0.999f) << int(shape) << pitch;
      EXPECT_TRUE(both.ours.asleep()) << int(shape) << pitch;
    }
  }
}

TEST(BodiesParity, SlideUntilFrictionHasStoppedThem) {
  for (const float friction : {0.2f, 0.5f, 1.0f}) {
    for (const float speed : {10.0f, 30.0f, 60.0f}) {
      Both both({floorOf(friction),
                 {.position = {0, 0.995f, 0},
                  .size = {8, 2, 8},
                  .friction = friction,
                  .velocity = {speed, 0, 0}}});
      const double far = double(speed) * double(speed) / (2 * double(friction) * kGravity);
      both.run(120);
      EXPECT_NEAR(double(both.ours.state(0).position.x), far, 0.03 * far + 0.02) << speed;
      EXPECT_NEAR(double(both.bullet.state(0).position.x), far, 0.03 * far + 0.02) << speed;
      EXPECT_NEAR(double(both.ours.state(0).position.z), 0, 0.02);
    }
  }
}

TEST(BodiesParity, StayOnASlopeUpToTheAngleOfFriction) {
  for (const float friction : {0.3f, 0.6f, 1.0f}) {
    const double critical = std::atan(double(friction));
    const auto moved = [&](double pitch) {
      Both both(
          {floorOf(), slopeOf(float(pitch), friction), onSlope(float(pitch), friction, 1, -60)});
      const Vec3 start = both.ours.state(0).position;
      both.run(60);
      return length(both.ours.state(0).position - start);
    };
    EXPECT_LT(moved(critical - 0.02), 0.05f) << friction;
    const double over = critical + 0.1;
    const double a = kGravity * (std::sin(over) - double(friction) * std::cos(over));
    EXPECT_NEAR(double(moved(over)), a / 2, 0.03 * a) << friction;
  }
}

TEST(BodiesParity, BallsRollDownASlopeAtFiveSeventhsOfSliding) {
  for (const float pitch : {0.1f, 0.3f, 0.5f}) {
    BodySpec ball = onSlope(pitch, 1, 2, -80);
    ball.shape = schema::Shape::BALL;
    Both both({floorOf(), slopeOf(pitch, 1), ball});
    both.run(90);
    const double far = 0.5 * 5 / 7 * kGravity * std::sin(double(pitch)) * 1.5 * 1.5;
    const double ours = double(length(both.ours.state(0).position - ball.position));
    const double bullet = double(length(both.bullet.state(0).position - ball.position));
    EXPECT_NEAR(ours, far, 0.02 * far) << pitch;
    EXPECT_NEAR(bullet, far, 0.02 * far) << pitch;
    EXPECT_NEAR(double(length(both.ours.body(0).spin)) * 2,
                double(length(both.ours.body(0).velocity)), 0.5);
  }
}

TEST(BodiesParity, CylindersRollDownASlopeAtTwoThirdsOfSliding) {
  BodySpec drum = onSlope(0.3f, 1, 2, -80);
  drum.shape = schema::Shape::CYLINDER;
  Both both({floorOf(), slopeOf(0.3f, 1), drum});
  both.run(90);
  const double far = 0.5 * 2 / 3 * kGravity * std::sin(0.3) * 1.5 * 1.5;
  EXPECT_NEAR(double(length(both.ours.state(0).position - drum.position)), far, 0.02 * far);
  EXPECT_NEAR(double(length(both.bullet.state(0).position - drum.position)), far, 0.02 * far);
}

TEST(BodiesParity, StacksOfFiveStand) {
  std::vector<BodySpec> specs{floorOf()};
  for (int i = 0; i < 5; ++i) {
    specs.push_back({.position = {0.2f * float(i % 2), 2 + 4 * float(i), 0}, .size = {4, 4, 4}});
  }
  Both both(specs);
  both.run(300);
  for (size_t i = 0; i < 5; ++i) {
    expectSamePose(both.ours.state(i), both.bullet.state(i), 0.1);
    EXPECT_NEAR(double(both.ours.state(i).position.y), 2 + 4 * double(i), kRest * double(i + 1));
  }
  EXPECT_TRUE(both.ours.asleep());
}

TEST(BodiesParity, ArePushedByAWallThatMoves) {
  const BodySpec wall{
      .position = {-10, 4, 0}, .size = {2, 6, 12}, .anchored = true, .travel = {40, 0, 0}};
  Both both({floorOf(), wall, {.position = {0, 2, 0}, .size = {4, 4, 4}}});
  both.run(200);
  const double face = -10 + 40 * 200 / 240.0 + 1;
  const BodyState ours = both.ours.state(0);
  EXPECT_NEAR(double(ours.position.x), face + 2, kRest);
  EXPECT_NEAR(double(ours.velocity.x), 10, 0.1);
  // Bullet's block stays 0.04 studs ahead of the wall and drifts sideways by 0.35 studs.
  EXPECT_NEAR(double(both.bullet.state(0).position.x), face + 2, 0.05);
  EXPECT_NEAR(double(ours.position.z), 0, 0.05);
  EXPECT_GT(ours.axes.x.x, 0.999f);
}

// A rising platform carries the body on it, and does not throw it up.
TEST(BodiesParity, AreLiftedByAPlatform) {
  for (const float rise : {8.0f, 40.0f, 160.0f}) {
    const BodySpec lift{
        .position = {0, 1, 0}, .size = {12, 2, 12}, .anchored = true, .travel = {0, rise, 0}};
    Both both({floorOf(), lift, {.position = {0, 4, 0}, .size = {4, 4, 4}}});
    both.run(60);
    for (int t = 61; t < 200; ++t) {
      both.run(1);
      const double top = 2 + double(rise) * t / 240.0;
      ASSERT_NEAR(double(both.ours.state(0).position.y), top + 2, kRest) << rise << " " << t;
      // Bullet's block is up to a step ahead.
      const double step = double(rise) / (240 * double(kTravelSeconds));
      ASSERT_NEAR(double(both.bullet.state(0).position.y), top + 2, 0.06 + step) << rise;
    }
  }
}

// Both rows fall flat, after numbers of ticks that differ by at most 5 %.
TEST(BodiesParity, DominoesFallOver) {
  Both both(
      {floorOf(1), {.position = {0, 4.03f, 0}, .size = {4, 8, 1}, .pitch = 0.16f, .friction = 1}});
  int ours = 0, bullet = 0;
  for (int t = 1; t <= 300; ++t) {
    both.run(1);
    if (!ours && absf(both.ours.state(0).axes.y.y) < 0.1f) ours = t;
    if (!bullet && absf(both.bullet.state(0).axes.y.y) < 0.1f) bullet = t;
  }
  EXPECT_GT(ours, 0);
  EXPECT_NEAR(ours, bullet, 2 + bullet / 20);
  EXPECT_EQ(faceUp(both.ours.state(0)), faceUp(both.bullet.state(0)));
  EXPECT_NEAR(double(both.ours.state(0).position.y), 0.5, kRest);
  EXPECT_NEAR(double(both.ours.state(0).position.z), double(both.bullet.state(0).position.z), 0.5);
}

TEST(BodiesParity, ARowOfDominoesFallsOneByOne) {
  std::vector<BodySpec> specs{floorOf()};
  for (int i = 0; i < 8; ++i) {
    specs.push_back({.position = {0, 4, 4 * float(i)}, .size = {4, 8, 1}});
  }
  specs[1].spin = {7, 0, 0};
  Both both(specs);
  both.run(300);
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_LT(absf(both.ours.state(i).axes.y.y), 0.5f) << i;
    EXPECT_LT(absf(both.bullet.state(i).axes.y.y), 0.5f) << i;
  }
}

}  // namespace
}  // namespace obby::parity
