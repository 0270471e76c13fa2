// Tests laws of the real engine against measured numbers (docs/physics.md). At rate 240 one tick is
// one physics step.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/play.h"

namespace obby::test {
namespace {

using sim::State;

constexpr float kStep = 1.0f / 240, kGravity = 196.2f;

template <class Change>
level::Level byTheStep(const Change& change) {
  return flatLevel([&](auto p) {
    p.setControlRate(240);
    p.setSubsteps(1);
    change(p);
  });
}
level::Level byTheStep() {
  return byTheStep([](auto) {});
}

bool landed(const sim::World& w) { return w.state == State::landed; }

TEST(EngineLaws, StepsAreSemiImplicit) {
  const auto level = byTheStep();
  Play play(level, {0, 100, 0});
  play.run(stand(), 96);
  // A step does v += a dt, then x += v dt. Therefore the fall is ahead of the parabola by half a
  // step.
  EXPECT_NEAR(play.world.position.y, 100 - kGravity * kStep * kStep * 96 * 97 / 2, 1e-3f);
  EXPECT_NEAR(play.world.velocity.y, -kGravity * kStep * 96, 1e-3f);
}

TEST(EngineLaws, SeveralStepsInATickEqualSingleSteps) {
  const auto fine = byTheStep(), coarse = flatLevel();
  Play one(fine, {0, 100, 0}), other(coarse, {0, 100, 0});
  one.run(walk(kEast), 96);
  other.run(walk(kEast), 24);
  EXPECT_LT(length(one.world.position - other.world.position), 1e-3f);
}

TEST(EngineLaws, ApexOfJumpPower50) {
  const auto level = byTheStep();
  Play play(level);
  play.settle().run(stand(true), 1).run(stand(), 120);
  EXPECT_NEAR(play.highest(), 7.269f, 0.003f);
}

TEST(EngineLaws, ApexOfJumpHeight7_2) {
  const auto level = byTheStep([](auto p) { p.setJumpSpeed(std::sqrt(2 * kGravity * 7.2f)); });
  Play play(level);
  play.settle().run(stand(true), 1).run(stand(), 120);
  EXPECT_NEAR(play.highest(), 7.311f, 0.003f);
}

TEST(EngineLaws, TheLaunchStepIsFreeOfGravity) {
  const auto level = byTheStep();
  Play play(level);
  play.settle().run(stand(true), 1);
  EXPECT_EQ(play.world.velocity.y, 53);
  EXPECT_NEAR(play.world.position.y, 53 * kStep, 1e-4f);
  play.run(stand(), 1);
  EXPECT_NEAR(play.world.velocity.y, 53 - kGravity * kStep, 1e-4f);
  // Repeats this with ticks of four steps.
  const auto coarse = flatLevel();
  Play four(coarse);
  four.settle().run(stand(true), 1);
  EXPECT_NEAR(four.world.velocity.y, 53 - 3 * kGravity * kStep, 1e-4f);
}

TEST(EngineLaws, AJumpReplacesTheVerticalSpeed) {
  for (const float before : {-15.0f, 0.0f, 13.0f}) {
    const auto level = byTheStep();
    Play play(level);
    play.settle();
    play.world.velocity.y = before;
    play.run(stand(true), 1);
    EXPECT_EQ(play.world.velocity.y, 53) << before;
  }
}

TEST(EngineLaws, JumpingLastsOneTickInWhichKeysDoNothing) {
  const auto level = flatLevel();
  Play play(level);
  play.settle().run(walk(kNorth, true), 1);
  EXPECT_EQ(play.world.state, State::jumping);
  EXPECT_EQ(play.world.velocity.z, 0);
  play.run(walk(kNorth), 1);
  EXPECT_EQ(play.world.state, State::freefall);
  EXPECT_NEAR(-play.world.velocity.z, 143 * 4 * kStep, 0.01f) << "as in the air, over a floor too";
}

TEST(EngineLaws, AFloorIsAcquiredAt1_10) {
  const auto level = byTheStep();
  Play play(level, {0, 20, 0});
  ASSERT_GE(play.until(stand(), landed), 0);
  const auto& h = play.history;
  EXPECT_LE(h[h.size() - 2].position.y, 1.10f);
  EXPECT_GT(h[h.size() - 3].position.y, 1.10f);
}

TEST(EngineLaws, AFloorIsKeptTo1_9) {
  const auto level = byTheStep();
  for (const float gap : {1.85f, 1.95f}) {
    Play play(level);
    play.settle();
    play.world.position.y = gap;
    play.run(stand(), 1);
    EXPECT_EQ(play.world.floorlessSteps == 0, gap < 1.9f) << gap;
  }
}

TEST(EngineLaws, RunningTurnsToFreefall28StepsAfterTheFloor) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {10, 2, 10})
                         .physics([](auto p) {
                           p.setControlRate(240);
                           p.setSubsteps(1);
                         })
                         .compile();
  Play play(level);
  play.settle();
  play.until(walk(kNorth), [](const sim::World& w) { return w.floorlessSteps > 0; });
  EXPECT_EQ(
      play.until(walk(kNorth), [](const sim::World& w) { return w.state == State::freefall; }), 27);
  EXPECT_NEAR(play.world.velocity.y, -kGravity * kStep * 28, 1e-3f) << "falls from the edge on";
}

// The depth depends on the moment within a step at which the feet pass their rest height. The test
// takes the mean.
TEST(EngineLaws, TheLegsDipAndRecoverIn0_2Seconds) {
  struct Case {
    float height, speed, from, to;
  };
  for (const Case& c : {Case{7.27f, 54, 0.25f, 0.30f}, Case{23, 95, 0.45f, 0.55f}}) {
    constexpr int kPhases = 16;
    float dips = 0;
    for (int phase = 0; phase < kPhases; ++phase) {
      const auto level = byTheStep();
      Play play(level, {0, c.height + c.speed / 240 * float(phase) / kPhases, 0});
      float lowest = 0;
      ASSERT_GE(play.until(stand(), landed), 0);
      for (int i = 0; i < 60; ++i) {
        play.run(stand(), 1);
        lowest = std::min(lowest, play.world.position.y);
      }
      dips -= lowest / kPhases;
      EXPECT_NEAR(play.world.position.y, 0, 0.02f);
    }
    EXPECT_GT(dips, c.from) << c.speed;
    EXPECT_LT(dips, c.to) << c.speed;
  }
}

TEST(EngineLaws, AboveTheRestHeightALandedPlayerFallsFreely) {
  const auto level = byTheStep();
  Play play(level, {0, 20, 0});
  ASSERT_GE(play.until(stand(), landed), 0);
  const float before = play.world.velocity.y;
  ASSERT_GT(play.world.position.y, 0.3f);
  play.run(stand(), 1);
  EXPECT_NEAR(play.world.velocity.y, before - kGravity * kStep, 1e-4f);
}

TEST(EngineLaws, LandedLastsTwelveStepsThenATickOfRunningThenAHeldJump) {
  for (const int rate : {60, 240}) {
    const auto level = flatLevel([&](auto p) {
      p.setControlRate(uint16_t(rate));
      p.setSubsteps(uint16_t(240 / rate));
    });
    Play play(level, {0, 10, 0});
    ASSERT_GE(play.until(stand(true), landed), 0);
    const int ticks =
        play.until(stand(true), [](const sim::World& w) { return w.state != State::landed; });
    EXPECT_EQ(ticks, rate == 60 ? 2 : 11) << "the tick that lands counts";
    EXPECT_EQ(play.world.state, State::running);
    play.run(stand(true), 1);
    EXPECT_EQ(play.world.state, State::jumping) << rate;
  }
}

// Returns the speed after one step from rest on a floor of this friction and weight.
float firstStep(float friction, float weight = 1) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {400, 2, 400},
                                [&](auto p) {
                                  p.setFriction(friction);
                                  p.setFrictionWeight(weight);
                                })
                         .physics([](auto p) {
                           p.setControlRate(240);
                           p.setSubsteps(1);
                         })
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 1);
  return -play.world.velocity.z;
}

TEST(EngineLaws, GroundAccelerationIsTractionTimesPairFriction) {
  EXPECT_NEAR(firstStep(0.3f), 618 * kStep, 1e-3f) << "Plastic";
  EXPECT_NEAR(firstStep(0.02f), 2060 * 0.16f * kStep, 1e-3f) << "Ice";
  EXPECT_NEAR(firstStep(0.8f), 2060 * 0.55f * kStep, 1e-3f);
  EXPECT_NEAR(firstStep(0.8f, 3), 2060 * (0.8f * 3 + 0.3f) / 4 * kStep, 1e-3f) << "weighted";
}

TEST(EngineLaws, WalkSpeedIsReachedIn0_027Seconds) {
  const auto level = byTheStep();
  Play play(level);
  play.settle();
  const int steps =
      play.until(walk(kNorth), [](const sim::World& w) { return -w.velocity.z > 15.2f; });
  EXPECT_NEAR(float(steps) * kStep, 0.027f, 1.1f * kStep);
}

TEST(EngineLaws, AirAccelerationIs143AlsoForLettingGo) {
  const auto level = byTheStep();
  Play play(level, {0, 100, 0});
  play.run(walk(kNorth), 10);
  EXPECT_NEAR(-play.world.velocity.z, 143 * 10 * kStep, 1e-3f);
  play.run(stand(), 5);
  EXPECT_NEAR(-play.world.velocity.z, 143 * 5 * kStep, 1e-3f);
}

TEST(EngineLaws, TheSpeedAlongASlopeIsTheWalkSpeed) {
  for (const float angle : {-0.4f, 0.2f, 0.4f}) {
    const auto level = support::LevelBuilder()
                           .block({0, 0, 0}, {40, 2, 200},
                                  [&](auto p) { support::setRotation(p.initRotation(), 0, angle); })
                           .compile();
    Play play(level, {0, 2, 0});
    play.settle().run(walk(kNorth), 40);
    const Vec3 from = play.world.position;
    play.run(walk(kNorth), 60);
    EXPECT_NEAR(length(play.world.position - from), 16, 0.05f) << angle;
  }
}

TEST(EngineLaws, TurningIs8_4TimesTheErrorWithALimitInTheAirOnly) {
  const auto level = flatLevel();
  Play ground(level);
  ground.settle().run(walk(0x7000), 1);
  const float error = radiansFromTurns(0x7000);
  EXPECT_NEAR(radiansFromTurns(Turns(ground.world.yaw)), 8.4f * error * kTick, 0.002f);
  Play air(level, {0, 100, 0});
  air.run(walk(0x7000), 1);
  EXPECT_NEAR(radiansFromTurns(Turns(air.world.yaw)), 8.0f * kTick, 0.002f);
}

}  // namespace
}  // namespace obby::test
