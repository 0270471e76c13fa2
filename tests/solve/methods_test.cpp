// Every row of the table of methods: it solves easy queries and keeps constraints, and only its
// inputs decide its results.
#include "solve/methods.h"
#include "solve/search/methods/ablations.h"

#include <gtest/gtest.h>

#include "policy/shipped_policy.h"
#include "scenes.h"
#include "sim/host_device.h"
#include "support/plain_problem.h"
#include "untimed.h"

namespace obby::solve {
namespace {

class MethodTest : public testing::TestWithParam<Method> {
 protected:
  static FilterOptions options(uint64_t maxSteps, int threads = 2) {
    FilterOptions o;
    o.threads = threads;
    o.solver.method = &GetParam();
    o.solver.budget.maxSteps = maxSteps;
    o.solver.budget.attempts = 4;
    o.solver.progressRecords = false;
    return o;
  }
  static Filtered ask(const std::string& more, FilterOptions o) {
    const LinesFile file(stonesText(more));
    Filtered f = runFilter(file.path(), std::move(o));
    EXPECT_TRUE(f.status) << f.status.error().text();
    return f;
  }
};

// Methods that learn while they search take minutes for these tests.
// tests/solve/learned_search_test.cpp gives them smaller ones.
bool learnsMeanwhile(const Method& m) {
  return m.name == std::string("pbge") || m.name == std::string("cflge");
}

TEST_P(MethodTest, SolvesTheSteppingStones) {
  EXPECT_EQ(ask("", options(3'000'000)).counts.solved, 1u);
}

// The second waypoint is in the corner of the first stone, away from the goal.
TEST_P(MethodTest, PassesWaypointsAwayFromTheGoal) {
  if (learnsMeanwhile(GetParam())) GTEST_SKIP() << "takes minutes";
  const char* more = R"(,"waypoints":[{"region":{"position":[3,2,-18],"size":[2,4,2]}},)"
                     R"({"region":{"position":[-3,2,-1],"size":[2,4,2]}}])";
  EXPECT_EQ(ask(more, options(6'000'000)).counts.solved, 1u);
}

TEST_P(MethodTest, VisitsInAnyOrderWithinTheJumps) {
  if (learnsMeanwhile(GetParam())) GTEST_SKIP() << "takes minutes";
  const char* more =
      R"(,"visits":[{"position":[3,2,-18],"size":[2,4,2]},{"position":[-3,2,-2],"size":[2,4,2]}],)"
      R"("maxJumps":3)";
  EXPECT_EQ(ask(more, options(6'000'000)).counts.solved, 1u);
}

TEST_P(MethodTest, SpendsItsStepsIfThereIsNoSolution) {
  const char* wall = R"(,"avoid":[{"position":[0,0,-10],"size":[200,200,1]}])";
  const Filtered f = ask(wall, options(50'000));
  EXPECT_EQ(f.counts.unknown, 1u) << f.output;
}

TEST_P(MethodTest, SameBytesForAnyNumberOfThreadsAndAKernel) {
  const char* more =
      R"(,"waypoints":[{"region":{"position":[3,2,-16]},"maxJumps":1}],"maxJumps":1)";
  const std::string expected = withoutTiming(ask(more, options(60'000, 1)).output);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(withoutTiming(ask(more, options(60'000, threads)).output), expected) << threads;
  }
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  FilterOptions o = options(60'000);
  o.device = &device;
  EXPECT_EQ(withoutTiming(ask(more, o).output), expected) << "kernel";
}

INSTANTIATE_TEST_SUITE_P(Rows, MethodTest, testing::ValuesIn(methods()), [](const auto& row) {
  std::string name = row.param.name;
  std::erase(name, '-');  // not allowed in test names
  return name;
});

// Each ablation changes the search, and still solves.
TEST(Ablations, SolveAndDifferFromAutoAndFromEachOther) {
  const level::Level stones = steppingStones().compile();
  Question easy(stones);
  const level::Level arena = support::boxArena(30, 1).compile();
  Problem endless = support::endlessProblem(arena);
  level::WaypointView waypoints[5];  // a hedge matters if some cells have passed many
  for (level::WaypointView& w : waypoints) w.target = boxAt({8, 2, 0}, {4, 4, 4});
  endless.query.waypoints = waypoints;
  endless.query.waypointCount = 5;
  endless.policy = &policy::shippedPolicy().network;
  ThreadPool pool(1);
  std::set<std::pair<uint64_t, uint64_t>> work;
  const auto run = [&](const Method& m) {
    Budget budget;
    budget.maxSteps = 3'000'000;
    EXPECT_EQ(m.run(easy.problem(), budget, {}, {pool}).solutions.size(), 1u) << m.name;
    budget.maxSteps = 100'000;
    const SearchOutcome found = m.run(endless, budget, {}, {pool});
    EXPECT_TRUE(work.insert({found.statistics.steps, found.cells}).second) << m.name;
  };
  run(*findMethod("auto"));
  for (const Method& m : ablations()) run(m);
}

TEST(Methods, NamesAreDistinctAndFound) {
  for (const Method& m : methods()) EXPECT_EQ(findMethod(m.name), &m) << m.name;
  EXPECT_EQ(findMethod("none"), nullptr);
}

}  // namespace
}  // namespace obby::solve
