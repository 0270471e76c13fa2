// The bound on reach for falls onto slopes, which turn some of the speed sideways.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// The torso meets the edge of the block 229 studs down, where no leg ray hits. Of the 300 studs/s,
// 126 are deflected sideways. Then the player walks in that direction, or back.
TEST(ReachFalls, HoldsForAFallDeflectedByAnEdge) {
  LevelBuilder b;
  b.spawn({2.9f, 240, 0});
  b.block({0, 10, 0}, {4, 4, 4},
          [](schema::Part::Builder p) { support::setRotation(p.initRotation(), 0, 0.5f); });
  b.block({0, -0.5f, 2000}, {8, 1, 8}, [](schema::Part::Builder p) {
    support::set(p.initConveyor().initVelocity(), {0, 0, -100});
  });
  const level::Level level = b.compile();
  const Problem problem = support::plainProblem(level, {});
  const ReachBound bound(problem, true);
  float fastest = 0, farthest = 0;
  for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i) {
    sim::World w = problem.start;
    w.position.x += 0.01f * float(i % 20) - 0.1f;
    w.position.z += 0.03f * float(i / 20) - 0.3f;
    const Turns ahead = i % 2 == 0 ? Turns(0) : Turns(32768);
    for (uint32_t t = 0; t < 150 && w.outcome == sim::Outcome::running; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {ahead, t > 91, false});
      fastest = std::max(fastest, absf(w.velocity.z));
      farthest = std::max(farthest, absf(w.position.z));
      ASSERT_TRUE(bound.holds(w.position)) << i << ", tick " << t << ": " << w.position.x << ", "
                                           << w.position.y << ", " << w.position.z;
    }
  }
  EXPECT_GT(fastest, 100) << "no player was deflected";
  EXPECT_GT(farthest, 50) << "no player got far";
}

}  // namespace
}  // namespace obby::solve
