// Parts that move, hold, or crush the player, or are solid from one side: teleporters, seats,
// squeezing parts, one-way parts.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::Outcome;
using sim::State;
using sim::World;
using support::LevelBuilder;

void teleporter(LevelBuilder& b, Vec3 at, Vec3 to,
                const std::function<void(schema::Teleport::Builder)>& more = {}) {
  b.block(at, {4, 4, 1}, [=](Part::Builder p) {
    p.setSolid(false);
    auto teleport = p.initTeleport();
    support::set(teleport.initPosition(), to);
    if (more) more(teleport);
  });
}

bool isArrived(const World& w) { return (w.flags & sim::kArrived) != 0; }

TEST(Teleport, PutsThePlayerThereAtRestInTheAir) {
  LevelBuilder b = floorLevel();
  teleporter(b, {0, 2, -8}, {60, 4, 60});
  const auto level = b.compile();
  Play play(level);
  play.settle();
  ASSERT_GE(play.until(walk(kNorth), isArrived), 0);
  EXPECT_TRUE(play.world.position == (Vec3{60, 4, 60}));
  EXPECT_TRUE(play.world.velocity == Vec3{});
  EXPECT_EQ(play.world.state, State::freefall);
  play.run(stand(true), 8);
  EXPECT_EQ(play.world.jumps, 0) << "no jump out of thin air";
  play.run(stand(), 60);
  EXPECT_NEAR(play.world.position.y, 0, 0.1f);
  EXPECT_FALSE(isArrived(play.world));
}

TEST(Teleport, KeepsTheVelocityAndTurnsIfSet) {
  LevelBuilder b = floorLevel();
  teleporter(b, {0, 2, -8}, {60, 4, 60}, [](auto t) {
    t.setKeepVelocity(true);
    t.setTurns(true);
    t.setYaw(1);
  });
  const auto level = b.compile();
  Play play(level);
  play.settle();
  ASSERT_GE(play.until(walk(kNorth), isArrived), 0);
  EXPECT_NEAR(play.world.velocity.z, -16, 0.5f);
  EXPECT_NEAR(radiansFromTurns(play.world.yaw), 1, 0.001f);
}

TEST(Teleport, APairDoesNotBounceThePlayerBack) {
  LevelBuilder b = floorLevel();
  teleporter(b, {0, 2, -8}, {60, 0, 60});
  teleporter(b, {60, 2, 60}, {0, 0, -8});
  const auto level = b.compile();
  Play play(level);
  play.settle();
  ASSERT_GE(play.until(walk(kNorth), isArrived), 0);
  play.run(stand(), 200);
  EXPECT_GT(play.world.position.x, 50) << "inside the other, which does not work";
  play.run(walk(kNorth), 60);
  EXPECT_FALSE(isArrived(play.world));
  ASSERT_GE(play.until(walk(kNorth + 32768), isArrived), 0) << "back into it: works again";
  EXPECT_LT(play.world.position.x, 10);
}

TEST(Seat, HoldsUntilAJumpAndThenHasACooldown) {
  const auto level =
      floorLevel().block({0, 0.5f, -8}, {3, 1, 3}, [](Part::Builder p) { p.initSeat(); }).compile();
  Play play(level);
  play.settle();
  const auto sits = [](const World& w) { return w.state == State::seated; };
  ASSERT_GE(play.until(walk(kNorth), sits), 0);
  play.run(walk(kNorth), 60);
  EXPECT_TRUE(sits(play.world));
  EXPECT_NEAR(play.world.position.z, -8, 1e-4f);
  EXPECT_NEAR(play.world.position.y, -0.5f, 1e-4f) << "the root two studs above the seat's centre";
  play.run(stand(true));
  EXPECT_EQ(play.world.state, State::jumping);
  EXPECT_EQ(play.world.jumps, 1);
  play.run(stand(), 60);
  EXPECT_FALSE(sits(play.world)) << "stands on the seat";
  play.run(stand(), 200);
  EXPECT_TRUE(sits(play.world)) << "after the cooldown it takes again";
}

// Returns a seat that moves forty studs in four seconds, repeatedly.
level::Level movingSeat() {
  return LevelBuilder()
      .block({0, 0, 0}, {4, 1, 4},
             [](Part::Builder p) {
               p.initSeat();
               auto keys = p.initMotion().initKeys(2);
               support::set(keys[1].initPosition(), {40, 0, 0});
               keys[1].setTime(4);
             })
      .compile();
}

TEST(Seat, RidesWithAMovingSeat) {
  const auto level = movingSeat();
  Play play(level, {0, 1, 0});
  play.run(stand(), 120);
  EXPECT_EQ(play.world.state, State::seated);
  EXPECT_NEAR(play.world.position.x, 20, 0.01f);
  EXPECT_NEAR(play.world.velocity.x, 10, 0.01f);
}

// A player who jumps off does not get speed from the jump of the motion back to its start.
TEST(Seat, TheRestartOfAMotionAddsNoSpeed) {
  const auto level = movingSeat();
  Play play(level, {0, 1, 0});
  play.run(stand(), 239);
  ASSERT_EQ(play.world.state, State::seated);
  ASSERT_GT(play.world.position.x, 39);
  play.run(stand(true)).run(stand(), 30);
  EXPECT_NE(play.world.state, State::seated);
  EXPECT_NEAR(play.world.position.x, 0, 5);
}

bool isSeated(const World& w) { return w.state == State::seated; }

void dynamicSeat(Part::Builder p) {
  p.initSeat();
  p.setAnchored(false);
}

Pose seatOf(const Play& play) { return poseOf(play.bodies[0], play.level.view().bodies[0]); }

TEST(Seat, ADynamicSeatHoldsThePlayer) {
  const auto level = floorLevel().block({0, 3, -8}, {3, 1, 3}, dynamicSeat).compile();
  Play play(level);
  play.run(stand(), 90);  // the seat falls
  ASSERT_GE(play.until(walk(kNorth), isSeated), 0);
  play.run(walk(kNorth), 30);
  const Pose seat = seatOf(play);
  EXPECT_NEAR(seat.position.y, 0.5f, 0.02f);
  const Vec3 root = seat.position + seat.rotation.y * 2.0f;
  EXPECT_NEAR(length(play.world.position - (root - Vec3{0, 3, 0})), 0, 1e-3f);
  EXPECT_NEAR(length(play.world.velocity), 0, 0.1f);
  play.run(stand(true));
  EXPECT_EQ(play.world.state, State::jumping);
  EXPECT_NEAR(play.world.velocity.y, 53, 0.1f);
}

TEST(Seat, AFallingSeatCarriesThePlayerUntilItsRemoval) {
  LevelBuilder b;
  b.block({0, 0, 0}, {3, 1, 3}, dynamicSeat).physics([](auto p) {
    p.setSeatHeight(10);
    p.setFallenPartsHeight(-50);
  });
  const auto level = b.compile();
  Play play(level, {0, 0.5f, 0});
  ASSERT_GE(play.until(stand(), isSeated, 5), 0);
  const auto isGone = [&] { return play.bodies[0].state == sim::RigidBodyState::gone; };
  for (int i = 0; i < 120; ++i) {
    play.run(stand());
    if (isGone()) break;
    ASSERT_TRUE(isSeated(play.world)) << i;
    EXPECT_NEAR(play.world.position.y, seatOf(play).position.y + 7, 1e-3f) << i;
    EXPECT_NEAR(play.world.velocity.y, play.bodies[0].velocity.y, 3.5f) << i;
  }
  ASSERT_TRUE(isGone());
  EXPECT_EQ(play.world.state, State::freefall);
  const float left = play.world.position.y;
  EXPECT_LT(left, -30);
  play.run(stand());
  EXPECT_LT(play.world.position.y, left - 1) << "falls on";
}

// Returns a level with a press that comes down to `lowest` studs above the floor.
LevelBuilder pressLevel(schema::Squeeze squeeze, float lowest = 1) {
  return floorLevel().block({0, 12, 0}, {20, 4, 20}, [=](Part::Builder p) {
    p.setSqueeze(squeeze);
    auto motion = p.initMotion();
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 12, 0});
    support::set(keys[1].initPosition(), {0, lowest + 2, 0});
    keys[1].setTime(2);
    motion.setRepeat(schema::Repeat::ONCE);
  });
}

TEST(Squeeze, KillsUnderAPressThatKillsAndNamesIt) {
  const auto level = pressLevel(schema::Squeeze::KILL).compile();
  Play play(level);
  play.run(stand(), 200);
  EXPECT_EQ(play.world.outcome, Outcome::killed);
  EXPECT_EQ(play.world.part, 1u);
}

TEST(Squeeze, OnlyPushesUnderAPressThatDoesNotKill) {
  const auto level = pressLevel(schema::Squeeze::PUSH).compile();
  Play play(level);
  play.run(stand(), 200);
  EXPECT_EQ(play.world.outcome, Outcome::running);
}

TEST(Squeeze, SparesAPlayerWithSpaceToStand) {
  const auto level = pressLevel(schema::Squeeze::KILL, 5.5f).compile();
  Play play(level);
  play.settle().run(stand(true), 200);
  EXPECT_EQ(play.world.outcome, Outcome::running);
}

LevelBuilder shelf(Vec3 direction, float y = 5, bool turned = false) {
  return floorLevel().block({0, y, 0}, {20, 1, 20}, [=](Part::Builder p) {
    support::set(p.initOneWay().initDirection(), direction);
    if (turned) support::setRotation(p.initRotation(), 0, 3.14159265f);
  });
}

TEST(OneWay, IsJumpedThroughFromBelowAndStoodOnFromAbove) {
  const auto level = shelf({0, 1, 0}).compile();
  Play play(level);
  play.settle().run(stand(true), 40).run(stand(), 60);
  EXPECT_NEAR(play.world.position.y, 5.5f, 0.1f);
  EXPECT_EQ(play.world.state, State::running);
}

TEST(OneWay, StopsAnySpeedFromItsSolidSide) {
  const auto level = shelf({0, 1, 0}).compile();
  Play play(level, {0, 100, 0});
  play.world.velocity.y = -400;
  play.run(stand(), 100);
  EXPECT_NEAR(play.world.position.y, 5.5f, 0.1f);
}

TEST(OneWay, LetsPlayersFallThroughFromTheOtherSide) {
  for (const bool turned : {false, true}) {
    const auto level = shelf(turned ? Vec3{0, 1, 0} : Vec3{0, -1, 0}, 8, turned).compile();
    Play down(level, {0, 20, 0});
    down.run(stand(), 120);
    EXPECT_NEAR(down.world.position.y, 0, 0.1f) << "fell through";
    Play up(level);
    up.settle().run(stand(true), 60);
    EXPECT_LT(up.highest(), 2.6f) << "the head meets it";
  }
}

TEST(OneWay, AWallHoldsAPlayerWhoPushesAndTurnsAgainstIt) {
  const auto level = floorLevel()
                         .block({0, 5, -10}, {40, 10, 0.2f},
                                [](Part::Builder p) {
                                  support::set(p.initOneWay().initDirection(), {0, 0, 1});
                                })
                         .compile();
  Play play(level);
  play.settle();
  Random random(4, 0);
  for (int i = 0; i < 400; ++i) {
    const Turns wiggle = Turns(int(random.below(20000)) - 10000);
    play.run(walk(Turns(kNorth + wiggle), random.below(4) == 0), 3);
    ASSERT_GT(play.world.position.z, -10) << i;
    if (absf(play.world.position.x) > 15) break;
  }
  Play back(level, {0, 0, -14});
  back.settle().run(walk(kNorth + 32768), 60);
  EXPECT_GT(back.world.position.z, -8) << "through from behind";
}

}  // namespace
}  // namespace obby::test
