// Each method in the table solves easy queries, keeps constraints and depends only on its inputs.
#include "solve/methods.h"
#include "solve/search/methods/ablations.h"

#include <gtest/gtest.h>

#include "method_suite.h"
#include "support/plain_problem.h"

namespace obby::solve {
namespace {

// The second waypoint is in the corner of the first stone, away from the goal.
TEST_P(MethodTest, PassesWaypointsAwayFromTheGoal) {
  const char* more = R"(,"waypoints":[{"region":{"position":[3,2,-18],"size":[2,4,2]}},)"
                     R"({"region":{"position":[-3,2,-1],"size":[2,4,2]}}])";
  EXPECT_EQ(ask(more, options(6'000'000)).counts.solved, 1u);
}

TEST_P(MethodTest, VisitsInAnyOrderWithinTheJumps) {
  const char* more =
      R"(,"visits":[{"position":[3,2,-18],"size":[2,4,2]},{"position":[-3,2,-2],"size":[2,4,2]}],)"
      R"("maxJumps":3)";
  EXPECT_EQ(ask(more, options(6'000'000)).counts.solved, 1u);
}

INSTANTIATE_TEST_SUITE_P(Rows, MethodTest, testing::ValuesIn(methods()), nameOf);

// Each ablation changes the search but still solves easy queries.
TEST(Ablations, SolveAndDifferFromAutoAndFromEachOther) {
  const level::Level stones = steppingStones().compile();
  PlainQuery easy(stones);
  const level::Level arena = support::boxArena(30, 1).compile();
  Problem endless = support::endlessProblem(arena);
  level::WaypointView
      waypoints[5];  // the hedge has an effect only if some cells are past many waypoints
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
