// Batches of one or many levels give the same worlds on lanes and by the kernel, in steps of any
// length.
#include "sim/batch.h"

#include <gtest/gtest.h>

#include <malloc.h>
#include <set>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "sim/host_device.h"
#include "sim/simulator.h"
#include "support/courses.h"

namespace obby::sim {
namespace {

constexpr uint32_t kRuled = 600;  // ticks; enough for every rule to end some worlds
constexpr uint32_t kWorlds = 90;

std::vector<uint64_t> hashesOf(const Batch& batch) {
  std::vector<uint64_t> hashes;
  const auto worlds = *batch.worlds();
  for (const World& w : worlds) hashes.push_back(stateHash(w));
  return hashes;
}

// Simulates world `index` alone, by the scalar tick. Returns the hash of the world and its dynamic
// bodies.
uint64_t alone(const Course& course, uint32_t index, uint32_t ticks, uint64_t seed) {
  const auto levelOf = [&](uint32_t episode) {
    return (index + size_t(episode) * kWorlds) % course.levels.size();
  };
  uint32_t episode = 0;
  World w = course.starts[levelOf(0)];
  std::vector<RigidBody> bodies = startBodies(course.levels[levelOf(0)]);
  for (uint32_t t = 0; t < ticks; ++t) {
    if (w.outcome != Outcome::running) {
      w = course.starts[levelOf(++episode)];
      bodies = startBodies(course.levels[levelOf(episode)]);
    }
    const size_t level = levelOf(episode);
    advance(w, bodies.data(), course.levels[level], &course.queries[level],
            walkerAction(seed, index, episode, w.tick));
  }
  return stateHash(w, bodies);
}

TEST(Batch, worlds_of_many_levels_equal_worlds_alone) {
  const support::Levels many = support::everyKind();
  ThreadPool pool(3);
  HostDevice device(pool);
  const auto lanes = *makeCpuBatch(many.course, kWorlds, pool);
  const auto kernel = *makeKernelBatch(many.course, kWorlds, device);
  ASSERT_TRUE(lanes->step(400, Actions::walker(5)));
  ASSERT_TRUE(kernel->step(400, Actions::walker(5)));
  const auto worlds = *lanes->worlds();
  const auto bodies = *lanes->bodies();
  const auto played = *lanes->episodes();
  const size_t stride = bodies.size() / kWorlds;
  for (uint32_t i = 0; i < kWorlds; ++i) {
    const uint32_t bodyCount = many.course.levels[played[i].level].bodyCount;
    const uint64_t state = stateHash(worlds[i], std::span(bodies).subspan(i * stride, bodyCount));
    EXPECT_EQ(state, alone(many.course, i, 400, 5)) << "world " << i;
  }
  EXPECT_EQ(hashesOf(*lanes), hashesOf(*kernel));
  uint32_t max = 0;
  const auto episodes = *lanes->episodes();
  for (const Episode& e : episodes) max = std::max(max, e.number);
  EXPECT_GE(max, 3u);
}

// Every rule ends some worlds. Lanes, kernels and single worlds agree on these worlds.
TEST(Batch, rules_are_the_same_in_lanes_and_on_kernels) {
  support::Levels many = support::everyKind();
  support::addRules(many);
  ThreadPool pool(2);
  HostDevice device(pool);
  many.course.restarts = false;
  const auto lanes = *makeCpuBatch(many.course, kRuled, pool);
  const auto kernel = *makeKernelBatch(many.course, kRuled, device);
  ASSERT_TRUE(lanes->step(400, Actions::walker(6)));
  ASSERT_TRUE(kernel->step(400, Actions::walker(6)));
  EXPECT_EQ(hashesOf(*lanes), hashesOf(*kernel));
  std::set<Outcome> ends;
  const auto worlds = *lanes->worlds();
  for (const World& w : worlds) ends.insert(w.outcome);
  for (const Outcome o : {Outcome::goal, Outcome::avoided, Outcome::timeout, Outcome::hurt,
                          Outcome::forbidden, Outcome::jumps}) {
    EXPECT_TRUE(ends.contains(o)) << "no world ended by " << int(o);
  }
}

TEST(Batch, the_length_of_steps_does_not_matter) {
  const support::Levels many = support::everyKind();
  ThreadPool pool(2);
  HostDevice device(pool);
  const auto whole = *makeCpuBatch(many.course, kWorlds, pool);
  ASSERT_TRUE(whole->step(200, Actions::walker(9)));
  for (const bool onKernel : {false, true}) {
    const auto cut = onKernel ? *makeKernelBatch(many.course, kWorlds, device)
                              : *makeCpuBatch(many.course, kWorlds, pool);
    for (const uint32_t ticks : {1u, 2u, 37u, 0u, 59u, 101u}) {
      ASSERT_TRUE(cut->step(ticks, Actions::walker(9)));
    }
    EXPECT_EQ(hashesOf(*cut), hashesOf(*whole));
  }
}

TEST(Batch, the_queue_says_which_level_comes_next) {
  support::Levels many = support::everyKind();
  many.course.queue = {2, 2, 0, 5, 1};
  ThreadPool pool(2);
  const auto batch = *makeCpuBatch(many.course, 7, pool);
  ASSERT_TRUE(batch->step(700, Actions::walker(1)));
  const auto episodes = *batch->episodes();
  for (uint32_t i = 0; i < 7; ++i) {
    EXPECT_GE(episodes[i].number, 1u);
    EXPECT_EQ(episodes[i].level, many.course.queue[(i + 7 * episodes[i].number) % 5]);
  }
}

TEST(Batch, ended_worlds_wait_unless_the_course_restarts) {
  support::Levels many = support::everyKind();
  many.course.restarts = false;
  ThreadPool pool(2);
  HostDevice device(pool);
  const auto lanes = *makeCpuBatch(many.course, kWorlds, pool);
  const auto kernel = *makeKernelBatch(many.course, kWorlds, device);
  for (Batch* batch : {lanes.get(), kernel.get()}) {
    ASSERT_TRUE(batch->step(600, Actions::walker(2)));
    const auto worlds = *batch->worlds();
    for (const World& w : worlds) EXPECT_NE(w.outcome, Outcome::running);
    const auto episodes = *batch->episodes();
    for (const Episode& e : episodes) EXPECT_EQ(e.number, 0u);
  }
  EXPECT_EQ(hashesOf(*lanes), hashesOf(*kernel));
}

// A walker, a table of actions, and plans result in the same actions.
TEST(Batch, walker_table_and_plans_are_equivalent) {
  const level::Level level = support::boxArena(20, 1).compile();
  const Course course = courseOf(level.view(), level.spawns()[0]);
  constexpr uint32_t kTicks = 100, kSome = 20;
  std::vector<Action> table;
  std::vector<ActionRun> runs;
  std::vector<uint32_t> firsts{0};
  for (uint32_t t = 0; t < kTicks; ++t) {
    for (uint32_t i = 0; i < kSome; ++i) table.push_back(walkerAction(3, i, 0, t));
  }
  for (uint32_t i = 0; i < kSome; ++i) {
    for (uint32_t t = 0; t < kTicks; t += kWalkerHold) {
      runs.push_back({walkerAction(3, i, 0, t), 5});
      runs.push_back({{}, 0});
      runs.push_back({walkerAction(3, i, 0, t), kWalkerHold - 5});
    }
    firsts.push_back(uint32_t(runs.size()));
  }
  ThreadPool pool(2);
  HostDevice device(pool);
  std::optional<uint64_t> expected;
  for (const Actions& a :
       {Actions::walker(3), Actions::tabulated(table), Actions::plans(runs, firsts)}) {
    const auto lanes = *makeCpuBatch(course, kSome, pool);
    const auto kernel = *makeKernelBatch(course, kSome, device);
    for (Batch* batch : {lanes.get(), kernel.get()}) {
      ASSERT_TRUE(batch->step(kTicks, a));
      if (!expected) expected = *batch->hash();
      EXPECT_EQ(*batch->hash(), *expected);
    }
  }
}

TEST(Batch, a_world_stands_still_after_its_plan) {
  const level::Level level = support::boxArena(20, 1).compile();
  const ActionRun run{{0, true, false}, 3};
  const uint32_t firsts[2] = {0, 1};
  ThreadPool pool(1);
  const auto batch = *makeCpuBatch(courseOf(level.view(), level.spawns()[0]), 1, pool);
  ASSERT_TRUE(batch->step(10, Actions::plans({&run, 1}, firsts)));
  World w = makeWorld(level.view(), level.spawns()[0]);
  for (int t = 0; t < 10; ++t)
    advance(w, nullptr, level.view(), nullptr, t < 3 ? run.action : Action{});
  EXPECT_EQ(stateHash(batch->worlds()->front()), stateHash(w));
}

TEST(Batch, wrong_actions_and_courses_are_errors) {
  const level::Level level = support::boxArena(5, 1).compile();
  const Course course = courseOf(level.view(), level.spawns()[0]);
  ThreadPool pool(1);
  const auto batch = *makeCpuBatch(course, 4, pool);
  const std::vector<Action> few(7);
  EXPECT_EQ(batch->step(2, Actions::tabulated(few)).error().message,
            "expected an action for each of 2 ticks in each of 4 worlds, found 7");
  const uint32_t firsts[5] = {0, 1, 1, 1, 2};
  const ActionRun run{};
  EXPECT_EQ(batch->step(2, Actions::plans({&run, 1}, firsts)).error().message,
            "expected 2 runs for these plans, found 1");
  EXPECT_EQ(makeCpuBatch({}, 4, pool).error().message, "a batch needs at least one level");
  Course bad = course;
  bad.queue = {0, 1};
  EXPECT_EQ(makeCpuBatch(bad, 4, pool).error().message,
            "the queue names level 1, but there are 1 levels");
}

// The device holds a full copy, so the test frees the level and overwrites its memory.
TEST(KernelBatch, needs_nothing_of_the_level_after_the_upload) {
  mallopt(M_PERTURB, 0x5a);
  ThreadPool pool(1);
  HostDevice device(pool);
  for (const auto& build : {golden::hulls, golden::spinners, golden::vanishing}) {
    auto level = std::make_unique<level::Level>(build().compile());
    const auto lanes = *makeCpuBatch(courseOf(level->view(), level->spawns()[0]), 16, pool);
    ASSERT_TRUE(lanes->step(300, Actions::walker(8)));
    const auto kernel = *makeKernelBatch(courseOf(level->view(), level->spawns()[0]), 16, device);
    level.reset();
    ASSERT_TRUE(kernel->step(300, Actions::walker(8)));
    EXPECT_EQ(*kernel->hash(), *lanes->hash());
  }
  mallopt(M_PERTURB, 0);
}

TEST(KernelBatch, a_restored_snapshot_goes_on_as_before) {
  const support::Levels many = support::everyKind();
  ThreadPool pool(2);
  HostDevice device(pool);
  Course course = many.course;
  course.restarts = false;
  const auto batch = *makeKernelBatch(course, kWorlds, device);
  ASSERT_TRUE(batch->step(20, Actions::walker(4)));
  const auto snapshot = *batch->worlds();
  const auto bodies = *batch->bodies();
  ASSERT_TRUE(batch->step(50, Actions::walker(4)));
  const uint64_t once = *batch->hash();
  ASSERT_TRUE(batch->restore(0, snapshot, bodies));
  ASSERT_TRUE(batch->step(50, Actions::walker(4)));
  EXPECT_EQ(*batch->hash(), once);
}

}  // namespace
}  // namespace obby::sim
