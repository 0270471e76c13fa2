// The bound on reach if something besides keys moves the player: walls that push, seats, and
// teleporters that keep the speed.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/unreachable.h"

namespace obby::solve {
namespace {

Problem reachGivenProblemOf(const level::Level& level) {
  return {level.view(),
          {},
          sim::makeWorld(level.view(), level.spawns()[0]),
          sim::startBodies(level.view()),
          level.bounds(),
          level.hasMotion()};
}

// Adds a wall that moves from `from` to `to` along Z in `seconds`, too tall to stand on.
void addWall(LevelBuilder& b, float from, float to, float seconds) {
  b.block({0, 11, from}, {8, 20, 4}, [=](schema::Part::Builder p) {
    auto motion = p.initMotion();
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 11, from});
    support::set(keys[1].initPosition(), {0, 11, to});
    keys[1].setTime(seconds);
    motion.setRepeat(schema::Repeat::ONCE);
  });
}

// The wall pushes a jumping player in its path, farther than any jump.
TEST(ReachBound, HoldsForAWallThatPushesInTheAir) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {32, 1, 8}).spawn({12, 0, 0});
  addWall(b, 60, -60, 2.4f);
  const level::Level level = b.compile();
  const Problem problem = reachGivenProblemOf(level);
  const ReachBound bound(problem, true);
  const Turns aside = turnsFromRadians(kPi / 2);  // toward -X
  sim::World w = problem.start;
  float farthest = 0;
  for (uint32_t t = 0; t < 130; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {aside, t < 46, t == 65});
    if (w.position.y > -1) farthest = std::min(farthest, w.position.z);
    ASSERT_TRUE(bound.holds(w.position))
        << "tick " << t << ": " << w.position.x << ", " << w.position.y << ", " << w.position.z;
  }
  EXPECT_LT(farthest, -18) << "no player was pushed";
}

// The bound considers a wall's push only for players that the wall can meet.
TEST(ReachBound, ADistantWallPushesNoPlayer) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.block({0, -0.5f, -120}, {8, 1, 8});
  addWall(b, -60, -114, 2);
  const level::Level level = b.compile();
  const Problem problem = reachGivenProblemOf(level);
  EXPECT_EQ(ReachBound(problem, true).jumpsTo(boxAt({0, 3, -120}, {4, 2, 4})), ReachBound::kNever);
}

// Feet next to a small spinning carrier are faster than any point of the part.
TEST(ReachBound, HoldsForAThrowByASmallSpinner) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {16, 1, 8}).spawn({4, 0, -0.8f}, kPi / 2);
  b.block({0, 0, 0}, {0.2f, 0.2f, 0.2f}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    auto spin = motion.initSpin();
    support::set(spin.initAxis(), {1, 0, 0});
    spin.setSpeed(40);
  });
  const level::Level level = b.compile();
  const Problem problem = reachGivenProblemOf(level);
  const ReachBound bound(problem, true);
  const Turns aside = turnsFromRadians(kPi / 2);  // toward -X
  float highest = 0;
  for (uint32_t jumpAt = 0; jumpAt < 60; ++jumpAt) {
    sim::World w = problem.start;
    for (uint32_t t = 0; t < 120; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {aside, true, t == jumpAt});
      highest = std::max(highest, w.position.y);
      ASSERT_TRUE(bound.holds(w.position))
          << "jump at " << jumpAt << ", tick " << t << ", height " << w.position.y;
    }
  }
  EXPECT_GT(highest, 12) << "no player was thrown";
}

// With these physics a part counts as touched from a stud away, so a pad throws from above its top.
TEST(ReachBound, HoldsForAPadThatThrowsFromADistance) {
  float highest = 0;
  for (int i = 0; i < 20; ++i) {
    LevelBuilder b;
    b.block({0, -0.5f, 0}, {8, 1, 8}, [](schema::Part::Builder p) {
      p.setSolid(false);
      support::set(p.initJumpPad().initVelocity(), {0, 100, 0});
    });
    b.spawn({0, 8 + 0.1f * float(i), 0});
    b.physics([](schema::PhysicsParams::Builder p) { p.setTouchMargin(1); });
    const level::Level level = b.compile();
    const Problem problem = reachGivenProblemOf(level);
    const ReachBound bound(problem, true);
    sim::World w = problem.start;
    for (uint32_t t = 0; t < 80; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {});
      highest = std::max(highest, w.position.y);
      ASSERT_TRUE(bound.holds(w.position)) << "tick " << t << ", height " << w.position.y;
    }
  }
  EXPECT_GT(highest, 26) << "no player was thrown from above it";
}

// With these physics the root sits far above a seat.
TEST(ReachBound, HoldsForASeatHighAboveItsPart) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 3});
  b.block({0, 0.5f, -1}, {2, 1, 2}, [](schema::Part::Builder p) { p.initSeat(); });
  b.physics([](schema::PhysicsParams::Builder p) { p.setSeatHeight(20); });
  const level::Level level = b.compile();
  const Problem problem = reachGivenProblemOf(level);
  const ReachBound bound(problem, true);
  sim::World w = problem.start;
  float highest = 0;
  for (uint32_t t = 0; t < 150; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {0, true, t == 100});
    highest = std::max(highest, w.position.y);
    ASSERT_TRUE(bound.holds(w.position)) << "tick " << t << ", height " << w.position.y;
  }
  EXPECT_GT(highest, 20) << "no player jumped up from there";
}

// The query checks the state after each tick. A teleporter can end a jump within its first tick.
TEST(ReachBound, AForbiddenJumpIntoATeleporterIsNotDetected) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.block({0, 9.2f, 0}, {4, 2, 4}, [](schema::Part::Builder p) {
    p.setSolid(false);
    support::set(p.initTeleport().initPosition(), {0, 100, 0});
  });
  b.physics([](schema::PhysicsParams::Builder p) { p.setJumpSpeed(212); });
  const level::Level level = b.compile();
  PlainQuery asked(level);
  asked.query.goal = boxAt({0, 102, 0}, {4, 4, 4});
  asked.query.forbidden = 1u << uint32_t(sim::State::jumping);
  Problem problem = asked.problem();
  sim::World w = problem.start;
  for (uint32_t t = 0; t <= 10; ++t) {
    sim::advance(w, nullptr, level.view(), &problem.query, {0, false, t == 10});
  }
  EXPECT_EQ(w.outcome, sim::Outcome::goal) << "no player was teleported";
  EXPECT_FALSE(cutOf(problem, {})) << "the query does not see that jump";
  problem.query.maxJumps = 0;
  EXPECT_TRUE(cutOf(problem, {})) << "counted it is";
}

// A player who leaves a fast ramp may rise faster than any jump.
TEST(ReachBound, HoldsForATeleportOffARamp) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 200}).spawn({0, 0, 90});
  b.part([](schema::Part::Builder p) {
    support::set(p.initPosition(), {0, 5, -105});
    support::set(p.initSize(), {8, 10, 10});
    support::setRotation(p.initRotation(), kPi);
    p.setShape(schema::Shape::WEDGE);
  });
  b.block({0, 30, -114}, {20, 60, 8}, [](schema::Part::Builder p) {
    p.setSolid(false);
    auto teleport = p.initTeleport();
    support::set(teleport.initPosition(), {0, 300, 100});
    teleport.setKeepVelocity(true);
  });
  b.physics([](schema::PhysicsParams::Builder p) { p.setWalkSpeed(300); });
  const level::Level level = b.compile();
  const Problem problem = reachGivenProblemOf(level);
  const ReachBound bound(problem, true);
  sim::World w = problem.start;
  float highest = 0;
  for (uint32_t t = 0; t < 200 && w.outcome == sim::Outcome::running; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {0, true, false});
    highest = std::max(highest, w.position.y);
    ASSERT_TRUE(bound.holds(w.position)) << "tick " << t << ", height " << w.position.y;
  }
  EXPECT_GT(highest, 300) << "no player got there";
}

}  // namespace
}  // namespace obby::solve
