// The bound on reach for physics other than the engine's defaults.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

using Physics = std::function<void(schema::PhysicsParams::Builder)>;

// Returns a level with a floor, which `more` sets up, and a slope far out of reach above it.
level::Level underASlope(const Physics& physics, const LevelBuilder::PartSetter& more = {}) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}, more).spawn({0, 0, 0});
  b.part([](schema::Part::Builder p) {
    support::set(p.initPosition(), {0, 40, -30});
    support::set(p.initSize(), {4, 4, 4});
    p.setShape(schema::Shape::WEDGE);
  });
  b.physics(physics);
  return b.compile();
}

TEST(ReachPhysics, BouncingLegsAreUnbounded) {
  EXPECT_EQ(unboundedPart(underASlope({}).view()), nullptr);
  EXPECT_NE(unboundedPart(underASlope([](auto p) { p.setHoverDamping(20); }).view()), nullptr);
  EXPECT_NE(unboundedPart(underASlope([](auto p) { p.setSubsteps(1); }).view()), nullptr);
}

// One tick of a fast climb is 7.7 studs and ends far above the top of the truss.
TEST(ReachPhysics, HoldsForAFastClimb) {
  float max = 0;
  for (int i = 0; i < 9; ++i) {
    const float high = 19.1f + 0.2f * float(i);  // after two ticks the torso is still below the top
    LevelBuilder b;
    b.block({0, -0.5f, 0}, {8, 1, 40}).spawn({0, 0, 0});
    b.block({0, 0.5f * high, -7}, {2, high, 6},
            [](schema::Part::Builder p) { p.setShape(schema::Shape::TRUSS); });
    b.physics([](schema::PhysicsParams::Builder p) {
      p.setWalkSpeed(400);
      p.setClimbSpeed(1.15f);
    });
    const level::Level level = b.compile();
    const Problem problem = support::plainProblem(level, {});
    const ReachBound bound(problem, false);
    sim::World w = problem.start;
    for (uint32_t t = 0; t < 240 && w.outcome == sim::Outcome::running; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {0, true, false});
      max = std::max(max, w.position.y - high);
      ASSERT_TRUE(bound.holds(w.position))
          << "truss of " << high << ", tick " << t << ": " << w.position.y << ", " << w.position.z;
    }
  }
  EXPECT_GT(max, 542) << "no player flew off its top";
}

}  // namespace
}  // namespace obby::solve
