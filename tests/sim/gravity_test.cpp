// A touch can change gravity for the player alone, while the boost lasts.
#include <gtest/gtest.h>

#include "level/params.h"
#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::World;
using support::LevelBuilder;

// Returns a level whose whole floor is the boost.
LevelBuilder boostFloor(const std::function<void(schema::Boost::Builder)>& setter) {
  return LevelBuilder().block({0, -1, 0}, {200, 2, 200},
                              [=](Part::Builder p) { setter(p.initBoost()); });
}

float apexUnder(float gravity) {
  const Params p = flatLevel().view().params;
  return riseOfLaunch(p, gravity, p.jumpSpeed);
}

TEST(BoostedGravity, ALevelOfThatGravityGivesTheSameBits) {
  const auto boosted = boostFloor([](auto b) { b.setGravity(0.5f), b.setForever(true); }).compile();
  const auto plain = flatLevel([](auto p) { p.setGravity(98.1f); });
  Play a(boosted), b(plain);
  a.settle(), b.settle();
  for (int i = 0; i < 400; ++i) {
    const sim::Action action = walk(Turns(i * 300), i % 50 < 3);
    a.run(action), b.run(action);
    ASSERT_EQ(a.world.position, b.world.position) << i;
    ASSERT_EQ(a.world.velocity, b.world.velocity) << i;
  }
  EXPECT_NEAR(a.highest(), apexUnder(98.1f), 0.05f);
}

TEST(BoostedGravity, EndsWithItsBoostInTheAir) {
  const auto level = boostFloor([](auto b) { b.setGravity(0.25f), b.setSeconds(0.25f); }).compile();
  Play play(level);
  play.settle().run(stand(true)).run(stand(), 120);
  EXPECT_GT(play.highest(), apexUnder(196.2f) + 2);
  EXPECT_LT(play.highest(), apexUnder(196.2f * 0.25f) - 5);
}

TEST(BoostedGravity, HighGravityMakesJumpsLow) {
  const auto level = boostFloor([](auto b) { b.setGravity(4), b.setForever(true); }).compile();
  Play play(level);
  play.settle().run(stand(true)).run(stand(), 120);
  EXPECT_NEAR(play.highest(), apexUnder(4 * 196.2f), 0.05f);
  EXPECT_NEAR(play.world.position.y, 0, 0.01f);
}

TEST(BoostedGravity, AtZeroGravityPlayersStandAndJumpsNeverEnd) {
  const auto level = boostFloor([](auto b) { b.setGravity(0), b.setForever(true); }).compile();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  EXPECT_NEAR(play.world.position.y, 0, 0.01f);
  EXPECT_NEAR(-play.world.velocity.z, 16, 0.1f);
  play.run(stand(true)).run(stand(), 120);
  EXPECT_NEAR(play.world.position.y, 53 * 121 * kTick, 1.0f);
}

TEST(BoostedGravity, AHeavyFallStopsAtAThinFloor) {
  LevelBuilder b = boostFloor([](auto boost) { boost.setGravity(10), boost.setForever(true); });
  b.block({0, 40, 0}, {8, 0.2f, 8},
          [](Part::Builder p) { p.initBoost().setGravity(10), p.getBoost().setForever(true); });
  b.block({0, 20, -12}, {30, 0.1f, 16});
  const auto level = b.compile();
  Play play(level, {0, 40.1f, 0});
  play.settle().run(walk(kNorth), 60).run(stand(), 60);
  EXPECT_NEAR(play.world.position.y, 20.05f, 0.05f);
}

TEST(BoostedGravity, AResetRestoresTheLevels) {
  LevelBuilder b = boostFloor([](auto boost) { boost.setGravity(0.25f), boost.setForever(true); });
  b.block({0, 4, 0}, {8, 0.5f, 8},
          [](Part::Builder p) { p.initBoost().setResets(true), p.getBoost().setForever(true); });
  const auto level = b.compile();
  Play play(level, {20, 0, 0});
  play.settle().run(stand(true)).run(stand(), 200);
  EXPECT_NEAR(play.highest(), apexUnder(196.2f * 0.25f), 0.1f);
  Play reset(level, {0, 4.25f, 0});
  reset.settle();
  EXPECT_EQ(reset.world.clockCount, 1);
  reset.run(stand(true)).run(stand(), 30);
  EXPECT_NEAR(reset.highest() - 4.25f, apexUnder(196.2f), 0.1f);
  reset.run(stand(), 60).run(walk(kNorth), 100).settle();
  EXPECT_LT(reset.world.position.y, 1) << "on the floor";
  const float before = reset.world.position.y;
  reset.history.clear();
  reset.run(stand(true)).run(stand(), 200);
  EXPECT_NEAR(reset.highest() - before, apexUnder(196.2f * 0.25f), 0.1f) << "the last touched";
}

TEST(BoostedGravity, DynamicBodiesKeepTheLevels) {
  LevelBuilder b = boostFloor([](auto boost) { boost.setGravity(0.1f), boost.setForever(true); });
  b.block({0, 100, -30}, {4, 4, 4}, [](Part::Builder p) { p.setAnchored(false); });
  const auto level = b.compile();
  Play play(level);
  play.run(stand(true), 60);
  ASSERT_EQ(play.world.clockCount, 1);
  EXPECT_NEAR(play.bodies[0].position.y, 100 - 0.5f * 196.2f, 0.5f);
}

}  // namespace
}  // namespace obby::test
