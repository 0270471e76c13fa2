// The bound on what a player can reach, where parts that somebody is inside of put them out through
// thin ones: low blocks as a jump begins, high blocks through the floor that they stand on.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/reach_bound.h"
#include "solve/proof/supports.h"

namespace obby::solve {
namespace {

// A floor that ends in nothing, a block of 4.1 studs across its end, and 24 studs of walls behind
// that, without a gap and much too tall to be stood on. Jumps go half a stud high: the head passes
// over the block, and the hips do not.
LevelBuilder blockAndWalls(float wallThickness, bool block = true) {
  LevelBuilder b;
  b.block({0, -0.5f, 9.25f}, {12, 1, 21.5f}).spawn({0, 0, 12});
  if (block) b.block({0, 2.05f, -0.75f}, {12, 4.1f, 1.5f});
  for (int i = 0; float(i) * wallThickness < 24; ++i) {
    b.block({0, 10, -1.5f - (float(i) + 0.5f) * wallThickness}, {12, 40, wallThickness});
  }
  b.physics([](schema::PhysicsParams::Builder p) { p.setJumpSpeed(15); });
  return b;
}

// Runs from `behind` the start along -Z and jumps at `jumpAt`; the bound must hold it all the time.
float reachPassFarthestHeld(const Problem& problem, const ReachBound& bound, float behind,
                            uint32_t jumpAt) {
  sim::World w = problem.start;
  w.position.z += behind;
  float farthest = w.position.z;
  for (uint32_t t = 0; t < 90 && w.outcome == sim::Outcome::running; ++t) {
    sim::advance(w, nullptr, problem.level, nullptr, {0, true, t == jumpAt});
    farthest = std::min(farthest, w.position.z);
    EXPECT_TRUE(bound.holds(w.position))
        << "jump at " << jumpAt << ", tick " << t << ": " << w.position.y << ", " << w.position.z;
    if (testing::Test::HasFailure()) break;
  }
  return farthest;
}

TEST(ReachPass, HoldsWhoJumpsIntoALowBlockBeforeThinWalls) {
  const level::Level level = blockAndWalls(0.9f).compile();
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, true);
  float farthest = 0;
  for (uint32_t jumpAt = 38; jumpAt < 52 && !testing::Test::HasFailure(); ++jumpAt) {
    for (int i = 0; i < 14; ++i) {
      const float behind = 0.02f * float(i);
      farthest = std::min(farthest, reachPassFarthestHeld(problem, bound, behind, jumpAt));
    }
  }
  EXPECT_LT(farthest, -22) << "nobody was put out through the walls";
}

uint32_t jumpsBeyond(const LevelBuilder& built, int32_t maxJumps = -1) {
  LevelBuilder b = built;
  const level::Level level = b.compile();
  level::QueryView query;
  query.maxJumps = maxJumps;
  const Problem problem = support::plainProblem(level, query);
  return ReachBound(problem, maxJumps != 0).jumpsTo(boxAt({0, 0, -28}, {8, 4, 2}));
}

TEST(ReachPass, OnlyAJumpIntoALowBlockLeadsThroughThinWalls) {
  EXPECT_NE(jumpsBeyond(blockAndWalls(0.9f)), ReachBound::kNever);
  EXPECT_EQ(jumpsBeyond(blockAndWalls(4)), ReachBound::kNever) << "nobody passes those";
  EXPECT_EQ(jumpsBeyond(blockAndWalls(0.9f, false)), ReachBound::kNever) << "no block";
  EXPECT_EQ(jumpsBeyond(blockAndWalls(0.9f), 0), ReachBound::kNever) << "no jump";
}

// Something slides at a block of 20 studs on a floor, so that who is between is pressed deep into
// it, and would be put down. Does a pillar below the floor put out anybody?
bool isPutOutBelow(float floorThickness) {
  LevelBuilder b;
  b.block({0, -0.5f * floorThickness, 0}, {60, floorThickness, 60}).spawn({25, 0, 25});
  b.block({0, 10, 0}, {12, 20, 12});
  b.block({0, 5.1f, 14}, {4, 10, 4}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 5.1f, 14});
    support::set(keys[1].initPosition(), {0, 5.1f, 9});
    keys[1].setTime(1);
    motion.setRepeat(schema::Repeat::ONCE);
  });
  b.block({0, -floorThickness - 7.45f, 0}, {4, 9.5f, 4});
  const level::Level level = b.compile();
  return supportsOf(support::plainProblem(level, {})).back().snaps;
}

TEST(ReachPass, AHighBlockPutsDownThroughAThinFloor) {
  EXPECT_TRUE(isPutOutBelow(2.8f));
  EXPECT_FALSE(isPutOutBelow(12)) << "that lifts whom it has above itself";
}

// Studs from the start to a place behind a long bar that turns, those aside that it may press
// somebody along. `wall`: that it turns toward.
float wayPastBar(bool wall) {
  LevelBuilder b;
  b.block({0, -0.5f, -20}, {60, 1, 80}).spawn({0, 0, 10});
  b.block({0, 3, -20}, {20, 6, 1},
          [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(0.5f); });
  if (wall) b.block({0, 3, -31}, {40, 6, 2});
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, true);
  const Box from{{0, 0, 10}, {0, 0, 10}}, to{{0, 0, -50}, {0, 0, -50}};
  return wayBetween(from, bound.ownRides(from), to);
}

// The nearer to parallel bar and wall are, the faster is who is pressed out between them.
TEST(ReachPass, WhatTurnsTowardAWallMayPressSomebodyOutAtAnySpeed) {
  EXPECT_FLOAT_EQ(wayPastBar(false), 60);
  EXPECT_LT(wayPastBar(true), 45);
}

}  // namespace
}  // namespace obby::solve
