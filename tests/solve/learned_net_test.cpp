// The basis of learning within a search: products in a fixed order, losses, and the latent space.
// Gradients are compared with finite differences in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "scenes.h"
#include "solve/learned/cell_choice.h"
#include "solve/learned/goal_policy.h"
#include "solve/learned/imitation_loss.h"
#include "solve/learned/inverse_dynamics.h"
#include "solve/learned/quantile_loss.h"
#include "solve/learned/quantile_policy.h"
#include "solve/learned/soft_window.h"

namespace obby::solve::learned {
namespace {

template <class S>
std::vector<S> learnedNetDrawn(size_t count, Random& random) {
  std::vector<S> v(count);
  for (S& x : v) x = S(2 * random.unit() - 1);
  return v;
}

// For any number of lanes, each number is summed in the order of a loop.
TEST(Product, EqualsALoopBitForBit) {
  Random random(1, 1);
  for (const size_t rows : {1u, 7u, 8u, 19u}) {
    const size_t inner = 37, columns = 48;
    const auto a = learnedNetDrawn<float>(rows * inner, random),
               b = learnedNetDrawn<float>(inner * columns, random);
    auto c = learnedNetDrawn<float>(rows * columns, random), expected = c;
    addProduct<float>({a.data(), inner, 1}, rows, inner, b.data(), columns, c.data());
    for (size_t r = 0; r < rows; ++r) {
      for (size_t o = 0; o < columns; ++o) {
        for (size_t k = 0; k < inner; ++k)
          expected[r * columns + o] += a[r * inner + k] * b[k * columns + o];
      }
    }
    EXPECT_EQ(std::memcmp(c.data(), expected.data(), c.size() * sizeof(float)), 0) << rows;
  }
}

// The loss is the sum of the outputs times fixed weights, which are its gradient by the outputs.
TEST(Net, GradientsMatchFiniteDifferences) {
  constexpr size_t kRows = 5;
  Random random(2, 2);
  Net<double> net({16, 32, 32, 16});
  net.numbers() = learnedNetDrawn<double>(net.numbers().size(), random);
  auto inputs = learnedNetDrawn<double>(kRows * 16, random);
  const auto slope = learnedNetDrawn<double>(kRows * 16, random);
  Pass<double> pass;
  const auto total = [&] {
    const double* out = pass.forward(net, inputs.data(), kRows);
    return std::inner_product(slope.begin(), slope.end(), out, 0.0);
  };
  std::vector<double> gradient(net.numbers().size(), 0.0), inputSlope(inputs.size(), 0.0);
  total();
  pass.backward(net, inputs.data(), kRows, slope.data(), gradient, inputSlope.data());
  const auto check = [&](std::vector<double>& numbers, const std::vector<double>& slopes) {
    for (int n = 0; n < 200; ++n) {
      const size_t i = random.below(uint32_t(numbers.size()));
      const double step = 1e-6, old = numbers[i];
      numbers[i] = old + step;
      const double more = total();
      numbers[i] = old - step;
      const double less = total();
      numbers[i] = old;
      EXPECT_NEAR(slopes[i], (more - less) / (2 * step), 1e-6) << i;
    }
  };
  check(net.numbers(), gradient);
  check(inputs, inputSlope);
}

// Compares the gradient from loss(at, slope) with finite differences.
template <class Loss>
void checkSlope(std::vector<double> at, Loss&& loss, double within = 1e-6) {
  std::vector<double> slope(at.size()), unused(at.size());
  loss(at.data(), slope.data());
  for (size_t i = 0; i < at.size(); ++i) {
    const double step = 1e-6, old = at[i];
    at[i] = old + step;
    const double more = loss(at.data(), unused.data());
    at[i] = old - step;
    const double less = loss(at.data(), unused.data());
    at[i] = old;
    EXPECT_NEAR(slope[i], (more - less) / (2 * step), within) << i;
  }
}

TEST(ImitationLoss, GradientsMatchFiniteDifferences) {
  Random random(3, 3);
  for (int n = 0; n < 20; ++n) {
    const auto at = learnedNetDrawn<double>(policy::kPaddedOutputs, random);
    const policy::Decision d{int(random.below(policy::kMoves)), true, 0, 0, 2};
    // The advantage counts as a constant in the likelihood's gradient, but not in the value's.
    const double better = double(d.target) - at[policy::kMoves];
    checkSlope(at, [&](const double* out, double* slope) {
      imitationLoss<double>(out, d, 0.1, 0.5, slope);
      double p[policy::kMoves];
      policy::chancesOf(out, true, p);
      const double error = double(d.target) - out[policy::kMoves];
      return 0.1 * (-std::log(p[d.move]) * better + 0.5 * error * error / 2);
    });
  }
}

TEST(ImitationLoss, IgnoresResultsBelowTheExpectation) {
  float outputs[policy::kPaddedOutputs] = {}, slope[policy::kPaddedOutputs];
  outputs[policy::kMoves] = 1;
  EXPECT_EQ(imitationLoss(outputs, {3, true, 0, 0, 0.5f}, 0.1f, 0.5f, slope), 0);
  for (const float s : slope) EXPECT_EQ(s, 0);
}

TEST(QuantileLoss, GradientsMatchFiniteDifferences) {
  Random random(4, 4);
  for (int n = 0; n < 20; ++n) {
    const auto targets = learnedNetDrawn<double>(kQuantiles, random);
    auto at = learnedNetDrawn<double>(kQuantiles, random);
    for (double& v : at) v *= 3;  // both sides of the point where the loss becomes linear
    checkSlope(at, [&](const double* predicted, double* slope) {
      return quantileLoss(predicted, targets.data(), slope);
    });
  }
}

// Gradient descent moves predictions to the quantiles of the targets.
TEST(QuantileLoss, ConvergesToTheQuantiles) {
  double targets[kQuantiles], predicted[kQuantiles] = {}, slope[kQuantiles];
  for (size_t i = 0; i < kQuantiles; ++i) targets[i] = 100 * double(i);
  for (int n = 0; n < 20000; ++n) {
    quantileLoss(predicted, targets, slope);
    for (size_t i = 0; i < kQuantiles; ++i) predicted[i] -= slope[i];
  }
  for (size_t i = 0; i < kQuantiles; ++i) EXPECT_NEAR(predicted[i], targets[i], 5) << i;
}

TEST(CrossEntropy, GradientsMatchFiniteDifferences) {
  Random random(5, 5);
  const uint8_t moves[] = {4, 33};
  checkSlope(
      learnedNetDrawn<double>(2 * padded(policy::kMoves), random),
      [&](const double* logits, double* slope) { return crossEntropy(logits, moves, 2, slope); });
}

TEST(SoftWindow, PassesSubgoalsInOrderOrAheadWithinIt) {
  size_t next = 0;
  const auto at = [](size_t place) { return [place](size_t i) { return i == place; }; };
  EXPECT_TRUE(passSubgoals(next, 30, at(0)));
  EXPECT_EQ(next, 1u);
  EXPECT_TRUE(passSubgoals(next, 30, at(kWindow)));  // the last of the window
  EXPECT_EQ(next, kWindow + 1);
  EXPECT_FALSE(passSubgoals(next, 30, at(next + kWindow)));  // the first beyond
  EXPECT_FALSE(passSubgoals(next, 30, at(next - 1)));        // already passed
  EXPECT_EQ(next, kWindow + 1);
  EXPECT_TRUE(passSubgoals(next, 14, [](size_t) { return true; }));  // the farthest of several
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

// Only standing states, with weight 1 / (1 + actions / 2); the start always counts.
TEST(CellChoice, WeighsCellsByTheActionsTakenThere) {
  CellChoice choice;
  for (int n = 0; n < 6; ++n) choice.act(1);
  choice.update(2);
  Random random(8, 8);
  uint32_t counts[2] = {};
  for (int n = 0; n < 50'000; ++n) ++counts[choice.pick(random)];
  EXPECT_NEAR(counts[0] / 50'000.0, 0.8, 0.01);  // 1 against 1/4
}

// Returns how far learning moves a policy, from rows of confident decisions at one place.
float movedBy(Maker maker) {
  GoalPolicy policy({}, 1);
  const std::vector<float> before = policy.net().numbers();
  Decisions d(8, 2);
  Random random(9, 9);
  d.inputs = learnedNetDrawn<float>(d.inputs.size(), random);
  for (size_t r = 0; r < d.rows(); ++r) {
    d.made[r] = {int(r) % policy::kMoves, true, logOf(1.0f / policy::kMoves), 0, 0};
    d.makers[r] = maker;
    d.rewards[r] = r % 3 == 0 ? 1.0f : 0.0f;
  }
  ThreadPool pool(1);
  policy.learn(pool, d);
  float moved = 0;
  for (size_t i = 0; i < before.size(); ++i)
    moved = std::max(moved, std::abs(policy.net().numbers()[i] - before[i]));
  return moved;
}

TEST(GoalPolicy, LearnsFromReturnsAndKeptTrajectoriesButNotFromExploring) {
  EXPECT_EQ(movedBy(Maker::explorer), 0);
  EXPECT_GT(movedBy(Maker::policy), 1e-4f);
  EXPECT_GT(movedBy(Maker::kept), 1e-4f);
}

// Two visits in opposite arms: having made the one is far from having made the other.
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
}  // namespace obby::solve::learned
