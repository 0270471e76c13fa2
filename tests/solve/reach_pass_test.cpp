// The bound on reach where depenetration moves the player through thin parts: out of low blocks
// when a jump begins, and out of high blocks through the floor below.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// Returns a floor with a block of 4.1 studs across its end. Behind it are 24 studs of adjacent
// walls, much too tall to stand on. Jumps rise half a stud, so the head passes over the block, but
// the hips do not.
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

// Runs along -Z from `behind` the start, and jumps at `jumpAt`. The bound must contain the player
// throughout.
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

TEST(ReachPass, HoldsForAJumpIntoALowBlockBeforeThinWalls) {
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
  EXPECT_GT(farthest, -2) << "nothing is pressed between parts";
}

}  // namespace
}  // namespace obby::solve
