// The bound on what a player can reach by physics that are not the engine's defaults.
#include <gtest/gtest.h>

#include <algorithm>
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

float reachPhysicsFastestIn(const level::Level& level) {
  const Problem problem = support::plainProblem(level, {});
  return ReachBound(problem, true).fastest();
}

// A slope overhead turns the speed of a jump aside, and is met before anybody stands on it.
TEST(ReachPhysics, WithoutBrakesInTheAirSlopesOverheadMakeFast) {
  EXPECT_FLOAT_EQ(reachPhysicsFastestIn(underASlope({})), 16.0f);
  EXPECT_GT(reachPhysicsFastestIn(underASlope([](auto p) { p.setAirAccel(0); })), 30);
  EXPECT_GT(reachPhysicsFastestIn(underASlope({}, [](auto p) { p.initTrip(); })), 30);
}

// A floor, and a slab over it that far up, tilted or not.
float fastestBelow(float height, float tilt) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.block({0, height, 0}, {8, 1, 8},
          [=](schema::Part::Builder p) { support::setRotation(p.initRotation(), 0, tilt); });
  return reachPhysicsFastestIn(b.compile());
}

// Who hops below slopes is made fast again before keys have taken it back.
TEST(ReachPhysics, SlopesThatAJumpMeetsOverheadMakeFast) {
  EXPECT_GT(fastestBelow(8, 0.5f), 30);
  EXPECT_FLOAT_EQ(fastestBelow(60, 0.5f), 16.0f) << "nobody comes so high";
  EXPECT_FLOAT_EQ(fastestBelow(8, 0), 16.0f) << "no slope";
}

// 5000 studs/s^2 for a 240th of a second are more than is wanted.
TEST(ReachPhysics, StrongKeysOvershoot) {
  EXPECT_GT(reachPhysicsFastestIn(underASlope([](auto p) {
              p.setTraction(16667);
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

// Strongly damped legs brake a fall where they feel the floor, and hold who is Landed up there.
TEST(ReachPhysics, WhoseLegsBrakeAFallFarAboveAFloorJumpsThere) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.physics([](schema::PhysicsParams::Builder p) {
    p.setHoverStiffness(500);
    p.setHoverDamping(220);
  });
  const level::Level level = b.compile();
  EXPECT_EQ(unboundedPart(level.view()), nullptr);
  float highest = 0;
  for (float from = 200; from < 400; from += 3) {
    sim::World w = sim::makeWorld(level.view(), {{0, from, 0}, 0, 0});
    for (int t = 0; t < 400 && w.jumps == 0; ++t) {
      const float feet = w.position.y;
      sim::advance(w, nullptr, level.view(), nullptr, {0, false, true});
      if (w.jumps != 0) highest = std::max(highest, feet);
    }
  }
  EXPECT_GT(highest, 2) << "nobody jumped up there";
  EXPECT_LE(highest, springRise(level.view().params));
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

// What counts as touched from afar throws from afar, whatever the springs of the legs.
TEST(ReachPhysics, APadThatIsStoodOnThrowsFromWhereItIsTouched) {
  LevelBuilder b;
  b.spawn({0, 0, 0});
  b.block({0, 9.5f, -20}, {8, 1, 8}, [](schema::Part::Builder p) {
    support::set(p.initJumpPad().initVelocity(), {0, 100, 0});
  });
  b.physics([](schema::PhysicsParams::Builder p) {
    p.setTouchMargin(1);
    p.setFloorKeep(1);
    p.setFloorAcquire(1);
    p.setHoverStiffness(100);
    p.setHoverDamping(50);
  });
  const level::Level level = b.compile();
  EXPECT_GT(supportsOf(support::plainProblem(level, {})).back().feet.hi.y, 11);
}

// A tick of a fast climb, 7.7 studs, leads far past the top of the truss.
TEST(ReachPhysics, HoldsWhoClimbsFast) {
  float most = 0;
  for (int i = 0; i < 9; ++i) {
    const float high = 19.1f + 0.2f * float(i);  // two ticks, and the torso is still below
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
      most = std::max(most, w.position.y - high);
      ASSERT_TRUE(bound.holds(w.position))
          << "truss of " << high << ", tick " << t << ": " << w.position.y << ", " << w.position.z;
    }
  }
  EXPECT_GT(most, 542) << "nobody flew off its top";
}

// May a block that slides, and turns, have somebody inside of it?
bool isInside(float slides, float turns, float bodyDepth) {
  LevelBuilder b;
  b.spawn({0, 0, 50});
  b.block({0, 2, 0}, {4, 4, 4}, [=](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::ONCE);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 2, 0});
    support::set(keys[1].initPosition(), {slides, 2, 0});
    keys[1].setTime(1);
    if (turns > 0) motion.initSpin().setSpeed(turns);
  });
  b.physics([=](schema::PhysicsParams::Builder p) { p.setBodyDepth(bodyDepth); });
  const level::Level level = b.compile();
  return supportsOf(support::plainProblem(level, {})).back().snaps;
}

TEST(ReachPhysics, WhatMovesByMoreThanHalfABodyATickMayHaveOneInside) {
  EXPECT_FALSE(isInside(48, 0, 1)) << "0.8 studs a tick";
  EXPECT_TRUE(isInside(48, 0, 0.2f)) << "thinner than that";
  EXPECT_FALSE(isInside(36, 0, 1));
  EXPECT_TRUE(isInside(36, 7, 1)) << "turns as fast as it slides";
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
