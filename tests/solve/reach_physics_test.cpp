// The bound on what a player can reach by physics that are not the engine's defaults.
#include <gtest/gtest.h>

#include <functional>

#include "scenes.h"
#include "solve/proof/body_reach.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

using Physics = std::function<void(schema::PhysicsParams::Builder)>;

// A floor, and a slope so far above it that nobody stands there. `more`: of the floor.
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

float fastestIn(const level::Level& level) {
  const Problem problem = support::plainProblem(level, {});
  return ReachBound(problem, true).fastest();
}

// A slope overhead turns the speed of a jump aside, and is met before anybody stands on it.
TEST(ReachPhysics, WithoutBrakesInTheAirSlopesOverheadMakeFast) {
  EXPECT_FLOAT_EQ(fastestIn(underASlope({})), 16.0f);
  EXPECT_GT(fastestIn(underASlope([](auto p) { p.setAirAccel(0); })), 30);
  EXPECT_GT(fastestIn(underASlope({}, [](auto p) { p.initTrip(); })), 30);
}

// 5000 studs/s^2 for a 240th of a second are more than is wanted.
TEST(ReachPhysics, StrongKeysOvershoot) {
  EXPECT_GT(fastestIn(underASlope([](auto p) {
              p.setGroundAccel(5000);
              p.setMoveGain(1000);
            })),
            31);
}

TEST(ReachPhysics, NoBoundIsKnownOfLegsThatBounce) {
  EXPECT_EQ(unboundedPart(underASlope({}).view()), nullptr);
  EXPECT_NE(unboundedPart(underASlope([](auto p) { p.setHoverDamping(20); }).view()), nullptr);
  EXPECT_NE(unboundedPart(underASlope([](auto p) { p.setSubsteps(1); }).view()), nullptr);
}

// A fast fall feels the floor from afar, and nothing but being Landed keeps from jumping there.
TEST(ReachPhysics, WhoNeverIsLandedJumpsHighAboveTheFloor) {
  EXPECT_LT(springRise(underASlope({}).view().params), 2);
  EXPECT_GT(springRise(underASlope([](auto p) { p.setLandedTime(0); }).view().params), 8);
}

// From where feet come to be carried by a floor that is solid from above only.
float lowestEntry(float slack) {
  LevelBuilder b;
  b.spawn({0, 0, 0});
  b.block({0, 10, -20}, {8, 1, 8}, [](schema::Part::Builder p) { p.initOneWay(); });
  b.physics([=](schema::PhysicsParams::Builder p) { p.setOneWaySlack(slack); });
  const level::Level level = b.compile();
  return supportsOf(support::plainProblem(level, {})).back().entry;
}

TEST(ReachPhysics, WhatCountsAsAboveAOneWayFloorIsLiftedOntoIt) {
  EXPECT_LT(lowestEntry(2), lowestEntry(0.1f) - 1.5f);
}

// Arms that are narrower than the torso touch nothing that the torso does not.
TEST(ReachPhysics, AWideTorsoTouchesFromAfar) {
  const auto wide = [](auto p) {
    p.setArmSpan(1);
    p.setBodyWidth(8);
  };
  EXPECT_GT(limbSide(underASlope(wide).view().params), 4);
}

}  // namespace
}  // namespace obby::solve
