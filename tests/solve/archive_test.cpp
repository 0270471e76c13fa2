#include "solve/search/archive/archive.h"

#include <gtest/gtest.h>

#include "base/thread_pool.h"

namespace obby::solve {
namespace {

sim::World arrival(uint32_t tick, uint16_t jumps = 0) {
  sim::World w{};
  w.tick = tick;
  w.jumps = jumps;
  return w;
}

TEST(Archive, FindsOfferedCellsAndNothingElse) {
  Archive archive;
  EXPECT_EQ(archive.find(7), kNone);
  EXPECT_TRUE(archive.offer(7, arrival(10), {1, 0, 10}, 1));
  EXPECT_EQ(archive.find(7), 0u);
  EXPECT_EQ(archive.find(8), kNone);
  EXPECT_EQ(archive.world(0).tick, 10u);
}

TEST(Archive, AShorterTrajectoryReplacesTheCellALongerDoesNot) {
  Archive archive;
  archive.offer(7, arrival(10, 2), {1, 0, 10}, 1);
  EXPECT_FALSE(archive.offer(7, arrival(11, 0), {2, 0, 11}, 1));
  EXPECT_FALSE(archive.offer(7, arrival(10, 2), {3, 0, 10}, 1));
  EXPECT_TRUE(archive.offer(7, arrival(10, 1), {4, 0, 10}, 1));
  EXPECT_TRUE(archive.offer(7, arrival(9, 5), {5, 0, 9}, 1));
  EXPECT_EQ(archive.cellCount(), 1u);
  EXPECT_EQ(archive.nodes()[archive.node(0)].rollout, 5u);
}

TEST(Archive, NodesOfReplacedStatesStayForTheirChildren) {
  Archive archive;
  archive.offer(7, arrival(10), {1, kNone, 10}, 1);
  const uint32_t parent = archive.node(0);
  archive.offer(8, arrival(20), {2, parent, 10}, 1);
  archive.offer(7, arrival(5), {3, kNone, 5}, 1);
  EXPECT_EQ(archive.nodes()[archive.node(1)].parent, parent);
  EXPECT_EQ(archive.nodes()[parent].rollout, 1u);
}

TEST(Archive, GrowsAndKeepsEveryCell) {
  Archive archive;
  for (uint64_t i = 0; i < 20000; ++i) {
    ASSERT_TRUE(archive.offer(i * 4096 + 1, arrival(uint32_t(i)), {i, 0, 1}, 1));
  }
  for (uint64_t i = 0; i < 20000; ++i) {
    const uint32_t cell = archive.find(i * 4096 + 1);
    ASSERT_EQ(cell, i);
    ASSERT_EQ(archive.world(cell).tick, i);
  }
}

TEST(Archive, AFullArchiveTakesNoNewCellsButBetterArrivals) {
  Archive archive(2);
  EXPECT_TRUE(archive.offer(1, arrival(10), {}, 1));
  EXPECT_TRUE(archive.offer(2, arrival(10), {}, 1));
  EXPECT_FALSE(archive.offer(3, arrival(10), {}, 1));
  EXPECT_TRUE(archive.offer(2, arrival(9), {}, 1));
  EXPECT_EQ(archive.cellCount(), 2u);
}

// Bodies in the same places as the first world's share its memory. Every state keeps its own
// bodies, whatever other states are offered.
TEST(Archive, KeepsTheBodiesOfEachState) {
  constexpr uint32_t kBodies = 3;
  Archive archive(kMaxCells, kBodies);
  const auto bodiesAt = [](float y) {
    std::vector<sim::RigidBody> bodies(kBodies);
    for (sim::RigidBody& b : bodies) b.position.y = y;
    return bodies;
  };
  const auto offer = [&](uint64_t key, uint32_t tick, float y) {
    archive.offer(key, arrival(tick), {tick, 0, tick}, 1, bodiesAt(y).data());
  };
  const auto heightIn = [&](uint32_t cell) { return archive.bodies(cell)[kBodies - 1].position.y; };
  offer(1, 9, 5), offer(2, 9, 5), offer(3, 9, 6), offer(4, 9, 7);
  EXPECT_EQ(heightIn(0), 5);
  EXPECT_EQ(archive.bodies(1).data(), archive.bodies(0).data());
  EXPECT_EQ(heightIn(2), 6);
  EXPECT_EQ(heightIn(3), 7);
  offer(1, 8, 8), offer(2, 8, 6), offer(3, 8, 5), offer(4, 8, 9);
  EXPECT_EQ(heightIn(0), 8);
  EXPECT_EQ(heightIn(1), 6);
  EXPECT_EQ(heightIn(2), 5);
  EXPECT_EQ(heightIn(3), 9);
}

TEST(Archive, CountsVisitsFromManyThreads) {
  Archive archive;
  archive.offer(1, arrival(0), {}, 1);
  archive.offer(2, arrival(0), {}, 1);
  ThreadPool pool(4);
  pool.run(64, [&](int task) {
    for (int i = 0; i < 1000; ++i) archive.countSeen(uint32_t(task % 2));
  });
  EXPECT_EQ(archive.seen()[0], 32000u);
  EXPECT_EQ(archive.seen()[1], 32000u);
}

TEST(Archive, SingletonsAreCellsSeenByTheirFinderOnly) {
  Archive archive;
  archive.offer(7, arrival(10), {1, 0, 10}, 1);
  archive.offer(7, arrival(12), {1, 0, 12}, 1);  // the same rollout finds the cell again
  archive.offer(8, arrival(10), {1, 0, 10}, 1);
  archive.offer(9, arrival(10), {1, 0, 10}, 1);
  EXPECT_EQ(archive.singletons(), 3u);
  archive.offer(8, arrival(11), {2, 0, 11},
                1);  // another rollout has seen the cell, although its arrival is no better
  EXPECT_EQ(archive.singletons(), 2u);
  archive.noteSighted(2);
  archive.noteSighted(2);
  EXPECT_EQ(archive.singletons(), 1u);
}

}  // namespace
}  // namespace obby::solve
