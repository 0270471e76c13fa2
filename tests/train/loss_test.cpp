// The loss and its slope, held against finite differences in double precision; the whole network
// likewise.
#include "policy/ppo_loss.h"

#include <gtest/gtest.h>

#include <cmath>

#include "policy/moves.h"
#include "train/full_pass.h"

namespace obby::train {
namespace {

using policy::chancesOf;
using policy::Decision;
using policy::lossOf;
using policy::LossSettings;

constexpr int kOut = policy::kPaddedOutputs;

Decision lossSample(Random& random) {
  Decision d;
  d.mayJump = random.below(2) != 0;
  d.move = int(random.below(policy::kMoves / 2)) * 2 + (d.mayJump ? int(random.below(2)) : 0);
  d.logChance = -1 - 4 * random.unit();
  d.advantage = 4 * random.unit() - 2;
  d.target = 2 * random.unit() - 1;
  return d;
}

TEST(Loss, SlopesAreThoseOfFiniteDifferences) {
  Random random(1, 1);
  for (int n = 0; n < 200; ++n) {
    const Decision d = lossSample(random);
    double outputs[kOut], slope[kOut], unused[kOut];
    for (double& o : outputs) o = 3 * double(random.unit()) - 1.5;
    const auto at = lossOf(outputs, d, LossSettings{}, slope);
    for (int m = 0; m < kOut; ++m) {
      const double step = 1e-6, old = outputs[m];
      outputs[m] = old + step;
      const auto more = lossOf(outputs, d, LossSettings{}, unused);
      outputs[m] = old - step;
      const auto less = lossOf(outputs, d, LossSettings{}, unused);
      outputs[m] = old;
      if (more.clipped != at.clipped || less.clipped != at.clipped) continue;  // at the kink
      EXPECT_NEAR(slope[m], (more.loss - less.loss) / (2 * step), 1e-6) << n << " " << m;
    }
  }
}

TEST(Loss, NeverLeansTowardWhatIsNotAllowed) {
  Random random(2, 2);
  Decision d = lossSample(random);
  d.mayJump = false;
  d.move = 4;
  float outputs[kOut] = {}, slope[kOut];
  lossOf(outputs, d, LossSettings{}, slope);
  for (int m = 1; m < policy::kMoves; m += 2) EXPECT_EQ(slope[m], 0);
  for (int m = 1; m < policy::kMoves; m += 2) outputs[m] = 1000;
  float chances[policy::kMoves], sum = 0;
  chancesOf(outputs, false, chances);
  for (const float c : chances) sum += c;
  EXPECT_NEAR(sum, 1, 1e-6f);
  EXPECT_EQ(chances[1], 0);
}

// Sum of the losses of a few rows.
double total(const Weights<double>& net, const Rows<double>& inputs,
             const std::vector<Decision>& decisions, Rows<double>* slope, FullPass<double>& pass) {
  const Rows<double>& out = pass.forward(net, inputs);
  Rows<double> unused(out.rows(), kOut);
  Rows<double>& to = slope != nullptr ? *slope : unused;
  double sum = 0;
  for (Eigen::Index i = 0; i < out.rows(); ++i)
    sum += lossOf(out.row(i).data(), decisions[size_t(i)], LossSettings{}, to.row(i).data()).loss;
  return sum;
}

TEST(Network, GradientsAreThoseOfFiniteDifferences) {
  constexpr Eigen::Index kRows = 6;
  Random random(3, 3);
  Weights<double> net;
  net.blocks([&](double* w, size_t count) {
    for (size_t i = 0; i < count; ++i) w[i] = 0.3 * (double(random.unit()) - 0.5);
  });
  Rows<double> inputs(kRows, policy::kInputs), slope(kRows, kOut);
  for (Eigen::Index i = 0; i < inputs.size(); ++i) inputs.data()[i] = double(random.unit()) - 0.5;
  std::vector<Decision> decisions;
  for (int i = 0; i < kRows; ++i) decisions.push_back(lossSample(random));
  FullPass<double> pass, probe;
  Weights<double> gradient;
  total(net, inputs, decisions, &slope, pass);
  pass.backward(net, inputs, slope, gradient);
  std::vector<double*> weights;
  std::vector<double> slopes;
  net.blocks([&](double* w, size_t count) {
    for (size_t i = 0; i < count; ++i) weights.push_back(w + i);
  });
  gradient.blocks(
      [&](const double* g, size_t count) { slopes.insert(slopes.end(), g, g + count); });
  int compared = 0;
  for (size_t i = 0; i < weights.size(); i += 37) {
    const double step = 1e-6, old = *weights[i];
    *weights[i] = old + step;
    const double more = total(net, inputs, decisions, nullptr, probe);
    *weights[i] = old - step;
    const double less = total(net, inputs, decisions, nullptr, probe);
    *weights[i] = old;
    EXPECT_NEAR(slopes[i], (more - less) / (2 * step), 2e-6) << i;
    compared += std::abs(slopes[i]) > 1e-6;
  }
  EXPECT_GT(compared, 100);
}

// Schulman et al. 2017, equations 7 and 9, by hand: 17 moves are allowed, all alike.
TEST(Loss, IsThePublishedFormula) {
  struct Case {
    double ratio;
    float advantage;
    double surrogate;
    bool clipped;
  };
  const Case cases[] = {{1.5, 2, 2.4, true},   {0.5, 2, 1, false},   {1.5, -2, -3, false},
                        {0.5, -2, -1.6, true}, {1.1, 2, 2.2, false}, {0.9, -2, -1.8, false}};
  double outputs[kOut] = {}, slope[kOut];
  outputs[policy::kMoves] = 0.5;
  const double entropy = std::log(17.0);
  for (const Case& c : cases) {
    const Decision d{4, false, float(-entropy - std::log(c.ratio)), c.advantage, 0};
    const auto r = lossOf(outputs, d, LossSettings{}, slope);
    EXPECT_NEAR(r.entropy, entropy, 1e-9);
    EXPECT_NEAR(r.loss, -c.surrogate + 0.5 * 0.25 / 2 - 0.01 * entropy, 1e-5) << c.ratio;
    EXPECT_EQ(r.clipped, c.clipped) << c.ratio;
    const double pull = c.clipped ? 0.0 : -c.ratio * double(c.advantage) * (1 - 1 / 17.0);
    EXPECT_NEAR(slope[4], pull, 1e-5) << c.ratio;
    EXPECT_NEAR(slope[policy::kMoves], 0.25, 1e-7);
  }
}

TEST(Loss, LeavesMoreToChance) {
  double outputs[kOut] = {}, slope[kOut];
  outputs[4] = 2;
  lossOf(outputs, Decision{4, true, -1, 0, 0}, LossSettings{}, slope);
  EXPECT_GT(slope[4], 1e-3) << "downhill is less of the likeliest";
}

// The ratio of the loss begins at one.
TEST(Loss, TakesADrawnMoveForAsLikelyAsTheDrawSays) {
  Random random(4, 4);
  for (int n = 0; n < 200; ++n) {
    float outputs[kOut] = {}, slope[kOut];
    for (int m = 0; m < policy::kMoves; ++m) outputs[m] = 4 * random.unit() - 2;
    const bool mayJump = n % 2 == 0;
    const policy::Drawn drawn = policy::drawMove(outputs, mayJump, random.unit());
    ASSERT_TRUE(policy::isAllowed(drawn.move, mayJump));
    const Decision d{drawn.move, mayJump, drawn.logChance, 1, 0};
    const auto r = lossOf(outputs, d, LossSettings{}, slope);
    EXPECT_NEAR(r.divergence, 0, 1e-6);
    EXPECT_FALSE(r.clipped);
  }
  const float even[kOut] = {};
  EXPECT_EQ(policy::drawMove(even, false, 0.0f).move, 0);
  EXPECT_EQ(policy::drawMove(even, false, 0.9999999f).move, policy::kMoves - 2);
}

}  // namespace
}  // namespace obby::train
