// The bound on what a player can reach, where the body is inside of a part before anything pushes
// it out: a wall presses it in, a seat holds it there.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// Plays on by `keys` and gives how high the feet came; the bound must hold them all the time.
float highestHeld(const level::Level& level, bool mayJump, uint32_t ticks,
                  const std::function<sim::Action(uint32_t)>& keys) {
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, mayJump);
  sim::World w = problem.start;
  float highest = w.position.y;
  for (uint32_t t = 0; t < ticks && w.outcome == sim::Outcome::running; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, keys(t));
    highest = std::max(highest, w.position.y);
    EXPECT_TRUE(bound.holds(w.position))
        << "tick " << t << ": " << w.position.x << ", " << w.position.y << ", " << w.position.z;
    if (testing::Test::HasFailure()) break;
  }
  return highest;
}

// A wall of 14 studs, and a taller block that slides at it, past its face by `beyond`, beside the
// start.
LevelBuilder press(float beyond) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 120}).spawn({20, 0, 0});
  b.block({0, -3, -30}, {60, 34, 40});
  b.block({0, 5, 40}, {30, 50, 40}, [=](schema::Part::Builder p) {
    const Vec3 from{0, 5, 40}, to{0, 5, 10 - beyond};
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::ONCE);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), from);
    support::set(keys[1].initPosition(), to);
    keys[1].setTime((from.z - to.z) / 10);
  });
  return b;
}

// Deeper in the wall than it is high above them, they come out at its top.
TEST(ReachPressed, HoldsWhomASlidingBlockPressesIntoAWall) {
  const level::Level level = press(15).compile();
  const Turns aside = turnsFromRadians(kPi / 2);  // toward -X
  const float highest = highestHeld(level, false, 400, [=](uint32_t t) {
    return sim::Action{aside, t < 75, false};
  });
  EXPECT_GT(highest, 13) << "nobody was lifted";
}

// Up into a thick ceiling, by less than a thousandth of a stud a tick: from its upper half they are
// put out above it, much higher than the lift ever comes.
TEST(ReachPressed, HoldsWhomASlowLiftPressesThroughACeiling) {
  LevelBuilder b;
  b.block({0, 14, 0}, {60, 16, 60}).spawn({0, 0, 34});
  b.block({0, -0.5f, 30}, {8, 1, 20});
  b.block({0, -20, 0}, {40, 40, 40}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::ONCE);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, -20, 0});
    support::set(keys[1].initPosition(), {0, -7, 0});
    keys[1].setTime(260);
  });
  const float highest = highestHeld(b.compile(), false, 15'700, [](uint32_t t) {
    return sim::Action{0, t < 126, false};
  });
  EXPECT_GT(highest, 21) << "nobody was pressed through";
}

// What stops well before the wall presses nobody into it.
TEST(ReachPressed, ABlockThatStopsBeforeTheWallLiftsNobody) {
  const auto jumpsUp = [](const LevelBuilder& built) {
    LevelBuilder b = built;
    const level::Level level = b.compile();
    const Problem problem = support::plainProblem(level, {});
    return ReachBound(problem, true).jumpsTo(boxAt({0, 20, -30}, {20, 2, 20}));
  };
  EXPECT_EQ(jumpsUp(press(-6)), ReachBound::kNever);
  EXPECT_NE(jumpsUp(press(6)), ReachBound::kNever);
}

// The level's bounds of what turns are a cube, and the bar is but a stud high: nobody beside the
// tower is within its reach.
TEST(ReachPressed, ABarThatTurnsAboveATowerLiftsNobody) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 60}).spawn({20, 0, 0});
  b.block({0, 10, 0}, {8, 20, 8});
  b.block({0, 21, 0}, {16, 1, 1},
          [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(1); });
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  EXPECT_EQ(ReachBound(problem, true).jumpsTo(boxAt({0, 24, 0}, {4, 2, 4})), ReachBound::kNever);
}

// Of a turning block and a wall the block is the lower one, whatever the cube.
TEST(ReachPressed, ABlockThatTurnsBesideATallerWallLiftsOntoItself) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 60}).spawn({20, 0, 0});
  b.block({0, 4, -9}, {20, 8, 4});
  b.block({0, 2, 0}, {12, 4, 12},
          [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(1); });
  const level::Level level = b.compile();
  // Pressed by nothing, the legs are lifted from some 3 studs below its top at 4.
  EXPECT_LT(supportsOf(support::plainProblem(level, {})).back().entry, 0);
}

// A long seat reaches out of a wall, and holds its player deep inside.
TEST(ReachPressed, HoldsWhoSitsInAWall) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 30}).spawn({0, 0, 0});
  b.block({0, -3, -35}, {60, 34, 50});
  b.block({0, 0.5f, -26}, {2, 1, 34}, [](schema::Part::Builder p) { p.initSeat(); });
  const level::Level level = b.compile();
  const float highest = highestHeld(level, true, 200, [](uint32_t t) {
    return sim::Action{0, t < 60, t == 100};
  });
  EXPECT_GT(highest, 14) << "nobody was lifted";
}

// A chair against a wall holds nobody in it. The wall is higher than a jump off a slope, for which
// the bound takes any seat.
TEST(ReachPressed, ASeatBesideAWallLiftsNobody) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 30}).spawn({0, 0, 0});
  b.block({0, 20, -20}, {60, 40, 20});
  b.block({0, 0.5f, -9}, {2, 1, 2}, [](schema::Part::Builder p) { p.initSeat(); });
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  EXPECT_EQ(ReachBound(problem, true).jumpsTo(boxAt({0, 46, -20}, {20, 2, 10})),
            ReachBound::kNever);
}

// Legs are thrown off what rises faster than off what stands.
TEST(ReachPressed, LegsAreThrownHigherOffALift) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.block({0, -10, -6}, {4, 1, 4}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    motion.setRepeat(schema::Repeat::ONCE);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, -10, -6});
    support::set(keys[1].initPosition(), {0, 3.5f, -6});
    keys[1].setTime(13.5f / 40);
  });
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, false);
  // Whoever steps onto it from two studs below has some 30 studs/s more than its 40.
  EXPECT_EQ(bound.jumpsTo(boxAt({0, 19, -6}, {4, 2, 4})), 0u);
  EXPECT_EQ(bound.jumpsTo(boxAt({0, 40, -6}, {4, 2, 4})), ReachBound::kNever);
}

// The first tick of a jump is as fast as the jump, whatever is the fastest fall.
TEST(ReachPressed, HoldsWhoJumpsFasterThanAnybodyFalls) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.physics([](schema::PhysicsParams::Builder p) { p.setJumpSpeed(1000); });
  const level::Level level = b.compile();
  float highest = 0;
  for (uint32_t jumpAt = 10; jumpAt < 50; ++jumpAt) {
    highest = std::max(highest, highestHeld(level, true, 200, [=](uint32_t t) {
                         return sim::Action{0, true, t == jumpAt};
                       }));
  }
  EXPECT_GT(highest, 595) << "nobody jumped off in the air";
}

}  // namespace
}  // namespace obby::solve
