// The bound on reach at extreme physics, and in places where a climb, a touch or a great distance
// extends what a player can do.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// A fast rising floor lies on a truss. When the climb passes the truss, the floor's top is still
// higher. The climb continues onto the floor at the speed of both, and a tick later the floor is
// far below.
TEST(ReachExtremes, HoldsForAClimbOntoARisingFloor) {
  float max = 0;
  for (int i = 0; i < 10; ++i) {
    const float high = 8.1f + 0.2f * float(i), over = 1.7f;
    LevelBuilder b;
    b.block({0, -0.5f, 0}, {8, 1, 40}).spawn({0, 0, 0});
    b.block({0, 0.5f * high, -7}, {4, high, 6},
            [](schema::Part::Builder p) { p.setShape(schema::Shape::TRUSS); });
    b.block({0, high + 0.5f * over, -7}, {4, over, 6}, [](schema::Part::Builder p) {
      support::set(p.initConveyor().initVelocity(), {0, 200, 0});
    });
    b.physics([](schema::PhysicsParams::Builder p) { p.setWalkSpeed(70); });
    const level::Level level = b.compile();
    const Problem problem = support::plainProblem(level, {});
    const ReachBound bound(problem, false);
    sim::World w = problem.start;
    for (uint32_t t = 0; t < 300 && w.outcome == sim::Outcome::running; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {0, true, false});
      max = std::max(max, w.position.y - high - over);
      ASSERT_TRUE(bound.holds(w.position))
          << "truss of " << high << ", tick " << t << ": " << w.position.y << ", " << w.position.z;
    }
  }
  EXPECT_GT(max, 150) << "no player was thrown by both";
}

// With strong dampers and no springs, a player resting on the floor reaches the floor's speed
// within a tick, and never exceeds it.
TEST(ReachExtremes, HoldsForALaunchByAFastFloor) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}, [](schema::Part::Builder p) {
    support::set(p.initConveyor().initVelocity(), {0, 200, 0});
  });
  b.spawn({0, 0, 0});
  b.physics([](schema::PhysicsParams::Builder p) {
    p.setHoverStiffness(1);
    p.setHoverDamping(220);
    p.setHoverLimit(1'000'000);
    p.setLandedTime(0.5f);
    p.setMaxFallSpeed(220);
  });
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, false);
  float highest = 0;
  for (int i = 0; i < 20; ++i) {
    sim::World w = problem.start;
    w.position.y = 0.25f * float(i);
    for (uint32_t t = 0; t < 400; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {});
      highest = std::max(highest, w.position.y);
      ASSERT_TRUE(bound.holds(w.position)) << i << ", tick " << t << ": " << w.position.y;
    }
  }
  // A player leaves the floor at the floor's speed. The legs sense the floor from up to 5 studs
  // above, and it moves up to 3.3 studs in the last tick.
  constexpr float kThrown = 200 * 200 / (2 * 196.2f);  // studs, at the speed of the floor
  EXPECT_GT(highest, kThrown - 5) << "no player was as fast";
  EXPECT_LT(highest, kThrown + 5 + 3.4f) << "a player was faster";
}

// A small player who cannot walk touches a part with a corner of the rotated body.
TEST(ReachExtremes, APartTouchedByACornerIsReached) {
  LevelBuilder b;
  b.spawn({0, 0, 0}, kPi / 4);
  b.block({2.47f, 0, 0}, {2, 4, 2});
  b.physics([](schema::PhysicsParams::Builder p) {
    p.setWalkSpeed(0);
    p.setTouchMargin(1);
    p.setArmSpan(0.1f);
    p.setBodyWidth(0.1f);
    p.setBodyDepth(0.1f);
  });
  const level::Level level = b.compile();
  const uint32_t touched[] = {0};
  PlainQuery asked(level);
  asked.query.goal.touchCount = 1;
  asked.query.touched = touched;
  asked.query.touchedCount = 1;
  const Problem problem = asked.problem();
  sim::World w = problem.start;
  sim::advance(w, nullptr, level.view(), &problem.query, {});
  EXPECT_EQ(w.outcome, sim::Outcome::goal) << "no player touched it";
  EXPECT_EQ(ReachBound(problem, false).jumpsTo(problem.query.goal), 0u);
}

}  // namespace
}  // namespace obby::solve
