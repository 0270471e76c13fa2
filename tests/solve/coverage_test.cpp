// The coverage that a search without a solution reports.
#include "solve/search/coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"
#include "solve/methods.h"
#include "solve/query_solver.h"

namespace obby::solve {
namespace {

Coverage after(uint64_t rollouts, uint64_t singletons, uint64_t cells) {
  return {rollouts, 0, singletons, {{rollouts * 100, cells, 5}}};
}

TEST(NewCellChance, IsTheBoundOfGoodAndTuring) {
  EXPECT_NEAR(newCellChance(after(10'000, 100, 1)), (100 + 1.96 * std::sqrt(200.0)) / 10'000, 1e-6);
  EXPECT_NEAR(newCellChance(after(10'000, 0, 1)), 3.69 / 10'000, 1e-7);
  EXPECT_EQ(newCellChance(after(10, 10, 1)), 1.0f);
  EXPECT_EQ(newCellChance(Coverage{}), 1.0f);
}

TEST(NewCellChance, HoldsForKnownProbabilities) {
  // A thousand cells, with probabilities in proportion to 1 / (i + 1)^2. Each draw is a rollout.
  constexpr int kCells = 1000, kDraws = 2000;
  std::vector<double> chance;
  double all = 0;
  for (int i = 0; i < kCells; ++i) all += chance.emplace_back(1.0 / ((i + 1.0) * (i + 1.0)));
  int held = 0;
  for (uint64_t trial = 0; trial < 200; ++trial) {
    Random random(1, trial);
    std::vector<int> seen(kCells);
    for (int draw = 0; draw < kDraws; ++draw) {
      double rest = random.unit() * all;
      int i = 0;
      while (i + 1 < kCells && rest >= chance[size_t(i)]) rest -= chance[size_t(i++)];
      ++seen[size_t(i)];
    }
    double missing = 0;
    uint64_t once = 0;
    for (size_t i = 0; i < kCells; ++i) {
      if (seen[i] == 0) missing += chance[i] / all;
      if (seen[i] == 1) ++once;
    }
    if (missing <= newCellChance(after(kDraws, once, 100))) ++held;
  }
  EXPECT_GE(held, 190);  // out of 200 trials; a bound that holds in 97.5 % of them would give 195
}

TEST(Saturation, MeansThatDoublingTheTimeFindsAlmostNothing) {
  EXPECT_TRUE(saturated(after(100'000, 10, 1000)));    // at most 16 more cells are expected
  EXPECT_FALSE(saturated(after(100'000, 100, 1000)));  // 120 more
  EXPECT_FALSE(saturated(after(100, 0, 1000)));        // too early to tell
  EXPECT_FALSE(saturated(Coverage{}));
}

SearchOutcome coverageSearched(const level::Level& level, uint64_t steps) {
  PlainQuery q(level);
  q.query.goal = boxAt({0, 60, -28}, {4, 4, 4});
  Budget budget;
  budget.maxSteps = steps;
  budget.attempts = 0;
  ThreadPool pool(1);
  return findMethod("auto")->run(q.problem(), budget, {}, pool);
}

TEST(Coverage, CountsRolloutsAndCellsOfASearch) {
  const SearchOutcome o = coverageSearched(steppingStones().compile(), 300'000);
  const Coverage& t = o.coverage;
  EXPECT_EQ(t.rollouts, o.statistics.rollouts);
  EXPECT_GT(t.rollouts, 1000u);
  EXPECT_LT(t.idleRollouts, t.rollouts);
  EXPECT_LE(t.singletons, o.cells);
  ASSERT_GT(t.curve.size(), 3u);
  EXPECT_EQ(t.curve.back().steps, o.statistics.steps);
  EXPECT_EQ(t.curve.back().cells, o.cells);
  for (size_t i = 1; i < t.curve.size(); ++i) {
    EXPECT_GT(t.curve[i].steps, t.curve[i - 1].steps);
    EXPECT_GE(t.curve[i].cells, t.curve[i - 1].cells);
    EXPECT_LE(t.curve[i].closest, t.curve[i - 1].closest);
  }
}

// On a pedestal of a few cells, the search soon runs out of new cells. On a plain it does not.
TEST(Coverage, ASmallPlaceIsSaturatedALargeOneGrows) {
  LevelBuilder small, large;
  small.block({0, -0.5f, 0}, {4, 1, 4}).spawn({0, 0, 0});
  small.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-8); });
  large.block({0, -0.5f, 0}, {1500, 1, 1500}).spawn({0, 0, 0});
  const SearchOutcome few = coverageSearched(small.compile(), 10'000'000);
  EXPECT_TRUE(saturated(few.coverage)) << few.coverage.singletons << " of " << few.cells;
  EXPECT_FALSE(saturated(coverageSearched(large.compile(), 2'000'000).coverage));
}

}  // namespace
}  // namespace obby::solve
