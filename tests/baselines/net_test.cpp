// Parts of learning within a search: sub-goals, the latent space and training examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "baselines/cell_choice.h"
#include "baselines/goal_policy.h"
#include "baselines/inverse_dynamics.h"
#include "baselines/quantile_policy.h"
#include "baselines/soft_window.h"
#include "solve/scenes.h"

namespace obby::baselines {
namespace {

template <class S>
std::vector<S> learnedNetDrawn(size_t count, Random& random) {
  std::vector<S> v(count);
  for (S& x : v) x = S(2 * random.unit() - 1);
  return v;
}

TEST(SoftWindow, PassesSubgoalsInOrderOrAheadWithinIt) {
  size_t next = 0;
  const auto at = [](size_t place) { return [place](size_t i) { return i == place; }; };
  EXPECT_TRUE(passSubgoals(next, 30, at(0)));
  EXPECT_EQ(next, 1u);
  EXPECT_TRUE(passSubgoals(next, 30, at(kWindow)));  // the last one in the window
  EXPECT_EQ(next, kWindow + 1);
  EXPECT_FALSE(passSubgoals(next, 30, at(next + kWindow)));  // the first beyond
  EXPECT_FALSE(passSubgoals(next, 30, at(next - 1)));        // already passed
  EXPECT_EQ(next, kWindow + 1);
  EXPECT_TRUE(
      passSubgoals(next, 14, [](size_t) { return true; }));  // passes the farthest of several
  EXPECT_EQ(next, 14u);
  EXPECT_FALSE(passSubgoals(next, 14, [](size_t) { return true; }));
}

std::vector<float> line(std::initializer_list<float> places) {
  std::vector<float> points;
  for (const float x : places) {
    points.push_back(x);
    points.resize(points.size() + kLatent - 1, 0.0f);
  }
  return points;
}

TEST(Thinning, KeepsTheGoalAndPointsFarEnoughApartBackwards) {
  const auto points = line({0, 0.5f, 1.2f, 1.3f, 2.4f, 2.5f, 3});
  EXPECT_EQ(thinned(points.data(), 7, 1), (std::vector<uint32_t>{0, 3, 6}));
  EXPECT_EQ(thinned(points.data(), 7, 0.05f).size(), 7u);
  EXPECT_EQ(thinned(points.data(), 7, 100), (std::vector<uint32_t>{6}));
}

TEST(Geometric, RanksFollowTheirProbabilities) {
  constexpr uint32_t kCount = 12, kDraws = 200'000;
  constexpr float kP = 0.2f;
  Random random(6, 6);
  uint32_t counts[kCount] = {};
  for (uint32_t n = 0; n < kDraws; ++n) ++counts[drawGeometric(random, kP, kCount)];
  const double all = 1 - std::pow(1 - double(kP), kCount);
  for (uint32_t r = 0; r < kCount; ++r) {
    const double expected = double(kP) * std::pow(1 - double(kP), r) / all;
    EXPECT_NEAR(counts[r] / double(kDraws), expected, 0.004) << r;
  }
  for (int n = 0; n < 100; ++n) EXPECT_EQ(drawGeometric(random, 0.005f, 1), 0u);
}

TEST(Neighbours, DistancesEqualThoseOfASort) {
  EXPECT_EQ(neighbourFor(1), 2u);
  EXPECT_EQ(neighbourFor(1u << 16), 4u);
  constexpr size_t kCount = 150;
  Random random(7, 7);
  const auto points = learnedNetDrawn<float>(kCount * kLatent, random);
  for (const int threads : {1, 3}) {
    ThreadPool pool(threads);
    const std::vector<float> found = neighbourDistances2(pool, points, 3);
    for (size_t i = 0; i < kCount; ++i) {
      std::vector<float> others;
      for (size_t j = 0; j < kCount; ++j) {
        const float* const a = points.data() + i * kLatent;
        if (j != i) others.push_back(latentDistance2(a, points.data() + j * kLatent));
      }
      std::nth_element(others.begin(), others.begin() + 2, others.end());
      ASSERT_EQ(found[i], others[2]) << i;
    }
  }
}

// Only cells in which the player stands have a weight, 1 / (1 + actions / 2). The start always has
// one.
TEST(CellChoice, WeighsCellsByTheirActionCounts) {
  CellChoice choice;
  for (int n = 0; n < 6; ++n) choice.act(1);
  choice.update(2);
  Random random(8, 8);
  uint32_t counts[2] = {};
  for (int n = 0; n < 50'000; ++n) ++counts[choice.pick(random)];
  EXPECT_NEAR(counts[0] / 50'000.0, 0.8, 0.01);  // 1 against 1/4
}

// Returns how far the policy's parameters move when it learns from decisions of `maker`.
float movedBy(Maker maker) {
  GoalPolicy policy({}, 1);
  const std::vector<float> before = policy.net().parameters();
  Decisions d(8, 2);
  Random random(9, 9);
  d.inputs = learnedNetDrawn<float>(d.inputs.size(), random);
  for (size_t r = 0; r < d.rows(); ++r) {
    d.made[r] = {{int(r) % policy::kMoves, logOf(1.0f / policy::kMoves), 0, 0}, true};
    d.makers[r] = maker;
    d.rewards[r] = r % 3 == 0 ? 1.0f : 0.0f;
  }
  ThreadPool pool(1);
  policy.learn(pool, d);
  float moved = 0;
  for (size_t i = 0; i < before.size(); ++i)
    moved = std::max(moved, std::abs(policy.net().parameters()[i] - before[i]));
  return moved;
}

TEST(GoalPolicy, LearnsFromReturnsAndKeptTrajectoriesButNotFromExploring) {
  EXPECT_EQ(movedBy(Maker::explorer), 0);
  EXPECT_GT(movedBy(Maker::policy), 1e-4f);
  EXPECT_GT(movedBy(Maker::kept), 1e-4f);
}

// The two visits can be made in either order. Places are far apart if different visits have been
// made.
TEST(InverseDynamics, DistinguishesTheVisitsMade) {
  const level::Level level = steppingStones().compile();
  const Problem problem = support::endlessProblem(level);
  const InverseDynamics module(1);
  NetPass pass;
  std::vector<float> points, places(4 * kPlace);
  sim::World worlds[4] = {problem.start, problem.start, problem.start, problem.start};
  worlds[1].visited = 1;
  worlds[2].visited = 2;
  worlds[3].waypoints = 1;
  for (size_t i = 0; i < 4; ++i) placeOf(problem, worlds[i], nullptr, places.data() + i * kPlace);
  module.encode(places.data(), 4, pass, points);
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j < i; ++j) {
      const float* const a = points.data() + i * kLatent;
      EXPECT_GT(latentDistance2(a, points.data() + j * kLatent), 500 * 500) << i << " " << j;
    }
  }
}

TEST(BestMove, IsTheAllowedMoveOfTheHighestMean) {
  std::vector<float> quantiles(size_t(policy::kMoves) * kQuantiles, -1.0f);
  quantiles[6 * kQuantiles] = 0;
  quantiles[9 * kQuantiles] = quantiles[9 * kQuantiles + 1] = 0;
  EXPECT_EQ(bestMove(quantiles.data(), true), 9);
  EXPECT_EQ(bestMove(quantiles.data(), false), 6);
}

}  // namespace
}  // namespace obby::baselines
