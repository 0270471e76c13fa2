// Tests snapshots, hashes, batches and replays.
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

TEST(Batch, threads_and_order_do_not_matter) {
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

TEST(Replay, equals_the_worlds_of_playing) {
  const auto level = support::boxArena(20, 6).compile();
  sim::Plan plan{
      level.spawns()[0], 0, {{{0x1234, true, false}, 100}, {{0x9876, true, true}, 150}, {{}, 30}}};
  const auto worlds = sim::replay(level.view(), nullptr, plan).worlds;
  ASSERT_EQ(worlds.size(), 281u);
  Play play(level, level.spawns()[0].feet);
  for (const auto& run : plan.actions) play.run(run.action, int(run.ticks));
  EXPECT_EQ(stateHash(worlds.back()), stateHash(play.world));
}

// Returns a level with a crate ahead of the player, initially in the air.
level::Level crateLevel() {
  return floorLevel()
      .block({0, 3, -6}, {4, 4, 4}, [](schema::Part::Builder p) { p.setAnchored(false); })
      .compile();
}

TEST(Replay, shows_every_state_and_the_one_before) {
  const auto level = crateLevel();
  const sim::Plan plan{{}, 0, {{walk(kNorth), 90}, {stand(), 0}, {walk(kEast, true), 40}}};
  std::vector<sim::Action> actions(90, walk(kNorth));
  actions.resize(130, walk(kEast, true));
  Play play(level);
  play.bodies = sim::startBodies(level.view());
  uint32_t shown = 0;
  const auto visit = [&](const sim::Moment& now) {
    EXPECT_EQ(now.tick, shown++);
    if (now.tick > 0) play.run(actions[now.tick - 1]);
    const sim::World& before = play.history[now.tick == 0 ? 0 : now.tick - 1];
    EXPECT_EQ(stateHash(now.before), stateHash(before)) << now.tick;
    EXPECT_EQ(stateHash(now.world, now.bodies), stateHash(play.world, play.bodies)) << now.tick;
    return true;
  };
  const sim::ReplayEnd end = sim::replay(level.view(), nullptr, plan, visit);
  EXPECT_EQ(shown, 131u);
  EXPECT_EQ(end.ticks, 130u);
  EXPECT_EQ(stateHash(end.world, end.bodies), stateHash(play.world, play.bodies));
}

TEST(Replay, keeps_what_it_shows) {
  const auto level = crateLevel();
  const sim::Plan plan{{}, 0x1234, {{walk(kNorth), 60}, {stand(), 30}}};
  const sim::Replay all = sim::replay(level.view(), nullptr, plan);
  ASSERT_EQ(all.worlds.size(), 91u);
  ASSERT_EQ(all.bodies.size(), 91u);
  sim::replay(level.view(), nullptr, plan, [&](const sim::Moment& now) {
    EXPECT_EQ(stateHash(now.world, now.bodies),
              stateHash(all.worlds[now.tick], all.bodiesAtTick(now.tick)))
        << now.tick;
    return true;
  });
  EXPECT_EQ(all.worlds[0].yaw, 0x1234);
}

TEST(Replay, stops_where_the_visit_says_so) {
  const auto level = flatLevel();
  const sim::Plan plan{{}, 0, {{walk(kNorth), 50}, {walk(kEast), 50}}};
  const sim::Replay all = sim::replay(level.view(), nullptr, plan);
  for (const uint32_t last : {0u, 50u, 60u}) {
    uint32_t shown = 0;
    const auto visit = [&](const sim::Moment& now) {
      ++shown;
      return now.tick < last;
    };
    const sim::ReplayEnd end = sim::replay(level.view(), nullptr, plan, visit);
    EXPECT_EQ(end.ticks, last);
    EXPECT_EQ(shown, last + 1);
    EXPECT_EQ(stateHash(end.world), stateHash(all.worlds[last]));
  }
}

TEST(Replay, stops_where_the_playthrough_ends) {
  const auto level = support::LevelBuilder().block({0, -1, 0}, {4, 2, 4}).compile();
  const sim::Plan plan{{}, 0, {{walk(kNorth), 2000}, {walk(kEast), 2000}}};
  uint32_t shown = 0;
  const auto visit = [&](const sim::Moment&) { return ++shown != 0; };
  const sim::ReplayEnd end = sim::replay(level.view(), nullptr, plan, visit);
  EXPECT_EQ(end.world.outcome, Outcome::fell);
  EXPECT_LT(end.ticks, 2000u);
  EXPECT_EQ(shown, end.ticks + 1);
}

}  // namespace
}  // namespace obby::test
