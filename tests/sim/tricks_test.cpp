// The effect of each trick if it is allowed, and the usual motion otherwise (docs/physics.md,
// tricks).
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::State;
using support::LevelBuilder;

constexpr float kJumpRise = 7.269f;

// Returns the apex of a jump on the spot while the body turns to `heading`.
float apexOfTurningJump(uint16_t tricks, Turns heading) {
  const auto level = flatLevel();
  Play play(level);
  play.tricks = tricks;
  play.settle().run(walk(heading, true)).run(stand(), 60);
  return play.highest();
}

TEST(Tricks, AJumpMadeWhileTurningIsHeldUntilTheFloorIsLost) {
  EXPECT_NEAR(apexOfTurningJump(0, kEast), kJumpRise, 0.01f);
  // Measured: 9.0 to 9.6 studs, for frames of two to four steps.
  const float held = apexOfTurningJump(kHeldJump, kEast);
  EXPECT_GT(held, 9.0f);
  EXPECT_LT(held, 9.75f);
}

TEST(Tricks, AHeldJumpNeedsATurnOf0_137Radians) {
  const Turns little = turnsFromRadians(0.12f), enough = turnsFromRadians(0.15f);
  EXPECT_NEAR(apexOfTurningJump(kHeldJump, little), kJumpRise, 0.01f);
  EXPECT_GT(apexOfTurningJump(kHeldJump, enough), 9.0f);
}

TEST(Tricks, AHeldJumpKeepsItsSpeed) {
  const auto level = flatLevel();
  Play play(level);
  play.tricks = kHeldJump;
  play.settle().run(walk(kEast, true), 2);
  EXPECT_EQ(play.world.state, State::jumping);
  EXPECT_EQ(play.world.velocity.y, 53);
  EXPECT_NEAR(play.world.position.y, 2 * 53 * kTick, 1e-3f);
}

TEST(Tricks, AHeldJumpEndsAtACeiling) {
  const auto level =
      LevelBuilder().block({0, -1, 0}, {20, 2, 20}).block({0, 6.5f, 0}, {20, 2, 20}).compile();
  Play play(level);
  play.tricks = kHeldJump;
  play.settle().run(walk(kEast, true)).run(stand(), 40);
  EXPECT_EQ(play.world.state, State::running);
}

// Lands from a height with a key held and jumps at once. Returns the apex after the landing.
float apexAfterLanding(uint16_t tricks, bool key) {
  const auto level = flatLevel();
  Play play(level, {0, 6, 0});
  play.tricks = tricks;
  const auto landed = [](const sim::World& w) { return w.state == State::landed; };
  const sim::Action held = key ? walk(kEast) : stand();
  EXPECT_GE(play.until(held, landed), 0);
  play.history.clear();
  play.run({held.heading, held.walk, true}, 8).run(stand(), 40);
  EXPECT_EQ(play.world.jumps, 1);
  return play.highest();
}

TEST(Tricks, ALandingHangsWhileAKeyIsHeldAndAJumpStartsThere) {
  EXPECT_LT(apexAfterLanding(0, true), kJumpRise + 0.01f);
  EXPECT_LT(apexAfterLanding(kHangingLanding, false), kJumpRise + 0.01f);
  const float hung = apexAfterLanding(kHangingLanding, true);
  EXPECT_GT(hung, kJumpRise + 0.3f);
  EXPECT_LT(hung, kJumpRise + 1.1f);
}

TEST(Tricks, AHangingLandingSlowsTo0_375OfItsSpeedInAStep) {
  const auto level = flatLevel([](auto p) {
    p.setControlRate(240);
    p.setSubsteps(1);
  });
  Play play(level, {0, 6, 0});
  play.tricks = kHangingLanding;
  const auto landed = [](const sim::World& w) { return w.state == State::landed; };
  ASSERT_GE(play.until(walk(kEast), landed), 0);
  const float before = play.world.velocity.y;
  play.run(walk(kEast));
  EXPECT_NEAR(play.world.velocity.y, 0.375f * before, 1e-3f);
}

// Returns a level with a wall of two blocks. The lower one is `seam` studs high.
level::Level seamedWall(float seam) {
  return LevelBuilder()
      .block({0, -1, 0}, {40, 2, 40})
      .block({0, seam / 2, -5}, {20, seam, 6})
      .block({0, seam + 10, -5}, {20, 20, 6})
      .compile();
}

// Jumps at the wall, turns sideways after the apex and jumps again. Returns the number of jumps.
int jumpsAtTheWall(uint16_t tricks) {
  const auto level = seamedWall(6);
  Play play(level, {0, 0, 0});
  play.tricks = tricks;
  play.settle().run(walk(kNorth), 40);
  play.run(walk(kNorth, true), 1).run(walk(kNorth), 18).run(walk(kEast, true), 12);
  return play.world.jumps;
}

TEST(Tricks, AWallHopStepsOnTheSeamOfAWall) {
  EXPECT_EQ(jumpsAtTheWall(0), 1);
  EXPECT_EQ(jumpsAtTheWall(kWallHop), 2);
}

TEST(Tricks, ALadderFlickGripsTheTrussAgainWhileRising) {
  const auto level =
      LevelBuilder()
          .block({0, -1, 0}, {40, 2, 40})
          .block({0, 20, -4}, {2, 40, 2}, [](Part::Builder p) { p.setShape(schema::Shape::TRUSS); })
          .compile();
  const auto climbs = [](const sim::World& w) { return w.state == State::climbing; };
  for (const uint16_t tricks : {uint16_t(0), uint16_t(kLadderFlick)}) {
    Play play(level);
    play.tricks = tricks;
    play.settle();
    ASSERT_GE(play.until(walk(kNorth),
                         [&](const sim::World& w) { return climbs(w) && w.position.y > 8; }),
              0);
    play.run(walk(kNorth, true));
    const int ticks = play.until(walk(kNorth), climbs);
    EXPECT_EQ(ticks < 4, tricks != 0) << ticks;
  }
}

// Puts the feet 1.5 studs below a floor, and a tick later beyond its edge. Returns the maximum
// height.
float thrownTo(uint16_t tricks) {
  const auto level = LevelBuilder().block({0, -1, 0}, {20, 2, 20}).compile();
  Play play(level);
  play.tricks = tricks;
  play.settle();
  play.world.position.y = -1.5f;
  play.run(stand());
  play.world.position.x = 15;
  play.history.clear();
  play.run(stand(), 60);
  return play.highest();
}

TEST(Tricks, LegsThrowABodyOffAnEdge) {
  EXPECT_LT(thrownTo(0), -0.5f);
  EXPECT_GT(thrownTo(kLegThrow), 0.5f);
}

}  // namespace
}  // namespace obby::test
