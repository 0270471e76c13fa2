// The bound on reach in chains of depenetration: a part pushes the body into the next part, and so
// on.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// Plays without keys, and returns the maximum X. The bound must contain the player throughout.
float farthestHeld(const level::Level& level, uint32_t ticks) {
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, false);
  sim::World w = problem.start;
  float farthest = w.position.x;
  for (uint32_t t = 0; t < ticks && w.outcome == sim::Outcome::running; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {0, false, false});
    farthest = std::max(farthest, w.position.x);
    EXPECT_TRUE(bound.holds(w.position))
        << "tick " << t << ": " << w.position.x << ", " << w.position.y << ", " << w.position.z;
    if (testing::Test::HasFailure()) break;
  }
  return farthest;
}

// Adds twenty adjacent walls from X = 2.5 to 32.5, much too tall for an exit at the top. A body
// that is more than halfway into a wall is pushed out on the far side, more than halfway into the
// next wall.
void addWalls(LevelBuilder& b) {
  for (int i = 0; i < 20; ++i) b.block({3.25f + 1.5f * float(i), 0, 0}, {1.5f, 40, 40});
}

void slideTo(schema::Part::Builder p, Vec3 from, Vec3 to, float seconds) {
  auto motion = p.initMotion();
  motion.setRepeat(schema::Repeat::ONCE);
  auto keys = motion.initKeys(2);
  support::set(keys[0].initPosition(), from);
  support::set(keys[1].initPosition(), to);
  keys[1].setTime(seconds);
}

// The body leaves the block sideways, since the top is farther than the side.
TEST(ReachChain, HoldsForAStartInABlockNextToWalls) {
  LevelBuilder b;
  b.block({-3.75f, -7, 0}, {12.5f, 26, 40}).spawn({0, 0, 0});
  addWalls(b);
  EXPECT_GT(farthestHeld(b.compile(), 40), 32) << "no player was pushed out";
}

TEST(ReachChain, HoldsForABlockThatPressesIntoWalls) {
  LevelBuilder b;
  b.block({-8.8f, -0.5f, 0}, {22.4f, 1, 40}).spawn({0, 0, 0});
  b.block({-7, 5.1f, 0}, {4, 10, 10}, [](schema::Part::Builder p) {
    slideTo(p, {-7, 5.1f, 0}, {1.5f, 5.1f, 0}, 0.85f);
  });
  addWalls(b);
  EXPECT_GT(farthestHeld(b.compile(), 90), 32) << "no player was pressed through";
}

}  // namespace
}  // namespace obby::solve
