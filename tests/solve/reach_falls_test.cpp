// The bound on what a player can reach, where falls onto slopes turn speed aside.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

// A platform, a tilted block below it, and, `belt`, a conveyor that nobody can reach: where it is,
// speeds are not held as low as elsewhere.
level::Level aboveATiltedBlock(float height, bool belt, float tilt = 0.5f) {
  LevelBuilder b;
  b.block({0, height - 0.5f, 0}, {8, 1, 8}).spawn({0, height, 0});
  b.block({0, 10, -14}, {4, 4, 4},
          [=](schema::Part::Builder p) { support::setRotation(p.initRotation(), 0, tilt); });
  if (belt) {
    b.block({0, -0.5f, 1900}, {8, 1, 8}, [](schema::Part::Builder p) {
      support::set(p.initConveyor().initVelocity(), {0, 0, -40});
    });
  }
  return b.compile();
}

float fastestIn(const level::Level& level) {
  const Problem problem = support::plainProblem(level, {});
  return ReachBound(problem, true).fastest();
}

TEST(ReachFalls, FarFallsOntoSlopesMakeFast) {
  EXPECT_GT(fastestIn(aboveATiltedBlock(60, true)), 30);
  EXPECT_LT(fastestIn(aboveATiltedBlock(12, true)), 25) << "no far fall";
  EXPECT_FLOAT_EQ(fastestIn(aboveATiltedBlock(60, true, 0)), 16) << "no slope";
  EXPECT_FLOAT_EQ(fastestIn(aboveATiltedBlock(60, false)), 20) << "no speed beyond a slide";
}

// The torso meets the edge of the block where the rays of the legs do not, 229 studs down: at 300
// studs/s, of which 126 are turned aside. They walk on from then on, that way or back.
TEST(ReachFalls, HoldsWhoGlancesOffAnEdge) {
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
  EXPECT_GT(fastest, 100) << "nobody was turned aside";
  EXPECT_GT(farthest, 50) << "nobody came far";
}

}  // namespace
}  // namespace obby::solve
