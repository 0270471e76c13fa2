// The bound on reach where the body is inside a part before depenetration: a wall presses it in, or
// a seat holds it there.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// Plays `keys`, and returns the maximum height of the feet. The bound must contain the player
// throughout.
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

// Returns a wall 14 studs tall, and a taller block that slides towards it and past its face by
// `beyond`. The start is next to them.
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

// Players who are farther inside the wall than below its top come out at the top.
TEST(ReachPressed, HoldsForABlockThatPressesIntoAWall) {
  const level::Level level = press(15).compile();
  const Turns aside = turnsFromRadians(kPi / 2);  // toward -X
  const float highest = highestHeld(level, false, 400, [=](uint32_t t) {
    return sim::Action{aside, t < 75, false};
  });
  EXPECT_GT(highest, 13) << "no player was lifted";
}

// A lift presses the player up into a thick ceiling, by less than a thousandth of a stud a tick.
// From the ceiling's upper half the player exits at its top, much higher than the lift goes.
TEST(ReachPressed, HoldsForALiftThatPressesThroughACeiling) {
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
  EXPECT_GT(highest, 21) << "no player was pressed through";
}

// A long seat extends from a wall, and holds its player deep inside.
TEST(ReachPressed, HoldsForASeatInsideAWall) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 30}).spawn({0, 0, 0});
  b.block({0, -3, -35}, {60, 34, 50});
  b.block({0, 0.5f, -26}, {2, 1, 34}, [](schema::Part::Builder p) { p.initSeat(); });
  const level::Level level = b.compile();
  const float highest = highestHeld(level, true, 200, [](uint32_t t) {
    return sim::Action{0, t < 60, t == 100};
  });
  EXPECT_GT(highest, 14) << "no player was lifted";
}

// The first tick of a jump has the full jump speed, even if that exceeds the maximum fall speed.
TEST(ReachPressed, HoldsForAJumpFasterThanTheFallLimit) {
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
  EXPECT_GT(highest, 595) << "no player jumped off in the air";
}

}  // namespace
}  // namespace obby::solve
