// The answer reports if the simulator had to ignore parts.
#include <gtest/gtest.h>

#include "sim/candidates.h"
#include "sim/simulator.h"
#include "solve/report/reason.h"
#include "solve/search/methods/go_explore.h"
#include "support/level_builder.h"

namespace obby::solve {
namespace {

// Returns a level with `posts` thin posts around the spawn, over a floor.
level::Level crowded(int posts) {
  support::LevelBuilder b;
  b.block({0, -1, 0}, {40, 2, 40}).spawn({0, 3, 0});
  for (int i = 0; i < posts; ++i) {
    const float turn = 0.1f * float(i);
    b.block({1.5f + 0.01f * turn, 2, 0.02f * float(i) - 0.5f}, {0.1f, 4, 0.05f});
  }
  return b.compile();
}

Statistics search(const level::Level& level) {
  level::QueryView query;
  query.goal.region = {{{0, 500, 0}, {}}, {2, 2, 2}};
  const Problem problem{
      level.view(), query,          sim::makeWorld(level.view(), level.spawns()[0]),
      {},           level.bounds(), level.hasMotion()};
  ThreadPool pool(2);
  GoExplore explore(problem, 1, GoExploreSettings{}, pool);
  for (int i = 0; i < 3; ++i) explore.round();
  return explore.statistics();
}

TEST(Overrun, IsReportedAboveTheLimitOfParts) {
  EXPECT_EQ(search(crowded(sim::kMaxCandidates - 8)).overruns, 0);
  EXPECT_EQ(search(crowded(sim::kMaxCandidates + 8)).overruns, sim::kCandidateOverrun);
}

TEST(Overrun, IsNamedInTheReason) {
  const level::Level level = crowded(1);
  SearchOutcome outcome{};
  EXPECT_EQ(reasonFor(outcome, level, {}, {}).find("more than"), std::string::npos);
  outcome.statistics.overruns = sim::kOverruns;
  const std::string reason = reasonFor(outcome, level, {}, {});
  EXPECT_NE(reason.find(
                "more than 48 parts, or 16 moving parts, at once; the simulator ignored the rest."),
            std::string::npos)
      << reason;
  EXPECT_NE(reason.find("more than 8 touched parts were active at once; the rest did not react."),
            std::string::npos)
      << reason;
  EXPECT_NE(reason.find(
                "dynamic parts had more than 64 contacts at once; the simulator ignored the rest."),
            std::string::npos)
      << reason;
}

}  // namespace
}  // namespace obby::solve
