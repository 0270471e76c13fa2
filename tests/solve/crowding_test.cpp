// The bound on reach makes no claim for places where the simulator ignores parts.
#include <gtest/gtest.h>

#include "scenes.h"
#include "sim/candidates.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// Returns true if the bound is unknown for a floor with a row of small posts. `aside` moves the
// row, in studs; `more` sets up each post.
bool isUnknownAmong(int posts, float aside, const LevelBuilder::PartSetter& more = {}) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {40, 1, 40}).spawn({0, 0, 0});
  for (int i = 0; i < posts; ++i) {
    b.block({0.1f * float(i) - 3 + aside, 0.5f, 5}, {0.05f, 1, 0.05f}, more);
  }
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  return ReachBound(problem, true).holds({30000, 15000, 0});
}

TEST(Crowding, BeginsAboveATicksLimitOfParts) {
  EXPECT_FALSE(isUnknownAmong(0, 0));
  EXPECT_FALSE(isUnknownAmong(sim::kMaxCandidates - 1, 0)) << "with the floor as many as it holds";
  EXPECT_TRUE(isUnknownAmong(sim::kMaxCandidates, 0));
  EXPECT_FALSE(isUnknownAmong(sim::kMaxCandidates + 1, 500)) << "no player gets there";
}

TEST(Crowding, HasALowerLimitForMovingParts) {
  const auto turns = [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(1); };
  EXPECT_FALSE(isUnknownAmong(sim::kMaxMovingCandidates, 0, turns));
  EXPECT_TRUE(isUnknownAmong(sim::kMaxMovingCandidates + 1, 0, turns));
  EXPECT_FALSE(isUnknownAmong(sim::kMaxMovingCandidates + 1, 0)) << "standing still";
}

// One box covers each block of crowded places, whatever the number of places.
TEST(Crowding, MergesManyPlaces) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  for (int x = 0; x < 8; ++x) {
    for (int z = 0; z < 8; ++z) {
      const Vec3 at{60 * float(x) + 200, 0, 60 * float(z)};
      for (int i = 0; i <= sim::kMaxCandidates; ++i) b.block(at, {1, 1, 1});
    }
  }
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  EXPECT_FALSE(ReachBound(problem, true).holds({230, 0, 30})) << "no player gets there";
}

}  // namespace
}  // namespace obby::solve
