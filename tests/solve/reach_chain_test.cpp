// The bound on what a player can reach, where a part that the body is inside of puts it out into
// the next, and that on.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes.h"
#include "solve/proof/reach_bound.h"
#include "solve/proof/supports.h"

namespace obby::solve {
namespace {

// Plays on without any key and gives how far along X somebody came; the bound must hold them all
// the time.
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

// Twenty walls without a gap from X = 2.5 to 32.5, much too tall to be lifted out of. Who is in one
// by more than half is put out on its far side, and in the next by more than half.
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

// The block is left sideways: its top is higher above the start than its side is far.
TEST(ReachChain, HoldsWhoBeginsInABlockBesideWalls) {
  LevelBuilder b;
  b.block({-3.75f, -7, 0}, {12.5f, 26, 40}).spawn({0, 0, 0});
  addWalls(b);
  EXPECT_GT(farthestHeld(b.compile(), 40), 32) << "nobody was put out";
}

TEST(ReachChain, HoldsWhomASlidingBlockPressesIntoWalls) {
  LevelBuilder b;
  b.block({-8.8f, -0.5f, 0}, {22.4f, 1, 40}).spawn({0, 0, 0});
  b.block({-7, 5.1f, 0}, {4, 10, 10}, [](schema::Part::Builder p) {
    slideTo(p, {-7, 5.1f, 0}, {1.5f, 5.1f, 0}, 0.85f);
  });
  addWalls(b);
  EXPECT_GT(farthestHeld(b.compile(), 90), 32) << "nobody was pressed through";
}

// From where a pillar lifts, which nothing that slides comes near. `between`: with a block that
// leads from what slides to the pillar.
float entryOfPillar(bool between) {
  LevelBuilder b;
  b.spawn({0, 0, 30});
  b.block({0, 5, 10}, {1, 10, 4}, [](schema::Part::Builder p) {
    slideTo(p, {0, 5, 10}, {0, 5, 4}, 1);
  });
  if (between) b.block({0, 5, -1}, {6, 10, 4});
  b.block({5, 6, -1}, {4, 12, 4});
  const level::Level level = b.compile();
  return supportsOf(support::plainProblem(level, {})).back().entry;
}

TEST(ReachChain, WhoIsPressedIntoOnePartMayBePutIntoTheNext) {
  EXPECT_LT(entryOfPillar(true), 5);
  EXPECT_GT(entryOfPillar(false), 8) << "the legs are lifted from some 3 studs below its top";
}

// Each of them puts out into all the others: too many pairs to be looked at, or to be kept.
TEST(ReachChain, OfThousandsOfBlocksInOnePlaceAnyPartMayPutOutAnybody) {
  LevelBuilder b;
  b.spawn({0, 0, 0});
  for (int i = 0; i < 20'000; ++i) b.block({0, 2, 0}, {4, 4, 4});
  b.block({5, 20, 0}, {4, 40, 4});
  const level::Level level = b.compile();
  const Support pillar = supportsOf(support::plainProblem(level, {})).back();
  EXPECT_TRUE(pillar.snaps);
  EXPECT_LT(pillar.entry, 0) << "looked at one by one";
}

// A tower of 20 studs and a post beside it at the far side of a wide floor, something that slides
// by the tower, and a lift at `lift` that rises a stud.
level::Level liftAndTower(Vec3 lift) {
  LevelBuilder b;
  b.spawn({0, 0, 0}).block({0, -0.5f, 0}, {2000, 1, 2000});
  b.block(lift, {4, 2, 4}, [=](schema::Part::Builder p) {
    slideTo(p, lift, lift + Vec3{0, 1, 0}, 1);
  });
  b.block({480, 2.1f, 14}, {4, 4, 4}, [](schema::Part::Builder p) {
    slideTo(p, {480, 2.1f, 14}, {520, 2.1f, 14}, 4);
  });
  b.block({490, 20, 0}, {4, 40, 4});
  b.block({500, 10, 0}, {16, 20, 16});
  return b.compile();
}

uint32_t jumpsOntoTower(const level::Level& level) {
  const Problem problem = support::plainProblem(level, {});
  return ReachBound(problem, true).jumpsTo(boxAt({500, 24, 0}, {4, 2, 4}));
}

float entryOfTower(const level::Level& level) {
  return supportsOf(support::plainProblem(level, {})).back().entry;
}

// The lift may press somebody into the floor, but not there.
TEST(ReachChain, AFloorHoldsABodyOnlyWhereSomethingMayPressOneIntoIt) {
  const level::Level level = liftAndTower({-900, 1.1f, -900});
  EXPECT_EQ(jumpsOntoTower(level), ReachBound::kNever);
  EXPECT_GT(entryOfTower(level), 16) << "the legs are lifted from some 3 studs below its top";
}

// It presses into the post, which puts out into the tower.
TEST(ReachChain, ALiftBesideAPostMayPressSomebodyThroughIt) {
  const level::Level level = liftAndTower({486, 1.1f, 0});
  EXPECT_NE(jumpsOntoTower(level), ReachBound::kNever);
  EXPECT_LT(entryOfTower(level), 10);
}

// Each leads on along the floor, of which a little more is known after each.
TEST(ReachChain, ThousandsOfBlocksOnAFloorAreLookedAtInShort) {
  LevelBuilder b;
  b.spawn({0, 900, 0});
  b.block({0, -0.5f, 0}, {600, 1, 600},
          [](schema::Part::Builder p) { p.initVanish().setDelay(1); });
  for (int i = 0; i < 8000; ++i)
    b.block({6 * float(i % 90) - 270, 2, 6 * float(i / 90) - 270}, {4, 4, 4});
  b.block({0, 60, 0}, {4, 4, 4});
  const level::Level level = b.compile();
  const std::vector<Support> supports = supportsOf(support::plainProblem(level, {}));
  EXPECT_TRUE(supports[2].snaps) << "a block on the floor";
  EXPECT_FALSE(supports.back().snaps) << "far above, but there was too much to look at";
}

}  // namespace
}  // namespace obby::solve
