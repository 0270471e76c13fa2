// Methods guided by a trained policy. Tests where a rollout's moves come from, and that results
// depend only on the inputs.
#include <gtest/gtest.h>

#include "policy/policy.h"
#include "policy/shipped_policy.h"
#include "scenes.h"
#include "sim/host_device.h"
#include "solve/methods.h"
#include "solve/search/methods/go_explore_method.h"
#include "solve/search/rollouts/explorer.h"
#include "solve/search/selectors/policy_selector.h"
#include "untimed.h"

namespace obby::solve {
namespace {

struct CountingDevice : sim::HostDevice {
  using HostDevice::HostDevice;
  Status launch(const sim::Kernel& kernel, const void* arguments, uint32_t count) override {
    ++launches;
    return HostDevice::launch(kernel, arguments, count);
  }
  int launches = 0;
};

FilterOptions guided(const char* method, int threads) {
  FilterOptions o;
  o.threads = threads;
  o.solver.method = findMethod(method);
  o.solver.policy = &policy::shippedPolicy().network;
  o.solver.budget.maxSteps = 400'000;
  o.solver.progressRecords = false;
  return o;
}

TEST(ShippedPolicy, WasTrainedSuccessfully) {
  const policy::PolicyFile& file = policy::shippedPolicy();
  EXPECT_GT(file.training.decisions, 0u);
  EXPECT_NE(file.training.command.find("obby-train"), std::string::npos);
}

TEST(PolicyMethods, SolveStonesByThemselves) {
  for (const char* method : {"rl", "ge-ps"}) {
    const LinesFile file(stonesText());
    FilterOptions o = guided(method, 2);
    o.solver.budget.maxSteps = 3'000'000;
    const Filtered f = runFilter(file.path(), std::move(o));
    ASSERT_TRUE(f.status) << f.status.error().text();
    EXPECT_EQ(f.counts.solved, 1u) << method << f.output;
  }
}

TEST(PolicyMethods, GiveTheSameBytesOnAnyNumberOfThreadsAndOnADevice) {
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  for (const char* method : {"auto", "rl", "ge-ps"}) {
    const LinesFile file(stonesText(R"(,"maxJumps":1)"));
    const auto answer = [&](int threads, sim::Device* on) {
      FilterOptions o = guided(method, threads);
      o.device = on;
      return withoutTiming(runFilter(file.path(), std::move(o)).output);
    };
    const std::string expected = answer(1, nullptr);
    EXPECT_EQ(answer(3, nullptr), expected) << method;
    EXPECT_EQ(answer(2, &device), expected) << method << " on a device";
  }
}

// Rollouts by a policy are kernels like the others, so the device runs all of them.
TEST(PolicyMethods, RunOnTheDevice) {
  const level::Level stones = steppingStones().compile();
  PlainQuery q(stones);
  ThreadPool pool(1);
  Problem problem = q.problem();
  problem.policy = &policy::shippedPolicy().network;
  EXPECT_FALSE(ExploreSetup(problem, 1, GoExploreSettings{}).rules.context.pilot.exists());
  EXPECT_TRUE(ExploreSetup(problem, 1, aloneSettings()).rules.context.pilot.exists());
  for (const char* method : {"auto", "rl"}) {
    CountingDevice device(pool);
    Budget budget;
    budget.maxSteps = 20'000;
    const SearchOutcome out = findMethod(method)->run(problem, budget, {}, {pool, &device});
    EXPECT_TRUE(out.device);
    EXPECT_GE(uint64_t(device.launches), out.statistics.rounds) << method;
  }
}

TEST(PolicyMethods, DifferFromSearchWithoutAPolicy) {
  const LinesFile file(stonesText(R"(,"maxJumps":0)"));
  FilterOptions without = guided("ge-ps", 1), with = guided("ge-ps", 1);
  without.solver.policy = nullptr;
  EXPECT_NE(withoutTiming(runFilter(file.path(), std::move(with)).output),
            withoutTiming(runFilter(file.path(), std::move(without)).output));
}

// A selector that takes the first cells in turn.
class InTurn : public Selector {
 public:
  void choose(const Archive& archive, ThreadPool&, Random&, std::span<Choice> choices) override {
    for (size_t i = 0; i < choices.size(); ++i) choices[i].cell = uint32_t(i) % archive.cellCount();
  }
};

TEST(PolicyFirst, RunsOncePerStateUntilAnImprovement) {
  Archive archive;
  sim::World world{};
  world.tick = 10;
  archive.offer(7, world, {0, kNone, 0}, 1);
  archive.offer(8, world, {1, 0, 5}, 1);
  PolicyFirstSelector selector(std::make_unique<InTurn>());
  ThreadPool pool(1);
  Random random(1, 1);
  const auto policies = [&] {
    std::vector<Choice> choices(4);
    selector.choose(archive, pool, random, choices);
    std::vector<bool> by;
    for (const Choice& c : choices) by.push_back(c.by == kByPolicy);
    return by;
  };
  EXPECT_EQ(policies(), (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(policies(), (std::vector<bool>{false, false, false, false}));
  world.tick = 5;
  ASSERT_TRUE(archive.offer(8, world, {2, 0, 3}, 1));
  EXPECT_EQ(policies(), (std::vector<bool>{false, true, false, false}));
}

TEST(PolicyAlone, BeginsWithTheLikeliestMovesAndLengthensRolloutsLater) {
  const Archive archive;
  PolicyAloneSelector selector;
  ThreadPool pool(1);
  Random random(1, 1);
  const uint32_t patience = PolicyAloneSelector::kPatience;
  for (uint32_t round = 0; round < 2 * patience; ++round) {
    std::vector<Choice> choices(3, {7, 400});
    selector.choose(archive, pool, random, choices);
    for (size_t i = 0; i < choices.size(); ++i) {
      EXPECT_EQ(choices[i].cell, 0u);
      EXPECT_EQ(choices[i].by, round + i == 0 ? kByPolicy | kLikeliest : kByPolicy) << round;
      EXPECT_EQ(choices[i].ticks, round < patience ? 200u : 400u);
    }
  }
}

TEST(PolicyFirst, StartsAtItsRound) {
  Archive archive;
  archive.offer(7, sim::World{}, {0, kNone, 0}, 1);
  PolicyFirstSelector selector(std::make_unique<InTurn>(), 3);
  ThreadPool pool(1);
  Random random(1, 1);
  for (uint32_t round = 1; round <= 4; ++round) {
    archive.nextEpoch();
    std::vector<Choice> choices(1);
    selector.choose(archive, pool, random, choices);
    EXPECT_EQ(choices[0].by, round == 3 ? kByPolicy : 0) << round;
  }
}

// At each decision the policy chooses an action from the current state, up to the last tick.
TEST(PolicyMethods, ThePolicyPlaysEveryTickOfARollout) {
  const level::Level stones = steppingStones().compile();
  PlainQuery q(stones);
  Problem problem = q.problem();
  problem.policy = &policy::shippedPolicy().network;
  const ExploreSetup setup(problem, 1, aloneSettings());
  const ExploreContext& c = setup.rules.context;
  const policy::Scene scene{c.level, c.query, c.pilot.surroundings};
  for (const bool likeliest : {true, false}) {
    const uint64_t stream = 7 | kByPolicy | (likeliest ? kLikeliest : 0);
    Explorer explorer(1, stream);
    Random random(1, stream);
    sim::World world = problem.start;
    sim::Action expected;
    for (uint32_t t = 0; t < 48; ++t) {
      if (t % policy::kDecisionTicks == 0) {
        expected =
            policy::decide(scene, c.pilot.network, world, nullptr, likeliest ? nullptr : &random);
      }
      const sim::Action action = explorer.next(c, world, nullptr);
      ASSERT_EQ(action.heading, expected.heading) << t;
      ASSERT_EQ(action.walk, expected.walk) << t;
      ASSERT_EQ(action.jump, expected.jump) << t;
      sim::advance(world, nullptr, c.level, &c.query, action);
    }
  }
}

// The documentation promises 8,192 rollouts per round of 120 ticks each. Every state counts, cells
// are a stud wide, and there are no aims and no hedge.
TEST(PlainGoExplore, MatchesTheDocumentation) {
  const GoExploreSettings s = plainSettings();
  EXPECT_EQ(s.rollouts, 8192u);
  EXPECT_EQ(s.maxRollouts, 8192u);
  EXPECT_FALSE(s.groundedOnly);
  EXPECT_EQ(s.lookEvery, 1u);
  EXPECT_EQ(s.cellWidth, 1);
  EXPECT_EQ(s.explore.aimShare, 0);
  const level::Level stones = steppingStones().compile();
  PlainQuery q(stones);
  const Problem problem = q.problem();
  const ExploreSetup setup(problem, 1, s);
  EXPECT_EQ(setup.rules.ticks, 120u);
  Archive archive;
  archive.offer(7, sim::World{}, {0, kNone, 0}, 1);
  archive.offer(8, sim::World{}, {1, 0, 5}, 100);
  ThreadPool pool(1);
  Random random(1, 1);
  std::vector<Choice> choices(20'000);
  plainSelector(problem, setup.rules.context)->choose(archive, pool, random, choices);
  int low = 0;
  for (const Choice& choice : choices) low += choice.cell == 0 ? 1 : 0;
  EXPECT_LT(low, 500) << "one in 101; a hedge would make it one in eleven";
}

}  // namespace
}  // namespace obby::solve
