// The parts of learning, each against numbers made by hand or a formula: what a state was worth,
// normalised advantages, returns of a moving scale, a step of the optimiser, ranks that share a
// batch.
#include "train/ppo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "policy/advantages.h"
#include "train/some_batch.h"
#include "train/thread_ranks.h"

namespace obby::train {
namespace {

// One that dies with its second decision, and one that goes on, or is cut: what came last stands
// for the rest.
TEST(Advantages, AreBootstrappedWhereOneGoesOnButNotWhereOneDied) {
  const float values[] = {1, 1, 2, 2, 3, 3}, rewards[] = {1, 1, -1, 0, 2, 2}, last[] = {4, 4};
  const uint8_t done[] = {0, 0, 1, 0, 0, 0};
  float advantages[6], targets[6];
  policy::fillAdvantages({3, 2, values, rewards, done, last}, 0.5f, 0.5f, advantages, targets);
  const float dies[] = {0.25f, -3, 1}, goesOn[] = {0.9375f, -0.25f, 1};
  for (int t = 0; t < 3; ++t) {
    EXPECT_FLOAT_EQ(advantages[2 * t], dies[t]) << t;
    EXPECT_FLOAT_EQ(advantages[2 * t + 1], goesOn[t]) << t;
    EXPECT_FLOAT_EQ(targets[2 * t], values[2 * t] + dies[t]) << t;
    EXPECT_FLOAT_EQ(targets[2 * t + 1], values[2 * t + 1] + goesOn[t]) << t;
  }
}

TEST(AdvantageScale, IsMeanAndDeviation) {
  const AdvantageScale scale(1 + 2 + 3 + 6, 1 + 4 + 9 + 36, 4);
  EXPECT_FLOAT_EQ(scale.mean, 3);
  EXPECT_FLOAT_EQ(scale.scale, float(1 / std::sqrt(3.5)));
  EXPECT_EQ(scale.count, 4);
  EXPECT_TRUE(std::isfinite(AdvantageScale(8, 16, 4).scale)) << "all alike";
}

// Kingma and Ba 2015, algorithm 1, in double precision.
TEST(Adam, MovesAWeightAsPublished) {
  policy::Adam adam;
  float weight = 1, momentum = 0, squares = 0;
  double w = 1, m = 0, v = 0;
  int t = 0;
  for (const float g : {2.0f, -1.0f, 0.5f, 0.0f}) {
    adam.next();
    adam.update(&weight, &g, &momentum, &squares, 1, 0.1f);
    ++t;
    m = 0.9 * m + 0.1 * double(g);
    v = 0.999 * v + 0.001 * double(g) * double(g);
    w -= 0.1 * (m / (1 - std::pow(0.9, t))) / (std::sqrt(v / (1 - std::pow(0.999, t))) + 1e-5);
    EXPECT_NEAR(weight, w, 1e-6) << t;
  }
}

PpoSettings oneStepOf(uint32_t decisions) {
  PpoSettings s;
  s.passes = 1;
  s.part = decisions;
  return s;
}

// Two ranks with half of the worlds each take the step that one takes with all: gradients, moments
// of advantages and returns are those of all decisions.
TEST(Ppo, OfTwoRanksTakesTheStepOfOneWithBothBatches) {
  constexpr uint32_t kWorlds = 24;
  ThreadPool pool(1);
  OneRank alone;
  Ppo whole(oneStepOf(kTicks * kWorlds), 5, pool, alone);
  const std::vector<float> before = whole.weights().flat();
  Batch all = someBatch(0, kWorlds);
  const Progress expected = whole.learn(all, 1);
  const std::vector<float> weights = whole.weights().flat();
  const LearnerState learned = whole.state();
  ThreadRanks::run(2, [&](Ranks& ranks) {
    ThreadPool own(1);
    Ppo half(oneStepOf(kTicks * kWorlds / 2), 5, own, ranks);
    Batch mine = someBatch(ranks.number() * kWorlds / 2, kWorlds / 2);
    const Progress found = half.learn(mine, 1);
    EXPECT_NEAR(found.loss, expected.loss, 1e-5);
    EXPECT_NEAR(found.norm, expected.norm, 1e-5 * expected.norm);
    const LearnerState state = half.state();
    EXPECT_NEAR(state.values.mean, learned.values.mean, 1e-6);
    EXPECT_NEAR(state.values.deviation, learned.values.deviation, 1e-6);
    // Momentum is a tenth of the gradient: unlike a step of Adam it tells a wrong factor.
    const std::vector<float> mine1 = state.momentum.flat(), theirs = learned.momentum.flat();
    for (size_t i = 0; i < mine1.size(); ++i) ASSERT_NEAR(mine1[i], theirs[i], 1e-7) << i;
  });
  double moved = 0;
  for (size_t i = 0; i < weights.size(); ++i)
    moved = std::max(moved, double(std::abs(weights[i] - before[i])));
  EXPECT_GT(moved, 1e-3);
}

// Another step by the one decision that is left over would move as much as the first.
TEST(Ppo, LearnsInPartsOfOneSize) {
  constexpr uint32_t kWorlds = 24;
  ThreadPool pool(1);
  OneRank alone;
  const auto learned = [&](uint32_t part) {
    Ppo ppo(oneStepOf(part), 5, pool, alone);
    Batch batch = someBatch(0, kWorlds);
    ppo.learn(batch, 1);
    return ppo.weights().flat();
  };
  EXPECT_EQ(learned(kTicks * kWorlds - 1), learned(kTicks * kWorlds / 2));
}

// Returns of another mean and spread move what the value head's outputs mean, not what it says.
TEST(Ppo, SaysTheSameOfAStateWhenTheScaleOfReturnsMoves) {
  ThreadPool pool(1);
  OneRank alone;
  Ppo ppo(oneStepOf(64), 5, pool, alone);
  Batch batch = someBatch(0, 16);
  for (float& r : batch.rewards) r = 50 + 10 * r;
  std::vector<uint32_t> rows(16);
  for (uint32_t i = 0; i < 16; ++i) rows[i] = i;
  const auto says = [&] {
    Pass pass;
    Line<float> begin;
    voidSums(batch.seen, ppo.weights(), begin);
    const Rows<float> out = pass.forward(ppo.weights(), {batch.seen, rows, begin});
    std::vector<float> values;
    for (Eigen::Index r = 0; r < out.rows(); ++r)
      values.push_back(ppo.valueOf(out(r, policy::kMoves)));
    return values;
  };
  const std::vector<float> before = says();
  const ValueScale old = ppo.state().values;
  ppo.learn(batch, 0);  // at no rate
  const ValueScale now = ppo.state().values;
  EXPECT_GT(now.mean, old.mean + 10);
  EXPECT_GT(now.deviation, 2 * old.deviation);
  const std::vector<float> after = says();
  for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-4f) << i;
}

// Orthogonal columns, or rows where these are fewer, of the stated length.
TEST(FirstWeights, AreOrthogonal) {
  const Weights<float> net = firstWeights(3);
  const auto expectIdentity = [](const Rows<float>& product, float length) {
    const Rows<float> identity = Rows<float>::Identity(product.rows(), product.cols());
    EXPECT_LT((product - length * length * identity).cwiseAbs().maxCoeff(), 1e-5f);
  };
  expectIdentity(net.w[0].transpose() * net.w[0], std::sqrt(2.0f));
  expectIdentity(net.w[1].transpose() * net.w[1], std::sqrt(2.0f));
  const Rows<float> moves = net.w[2].leftCols(policy::kMoves);
  expectIdentity(moves.transpose() * moves, 0.01f);
  EXPECT_NEAR(net.w[2].col(policy::kMoves).norm(), 1, 1e-5f);
  EXPECT_NE(firstWeights(4).flat(), net.flat());
}

TEST(Advantages, DiscountAndLambdaAreTwoThings) {
  const float values[] = {1, 2, 3}, rewards[] = {1, 0, 2}, last[] = {4};
  const uint8_t done[] = {0, 0, 0};
  float advantages[3], targets[3];
  policy::fillAdvantages({3, 1, values, rewards, done, last}, 0.5f, 0.25f, advantages, targets);
  EXPECT_FLOAT_EQ(advantages[2], 1);
  EXPECT_FLOAT_EQ(advantages[1], -0.375f);
  EXPECT_FLOAT_EQ(advantages[0], 0.953125f);
}

// Each decision ends a playthrough; those with one half of the moves are worth 1, others nothing.
TEST(Ppo, MakesLikelierWhatWentBetterThanExpected) {
  constexpr uint32_t kWorlds = 24, kDecisions = kTicks * kWorlds;
  ThreadPool pool(1);
  OneRank alone;
  Ppo ppo(oneStepOf(kDecisions), 5, pool, alone);
  Batch batch = someBatch(0, kWorlds);
  const auto isGood = [](int move) { return move < policy::kMoves / 2; };
  std::vector<uint32_t> rows(kDecisions);
  for (uint32_t i = 0; i < kDecisions; ++i) {
    rows[i] = i;
    batch.rewards[i] = isGood(batch.decisions[i].move) ? 1.0f : 0.0f;
    batch.values[i] = 0.5f;
    batch.done[i] = 1;
  }
  const auto shareOfGood = [&] {
    Pass pass;
    Line<float> begin;
    voidSums(batch.seen, ppo.weights(), begin);
    const Rows<float>& out = pass.forward(ppo.weights(), {batch.seen, rows, begin});
    double good = 0;
    for (Eigen::Index r = 0; r < out.rows(); ++r) {
      float chances[policy::kMoves];
      policy::chancesOf(out.row(r).data(), true, chances);
      for (int m = 0; m < policy::kMoves; ++m) {
        if (isGood(m)) good += double(chances[m]);
      }
    }
    return good / double(kDecisions);
  };
  EXPECT_NEAR(shareOfGood(), 0.5, 0.05);
  for (int n = 0; n < 20; ++n) ppo.learn(batch, 1);
  EXPECT_GT(shareOfGood(), 0.55);
}

// Normalised: eight times the rewards move the policy as much.
TEST(Ppo, TakesTheSameStepWhateverRewardsAreCountedIn) {
  constexpr uint32_t kWorlds = 24;
  ThreadPool pool(1);
  OneRank alone;
  PpoSettings settings = oneStepOf(kTicks * kWorlds);
  settings.loss.valueShare = 0;
  settings.mostNorm = 1e9f;
  const auto momentumAt = [&](float unit) {
    Batch batch = someBatch(0, kWorlds);
    for (std::vector<float>* numbers : {&batch.rewards, &batch.values, &batch.last}) {
      for (float& v : *numbers) v *= unit;
    }
    Ppo ppo(settings, 5, pool, alone);
    ppo.learn(batch, 1);
    return ppo.state().momentum.flat();
  };
  const std::vector<float> plain = momentumAt(1), eightfold = momentumAt(8);
  float most = 0;
  for (size_t i = 0; i < plain.size(); ++i) {
    ASSERT_NEAR(plain[i], eightfold[i], 1e-6f) << i;
    most = std::max(most, std::abs(plain[i]));
  }
  EXPECT_GT(most, 1e-4f);
}

}  // namespace
}  // namespace obby::train
