// The bound on what a player can reach, at the ends of what physics may be, and where a climb, a
// touch or a place far out adds to what somebody does.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/body_reach.h"
#include "solve/proof/reach_bound.h"
#include "solve/proof/rounding.h"

namespace obby::solve {
namespace {

// A floor that goes up fast is on a truss, its top higher than the climb has led as the truss is
// passed. The climb goes on onto it, as fast as both, and a tick later it is far below.
TEST(ReachExtremes, HoldsWhoClimbsOnOntoAFloorThatLifts) {
  float most = 0;
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
      most = std::max(most, w.position.y - high - over);
      ASSERT_TRUE(bound.holds(w.position))
          << "truss of " << high << ", tick " << t << ": " << w.position.y << ", " << w.position.z;
    }
  }
  EXPECT_GT(most, 155) << "nobody was thrown by both";
}

// Strong dampers and no springs. Whoever is at rest on the floor as it begins to push is as fast as
// the floor within a tick, and no faster.
TEST(ReachExtremes, HoldsWhomAFastFloorLiftsOffAtOnce) {
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
  // Legs feel the floor from 5 studs above at most, and let go a tick's way, 3.3 studs, above that.
  constexpr float kThrown = 200 * 200 / (2 * 196.2f);  // studs, at the speed of the floor
  EXPECT_GT(highest, kThrown) << "nobody was as fast";
  EXPECT_LT(highest, kThrown + 5 + 3.4f) << "somebody was faster";
}

// Somebody small who faces a part askew touches it with a corner, and cannot walk.
TEST(ReachExtremes, WhatACornerTouchesIsReached) {
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
  Question question(level);
  question.query.goal.touchCount = 1;
  question.query.touched = touched;
  question.query.touchedCount = 1;
  const Problem problem = question.problem();
  sim::World w = problem.start;
  sim::advance(w, nullptr, level.view(), &problem.query, {});
  EXPECT_EQ(w.outcome, sim::Outcome::goal) << "nobody touched it";
  EXPECT_EQ(ReachBound(problem, false).jumpsTo(problem.query.goal), 0u);
}

// Legs that brake a fall at once, where they feel the floor, and then do nothing.
level::Level onWeakLegs(float landedTime, uint16_t controlRate, float damping, float gravity) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.physics([=](schema::PhysicsParams::Builder p) {
    p.setLandedTime(landedTime);
    p.setControlRate(controlRate);
    p.setGravity(gravity);
    p.setHoverStiffness(1);
    p.setHoverDamping(damping);
    p.setHoverLimit(1'000'000);
    p.setCoyoteTime(controlRate > 60 ? 1.0f : 0.13f);
    p.setOffFloorGrace(controlRate > 60 ? 1.0f : 0.125f);
  });
  return b.compile();
}

// Of 480 ticks that a level asks for, a world counts 255.
TEST(ReachExtremes, WhoIsLandedForLongJumpsSooner) {
  const level::Level level = onWeakLegs(1, 480, 1900, 8);
  EXPECT_EQ(unboundedPart(level.view()), nullptr);
  const float rise = springRise(level.view().params);
  EXPECT_FLOAT_EQ(rise, springRise(onWeakLegs(255.0f / 480, 480, 1900, 8).view().params));
  sim::World w = sim::makeWorld(level.view(), {{0, 2.8f, 0}, 0, 0});
  w.velocity.y = -480;
  float feet = 0;
  for (uint32_t t = 0; t < 600 && w.jumps == 0; ++t) {
    feet = w.position.y;
    sim::advance(w, nullptr, level.view(), nullptr, {0, false, true});
  }
  EXPECT_EQ(w.jumps, 1u);
  EXPECT_GT(feet, 1.5f) << "nobody jumped up there";
  EXPECT_LE(feet, rise);
}

// Landed for as long as they fall, they do not jump, but are in the air for much longer than from
// where legs keep anybody.
TEST(ReachExtremes, WhomLegsHoldFarAboveAFloorFallsAnew) {
  const level::Level level = onWeakLegs(1, 60, 220, 50);
  EXPECT_EQ(unboundedPart(level.view()), nullptr);
  const Params& p = level.view().params;
  const float kept = floorReach(p);
  float longest = 0;
  for (int i = 0; i < 100; ++i) {
    sim::World w = sim::makeWorld(level.view(), {{0, 20 + 0.1f * float(i), 0}, 0, 0});
    w.velocity.y = -480;
    uint32_t ticks = 0;  // since the floor was felt
    bool felt = false;
    while (w.position.y > kept && ticks < 400) {
      if (felt) ++ticks;
      sim::advance(w, nullptr, level.view(), nullptr, {});
      felt = felt || (w.flags & sim::kFloorSensed) != 0;
    }
    longest = std::max(longest, float(ticks) * p.tickSeconds);
  }
  EXPECT_GT(longest, 0.5f) << "nobody was held";
  const float falls = sqrtf32(2 * (springRise(p) - kept) / p.gravity);
  EXPECT_LE(longest, falls + p.coyoteTime + 2 * p.tickSeconds);
}

// Who is Running for a second after the edge is not Landed where the legs feel the next floor.
TEST(ReachExtremes, WhoRunsInTheAirJumpsFarAboveAFloor) {
  float highest = 0, rise = 0;
  for (int i = 0; i < 50; ++i) {
    const float high = 92 + 0.1f * float(i);
    LevelBuilder b;
    b.block({0, high - 0.5f, 0}, {8, 1, 8}).spawn({0, high, 0});
    b.block({0, -0.5f, -14}, {40, 1, 40});
    b.physics([](schema::PhysicsParams::Builder p) { p.setOffFloorGrace(1); });
    const level::Level level = b.compile();
    rise = springRise(level.view().params);
    sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
    float feet = 0;
    for (uint32_t t = 0; t < 200 && w.jumps == 0; ++t) {
      feet = w.position.y;
      sim::advance(w, nullptr, level.view(), nullptr, {0, true, feet < high - 20});
    }
    if (w.jumps != 0) highest = std::max(highest, feet);
  }
  EXPECT_GT(highest, 2.5f) << "nobody jumped up there";
  EXPECT_LE(highest, rise);
}

// A floor, and a teleporter above it that leads so far aside.
float roundedIn(float bodyDepth, float leadsTo) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.block({0, 20, 0}, {4, 4, 4}, [=](schema::Part::Builder p) {
    support::set(p.initTeleport().initPosition(), {leadsTo, 0, 0});
  });
  b.physics([=](schema::PhysicsParams::Builder p) { p.setBodyDepth(bodyDepth); });
  const level::Level level = b.compile();
  return roundedSpeed(support::plainProblem(level, {}));
}

TEST(ReachExtremes, ThinBodiesAreRoundedMoreOften) {
  EXPECT_GT(roundedIn(0.1f, 0), 6 * roundedIn(1, 0)) << "substeps are cut into 32, not into 5";
}

TEST(ReachExtremes, PlacesThatTeleportersLeadToAreRounded) {
  EXPECT_LT(roundedIn(1, 0), 0.01f);
  EXPECT_GT(roundedIn(1, 50'000), 4);
}

}  // namespace
}  // namespace obby::solve
