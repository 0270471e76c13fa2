// Parts that move after a touch or a signal: falling parts, lifts, ferries.
#include <gtest/gtest.h>

#include "sim/clocks.h"
#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::World;
using support::LevelBuilder;

LevelBuilder fallLevel(float speed, bool solid) {
  return LevelBuilder().block({0, -1, 0}, {6, 2, 6}, [=](Part::Builder p) {
    auto fall = p.initFall();
    fall.setDelay(0.5f);
    fall.setSeconds(1);
    fall.setSpeed(speed);
    fall.setAway(2);
    fall.setSolid(solid);
  });
}

TEST(Fall, WaitsThenFallsWithThePlayerAndReturns) {
  const auto level = fallLevel(10, true).compile();
  Play play(level);
  play.run(stand(), 20);
  EXPECT_NEAR(play.world.position.y, 0, 0.1f) << "still waiting";
  play.run(stand(), 50);
  EXPECT_LT(play.world.position.y, -4);
  EXPECT_EQ(play.world.floorlessSteps, 0) << "rides it down";
  EXPECT_NEAR(play.world.velocity.y, -10, 1);
  const auto& mover = level.view().movers[0];
  EXPECT_LT(sim::poseOf(mover, play.world, 0).position.y, -5);
  play.run(stand(), 150);
  EXPECT_LT(play.world.position.y, -30) << "left alone when it was away";
  EXPECT_EQ(sim::poseOf(mover, play.world, 0).position.y, -1) << "back where it was";
}

TEST(Fall, IsFreeUnderGravityAndLosesCollisionIfSet) {
  const auto level = fallLevel(0, true).compile();
  Play play(level);
  play.run(stand(), 61);
  const float drop = -1 - sim::poseOf(level.view().movers[0], play.world, 0).position.y;
  const float t = float(play.world.clocks[0].ticks) * kTick - 0.5f;
  EXPECT_NEAR(drop, 0.5f * 196.2f * t * t, 0.05f);
  const auto ghost = fallLevel(1, false).compile();
  Play through(ghost);
  through.run(stand(), 60);
  EXPECT_LT(through.world.position.y, -3) << "through a part that sinks slowly";
}

TEST(Fall, NeverStartsIfNothingCanTouchIt) {
  const auto level = LevelBuilder()
                         .block({0, -1, 0}, {6, 2, 6},
                                [](Part::Builder p) {
                                  p.initFall();
                                  p.setTouch(false);
                                })
                         .compile();
  EXPECT_FALSE(level.hasMotion());
  EXPECT_EQ(level.view().moverCount, 0u);
  Play play(level);
  play.run(stand(), 600);
  EXPECT_NEAR(play.world.position.y, 0, 0.05f);
}

void slideTo(schema::Motion::Builder motion, Vec3 from, Vec3 to, float seconds) {
  auto keys = motion.initKeys(2);
  support::set(keys[0].initPosition(), from);
  support::set(keys[1].initPosition(), to);
  keys[1].setTime(seconds);
}

LevelBuilder liftLevel(schema::Repeat repeat, bool carries, float seconds = 0) {
  return LevelBuilder().block({0, -1, 0}, {8, 2, 8}, [=](Part::Builder p) {
    auto motion = p.initMotion();
    slideTo(motion, {0, -1, 0}, {20, -1, 0}, 2);
    motion.setTrigger(schema::MotionTrigger::TOUCH);
    motion.setRepeat(repeat);
    motion.setCarries(carries);
    motion.setSeconds(seconds);
  });
}

float restAt(const level::Level& level, const World& w) {
  return sim::poseOf(level.view().movers[0], w, 0).position.x;
}

TEST(TriggeredMotion, RestsUntilTouchedAtAnyTime) {
  const auto level = liftLevel(schema::Repeat::ONCE, true).compile();
  EXPECT_FALSE(level.hasMotion()) << "nothing depends on the level's clock";
  Play play(level, {0, 60, 0});
  const int landed = play.until(stand(), [](const World& w) { return w.clockCount > 0; });
  ASSERT_GT(landed, 30);
  EXPECT_EQ(restAt(level, play.world), 0);
  play.run(stand(), 60);
  EXPECT_NEAR(restAt(level, play.world), 10, 0.01f);
  EXPECT_NEAR(play.world.position.x, 10, 0.7f) << "carried";
  play.run(stand(), 300);
  EXPECT_NEAR(restAt(level, play.world), 20, 0.01f) << "once: stays at its last key";
}

TEST(TriggeredMotion, CarriesAtItsSpeedFromTheFirstTickOn) {
  const auto level = liftLevel(schema::Repeat::ONCE, true).compile();
  Play play(level);
  play.until(stand(), [](const World& w) { return w.clockCount > 0; });
  for (int i = 0; i < 100; ++i) {
    play.run(stand());
    ASSERT_LE(absf(play.world.velocity.x), 10.5f) << "tick " << i;
  }
  EXPECT_NEAR(play.world.velocity.x, 10, 0.1f);
}

TEST(TriggeredMotion, MovesThereAndBackOnceThenRests) {
  LevelBuilder b = liftLevel(schema::Repeat::PING_PONG, false);
  b.block({0, -30, 0}, {100, 2, 100});
  const auto level = b.compile();
  Play play(level);
  play.run(walk(kNorth), 20);
  play.until(walk(kNorth), [](const World& w) { return w.position.y < -20; });
  ASSERT_EQ(play.world.clockCount, 1);
  float farthest = 0;
  for (int i = 0; i < 300; ++i) {
    play.run(stand());
    farthest = maxf(farthest, restAt(level, play.world));
  }
  EXPECT_NEAR(farthest, 20, 0.2f);
  EXPECT_EQ(play.world.clockCount, 0);
  EXPECT_EQ(restAt(level, play.world), 0);
}

TEST(TriggeredMotion, LoopsUntilItsTimeIsOver) {
  LevelBuilder b = liftLevel(schema::Repeat::LOOP, false, 5);
  b.block({0, -30, 0}, {100, 2, 100});
  const auto level = b.compile();
  Play play(level);
  play.run(walk(kNorth), 60);
  play.until(stand(), [&](const World& w) { return w.clocks[0].ticks >= 270; });
  EXPECT_NEAR(restAt(level, play.world), 5, 0.2f) << "in its third round";
  play.run(stand(), 60);
  EXPECT_EQ(restAt(level, play.world), 0);
}

TEST(TriggeredMotion, ASignalMovesAPartThatIsFarAway) {
  LevelBuilder b;
  b.block({0, -1, 0}, {200, 2, 200}).block({0, 0.1f, -6}, {4, 0.2f, 2}, [](Part::Builder p) {
    p.initButton().setSignal("door");
    p.getButton().setSeconds(10);
  });
  b.block({50, 1, 50}, {4, 2, 4}, [](Part::Builder p) {
    auto motion = p.initMotion();
    slideTo(motion, {50, 1, 50}, {50, 21, 50}, 1);
    motion.setTrigger(schema::MotionTrigger::SIGNAL);
    motion.setSignal("door");
    motion.setRepeat(schema::Repeat::ONCE);
  });
  const auto level = b.compile();
  Play play(level);
  play.settle();
  const auto& mover = level.view().movers[0];
  EXPECT_EQ(sim::poseOf(mover, play.world, 0).position.y, 1);
  play.until(walk(kNorth), [](const World& w) { return w.clockCount > 0; });
  play.run(stand(), 90);
  EXPECT_NEAR(sim::poseOf(mover, play.world, 0).position.y, 21, 0.01f);
}

}  // namespace
}  // namespace obby::test
