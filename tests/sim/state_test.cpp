// Snapshots, hashes, batches and replays.
#include <gtest/gtest.h>

#include "sim/batch.h"
#include "sim/play.h"

namespace obby::test {
namespace {

using sim::Outcome;

sim::Action scripted(size_t i, const sim::World& w) {
  Random random(7, i * 100000 + w.tick / 20);
  return {Turns(random.next()), random.below(8) != 0, random.below(3) == 0};
}

TEST(Snapshot, restored_world_continues_identically) {
  const auto level = support::boxArena(100, 3).compile();
  Play play(level, level.spawns()[0].feet);
  for (int t = 0; t < 300; ++t) play.run(scripted(0, play.world));
  const sim::World snapshot = play.world;
  for (int t = 0; t < 300; ++t) play.run(scripted(0, play.world));
  sim::World again = snapshot;
  for (int t = 0; t < 300; ++t)
    sim::advance(again, nullptr, level.view(), nullptr, scripted(0, again));
  EXPECT_EQ(stateHash(again), stateHash(play.world));
  EXPECT_NE(stateHash(again), stateHash(snapshot));
}

TEST(Batch, threads_and_order_do_not_show) {
  const auto level = support::boxArena(100, 4).compile();
  uint64_t expected = 0;
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    const auto batch =
        *sim::makeCpuBatch(sim::courseOf(level.view(), level.spawns()[0]), 300, pool);
    ASSERT_TRUE(batch->step(200, sim::Actions::walker(7)));
    if (expected == 0) expected = *batch->hash();
    EXPECT_EQ(*batch->hash(), expected) << threads;
  }
}

TEST(Batch, no_world_ever_holds_a_nan) {
  const auto level = support::boxArena(300, 5).compile();
  ThreadPool pool(2);
  const auto batch = *sim::makeCpuBatch(sim::courseOf(level.view(), level.spawns()[0]), 200, pool);
  ASSERT_TRUE(batch->step(1500, sim::Actions::walker(7)));
  const auto worlds = *batch->worlds();
  for (const sim::World& w : worlds) {
    EXPECT_EQ(dot(w.position, w.position), dot(w.position, w.position));
    EXPECT_EQ(dot(w.velocity, w.velocity), dot(w.velocity, w.velocity));
    EXPECT_EQ(w.flags & sim::kCandidateOverrun, 0);
  }
}

TEST(Replay, gives_the_same_worlds_as_playing) {
  const auto level = support::boxArena(20, 6).compile();
  sim::Plan plan{
      level.spawns()[0], 0, {{{0x1234, true, false}, 100}, {{0x9876, true, true}, 150}, {{}, 30}}};
  const auto worlds = sim::replay(level.view(), nullptr, plan).worlds;
  ASSERT_EQ(worlds.size(), 281u);
  Play play(level, level.spawns()[0].feet);
  for (const auto& run : plan.actions) play.run(run.action, int(run.ticks));
  EXPECT_EQ(stateHash(worlds.back()), stateHash(play.world));
}

}  // namespace
}  // namespace obby::test
