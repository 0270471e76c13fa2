// The horizontal speed that a level allows: 1.5 times the sum of walking and the fastest part.
#include "level/speeds.h"

#include <gtest/gtest.h>

#include "support/level_builder.h"

namespace obby::level {
namespace {

using support::LevelBuilder;
using support::set;
using PartSetter = LevelBuilder::PartSetter;

constexpr float
    kWalk = 16,
    kFarthest = 12.51f;  // distance of the part's farthest point from its centre: half its diagonal

// Returns the speed that the part below adds, in studs/s.
float given(const PartSetter& setter) {
  const Level level = LevelBuilder().block({50, 0, 0}, {24, 1, 7}, setter).compile();
  return level.view().maxSideSpeed / 1.5f - kWalk;
}

PartSetter speedsSpin(float speed, bool carries, Vec3 pivot = {}) {
  return [=](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(carries);
    motion.initSpin().setSpeed(speed);
    set(motion.getSpin().initPivot(), pivot);
  };
}

TEST(SideSpeed, CountsSpinningCarriers) {
  EXPECT_NEAR(given(speedsSpin(3, true)), 3 * kFarthest, 0.1f);
  EXPECT_NEAR(given(speedsSpin(-3, true)), 3 * kFarthest, 0.1f);
  EXPECT_NEAR(given(speedsSpin(2, true, {0, 0, 30})), 2 * (30 + kFarthest), 0.1f);
}

TEST(SideSpeed, CountsSpinningSeats) {
  const auto seat = [](schema::Part::Builder p) { speedsSpin(3, false)(p), p.initSeat(); };
  EXPECT_NEAR(given(seat), 3 * kFarthest, 0.1f);
}

// These parts push players but do not carry them, so the grid's lists do not get longer.
TEST(SideSpeed, IgnoresSpinsThatDoNotCarry) { EXPECT_NEAR(given(speedsSpin(3, false)), 0, 1e-4f); }

TEST(SideSpeed, CountsTurnsBetweenKeys) {
  const auto turning = [](schema::Part::Builder p) {
    p.initMotion().setCarries(true);
    auto keys = p.getMotion().initKeys(2);
    for (uint32_t i = 0; i < 2; ++i) {
      set(keys[i].initPosition(), {50 + 10 * float(i), 0, 0});
      support::setRotation(keys[i].initRotation(), float(i));
      keys[i].setTime(0.5f * float(i));
    }
  };
  EXPECT_NEAR(given(turning), 20 + 2 * kFarthest, 0.2f);
}

TEST(SideSpeed, CountsConveyorsThatTurn) {
  const auto conveyor = [](Vec3 angular, bool rides) {
    return given([=](schema::Part::Builder p) {
      set(p.initConveyor().initVelocity(), {0, 0, 5});
      set(p.getConveyor().initAngular(), angular);
      if (rides) speedsSpin(1, true)(p);
    });
  };
  EXPECT_NEAR(conveyor({}, false), 5, 1e-3f);
  EXPECT_NEAR(conveyor({0, -3, 0}, false), 5 + 3 * 12.5f, 0.1f);
  EXPECT_NEAR(conveyor({8, 0, 0}, false), 5 + 8 * 0.5f, 0.1f);
  EXPECT_NEAR(conveyor({}, true), 5 + kFarthest, 0.1f);
  EXPECT_NEAR(conveyor({0, -3, 0}, true), 5 + 4 * kFarthest, 0.1f);
  EXPECT_NEAR(conveyor({8, 0, 0}, true), 5 + 9 * kFarthest, 0.1f);
}

TEST(SideSpeed, HasABound) { EXPECT_NEAR(given(speedsSpin(100, true)), 500, 0.1f); }

}  // namespace
}  // namespace obby::level
