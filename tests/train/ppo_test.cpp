// Tests PPO against hand-made numbers: the scale of returns, steps of the optimiser, and ranks that
// share a batch.
#include "train/ppo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "train/some_batch.h"
#include "train/thread_ranks.h"

namespace obby::train {
namespace {

PpoSettings oneStepOf(uint32_t decisions) {
  PpoSettings s;
  s.epochs = 1;
  s.minibatch = decisions;
  return s;
}

// Two ranks with half of the worlds each take the same step as one rank with all worlds: gradients
// and moments of advantages and returns cover all decisions.
TEST(Ppo, TwoRanksTakeTheStepOfOneWithBothBatches) {
  constexpr uint32_t kWorlds = 24;
  ThreadPool pool(1);
  OneRank alone;
  Ppo whole(oneStepOf(kTicks * kWorlds), 5, pool, alone);
  const std::vector<float> before = whole.net().parameters();
  Batch all = someBatch(0, kWorlds);
  const Progress expected = whole.learn(all, 1);
  const std::vector<float> weights = whole.net().parameters();
  const LearnerState learned = whole.state();
  ThreadRanks::run(2, [&](Ranks& ranks) {
    ThreadPool own(1);
    Ppo half(oneStepOf(kTicks * kWorlds / 2), 5, own, ranks);
    Batch mine = someBatch(ranks.number() * kWorlds / 2, kWorlds / 2);
    const Progress found = half.learn(mine, 1);
    EXPECT_NEAR(found.loss, expected.loss, 1e-5);
    EXPECT_NEAR(found.gradNorm, expected.gradNorm, 1e-5 * expected.gradNorm);
    const LearnerState state = half.state();
    EXPECT_NEAR(state.values.mean, learned.values.mean, 1e-6);
    EXPECT_NEAR(state.values.deviation, learned.values.deviation, 1e-6);
    // Momentum is a tenth of the gradient. Unlike a step of Adam, it shows a wrong factor.
    const std::vector<float> mine1 = state.momentum, theirs = learned.momentum;
    for (size_t i = 0; i < mine1.size(); ++i) ASSERT_NEAR(mine1[i], theirs[i], 1e-7) << i;
  });
  double moved = 0;
  for (size_t i = 0; i < weights.size(); ++i)
    moved = std::max(moved, double(std::abs(weights[i] - before[i])));
  EXPECT_GT(moved, 1e-3);
}

// A second step for a single leftover decision would move the network as much as the first.
TEST(Ppo, MinibatchesHaveEqualSizes) {
  constexpr uint32_t kWorlds = 24;
  ThreadPool pool(1);
  OneRank alone;
  const auto learned = [&](uint32_t minibatch) {
    Ppo ppo(oneStepOf(minibatch), 5, pool, alone);
    Batch batch = someBatch(0, kWorlds);
    ppo.learn(batch, 1);
    return ppo.net().parameters();
  };
  EXPECT_EQ(learned(kTicks * kWorlds - 1), learned(kTicks * kWorlds / 2));
}

// Another mean and deviation of returns change the scale of the value head, but not its estimates.
TEST(Ppo, ValueEstimatesStayWhenTheScaleOfReturnsMoves) {
  ThreadPool pool(1);
  OneRank alone;
  Ppo ppo(oneStepOf(64), 5, pool, alone);
  Batch batch = someBatch(0, 16);
  for (float& r : batch.rewards) r = 50 + 10 * r;
  std::vector<uint32_t> rows(16);
  for (uint32_t i = 0; i < 16; ++i) rows[i] = i;
  const auto says = [&] {
    nn::Pass<float> pass;
    std::vector<float> begin;
    voidSums(batch.seen, ppo.net(), begin);
    const float* const out = pass.forward(ppo.net(), SeenPart(batch.seen, rows, begin));
    std::vector<float> values;
    for (size_t r = 0; r < rows.size(); ++r)
      values.push_back(ppo.valueOf(out[r * policy::kPaddedOutputs + policy::kMoves]));
    return values;
  };
  const std::vector<float> before = says();
  const ValueScale old = ppo.state().values;
  ppo.learn(batch, 0);  // updates the scale at a learning rate of 0
  const ValueScale now = ppo.state().values;
  EXPECT_GT(now.mean, old.mean + 10);
  EXPECT_GT(now.deviation, 2 * old.deviation);
  const std::vector<float> after = says();
  for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-4f) << i;
}

// Each decision ends an episode. Half of the moves have a reward of 1, the others 0.
TEST(Ppo, BetterMovesBecomeMoreLikely) {
  constexpr uint32_t kWorlds = 24, kDecisions = kTicks * kWorlds;
  ThreadPool pool(1);
  OneRank alone;
  Ppo ppo(oneStepOf(kDecisions), 5, pool, alone);
  Batch batch = someBatch(0, kWorlds);
  const auto isGood = [](int move) { return move < policy::kMoves / 2; };
  std::vector<uint32_t> rows(kDecisions);
  for (uint32_t i = 0; i < kDecisions; ++i) {
    rows[i] = i;
    batch.rewards[i] = isGood(batch.decisions[i].action) ? 1.0f : 0.0f;
    batch.values[i] = 0.5f;
    batch.done[i] = 1;
  }
  const auto shareOfGood = [&] {
    nn::Pass<float> pass;
    std::vector<float> begin;
    voidSums(batch.seen, ppo.net(), begin);
    const float* const out = pass.forward(ppo.net(), SeenPart(batch.seen, rows, begin));
    double good = 0;
    for (size_t r = 0; r < rows.size(); ++r) {
      float chances[policy::kMoves];
      policy::probabilitiesOf(out + r * policy::kPaddedOutputs, true, chances);
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

// Columns of hidden layers have length sqrt(2), the value head's column has length 1, and the moves
// have almost equal probabilities.
TEST(FirstNetwork, ColumnsHaveTheLengthsOfOrthogonalInitialisation) {
  const nn::Network<float> net = firstNetwork(3);
  const auto length2 = [&](size_t l, size_t column) {
    float sum = 0;
    for (size_t i = 0; i < net.inputs(l); ++i) {
      const float w = net.weights(l)[i * net.outputs(l) + column];
      sum += w * w;
    }
    return sum;
  };
  for (size_t o = 0; o < policy::kHidden; ++o) {
    EXPECT_NEAR(length2(0, o), 2, 1e-5f) << o;
    EXPECT_NEAR(length2(1, o), 2, 1e-5f) << o;
  }
  for (size_t m = 0; m < policy::kMoves; ++m) EXPECT_NEAR(length2(2, m), 1e-4f, 1e-8f) << m;
  EXPECT_NEAR(length2(2, policy::kMoves), 1, 1e-5f);
  EXPECT_EQ(length2(2, policy::kMoves + 1), 0) << "padding";
  EXPECT_NE(firstNetwork(4).parameters(), net.parameters());
}

// Advantages are normalised, so eightfold rewards move the policy by the same amount.
TEST(Ppo, TheStepDoesNotDependOnTheUnitOfRewards) {
  constexpr uint32_t kWorlds = 24;
  ThreadPool pool(1);
  OneRank alone;
  PpoSettings settings = oneStepOf(kTicks * kWorlds);
  settings.loss.valueWeight = 0;
  settings.maxGradNorm = 1e9f;
  const auto momentumAt = [&](float unit) {
    Batch batch = someBatch(0, kWorlds);
    for (std::vector<float>* numbers : {&batch.rewards, &batch.values, &batch.last}) {
      for (float& v : *numbers) v *= unit;
    }
    Ppo ppo(settings, 5, pool, alone);
    ppo.learn(batch, 1);
    return ppo.state().momentum;
  };
  const std::vector<float> plain = momentumAt(1), eightfold = momentumAt(8);
  float max = 0;
  for (size_t i = 0; i < plain.size(); ++i) {
    ASSERT_NEAR(plain[i], eightfold[i], 1e-6f) << i;
    max = std::max(max, std::abs(plain[i]));
  }
  EXPECT_GT(max, 1e-4f);
}

}  // namespace
}  // namespace obby::train
