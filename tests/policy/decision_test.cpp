// Losses of a decision and of the whole network. Their gradients are compared with finite
// differences in double precision.
#include "policy/decision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nn/drawn.h"
#include "nn/pass.h"
#include "policy/trainable.h"

namespace obby::policy {
namespace {

using nn::PpoLossSettings;

constexpr int kOut = kPaddedOutputs;

Decision lossSample(Random& random) {
  Decision d;
  d.mayJump = random.below(2) != 0;
  d.action = int(random.below(kMoves / 2)) * 2 + (d.mayJump ? int(random.below(2)) : 0);
  d.logProbability = -1 - 4 * random.unit();
  d.advantage = 4 * random.unit() - 2;
  d.target = 2 * random.unit() - 1;
  return d;
}

TEST(Loss, GradientsMatchFiniteDifferences) {
  Random random(1, 1);
  for (int n = 0; n < 200; ++n) {
    const Decision d = lossSample(random);
    double outputs[kOut], gradient[kOut], unused[kOut];
    for (double& o : outputs) o = 3 * double(random.unit()) - 1.5;
    const auto at = ppoLossOf(outputs, d, PpoLossSettings{}, gradient);
    for (int m = 0; m < kOut; ++m) {
      const double step = 1e-6, old = outputs[m];
      outputs[m] = old + step;
      const auto more = ppoLossOf(outputs, d, PpoLossSettings{}, unused);
      outputs[m] = old - step;
      const auto less = ppoLossOf(outputs, d, PpoLossSettings{}, unused);
      outputs[m] = old;
      // The loss has a kink here.
      if (more.clipped != at.clipped || less.clipped != at.clipped) continue;
      EXPECT_NEAR(gradient[m], (more.loss - less.loss) / (2 * step), 1e-6) << n << " " << m;
    }
  }
}

TEST(Loss, ForbiddenMovesHaveNoGradient) {
  Random random(2, 2);
  Decision d = lossSample(random);
  d.mayJump = false;
  d.action = 4;
  float outputs[kOut] = {}, gradient[kOut];
  ppoLossOf(outputs, d, PpoLossSettings{}, gradient);
  for (int m = 1; m < kMoves; m += 2) EXPECT_EQ(gradient[m], 0);
  for (int m = 1; m < kMoves; m += 2) outputs[m] = 1000;
  float chances[kMoves], sum = 0;
  probabilitiesOf(outputs, false, chances);
  for (const float c : chances) sum += c;
  EXPECT_NEAR(sum, 1, 1e-6f);
  EXPECT_EQ(chances[1], 0);
}

// Returns the sum of the losses of a few rows.
double total(const nn::Network<double>& net, const nn::DenseRows<double>& inputs,
             const std::vector<Decision>& decisions, double* gradient, nn::Pass<double>& pass) {
  const double* out = pass.forward(net, inputs);
  double unused[kOut], sum = 0;
  for (size_t i = 0; i < decisions.size(); ++i, out += kOut) {
    double* const to = gradient != nullptr ? gradient + i * kOut : unused;
    sum += ppoLossOf(out, decisions[i], PpoLossSettings{}, to).loss;
  }
  return sum;
}

TEST(Network, GradientsMatchFiniteDifferences) {
  constexpr size_t kRows = 6;
  Random random(3, 3);
  nn::Network<double> net = trainableNetwork<double>();
  std::vector<double>& parameters = net.parameters();
  for (double& w : parameters) w = 0.3 * (double(random.unit()) - 0.5);
  std::vector<double> inputs(kRows * kInputs), outGradient(kRows * kOut);
  for (double& v : inputs) v = double(random.unit()) - 0.5;
  const nn::DenseRows<double> rows{inputs.data(), kRows};
  std::vector<Decision> decisions;
  for (size_t i = 0; i < kRows; ++i) decisions.push_back(lossSample(random));
  nn::Pass<double> pass, probe;
  std::vector<double> gradient(parameters.size());
  total(net, rows, decisions, outGradient.data(), pass);
  pass.backward(net, rows, outGradient.data(), gradient);
  int compared = 0;
  for (size_t i = 0; i < parameters.size(); i += 37) {
    const double step = 1e-6, old = parameters[i];
    parameters[i] = old + step;
    const double more = total(net, rows, decisions, nullptr, probe);
    parameters[i] = old - step;
    const double less = total(net, rows, decisions, nullptr, probe);
    parameters[i] = old;
    EXPECT_NEAR(gradient[i], (more - less) / (2 * step), 2e-6) << i;
    compared += std::abs(gradient[i]) > 1e-6;
  }
  EXPECT_GT(compared, 100);
}

// Equations 7 and 9 of Schulman et al. 2017, computed by hand. 17 moves are allowed and have equal
// logits.
TEST(Loss, MatchesThePublishedFormula) {
  struct Case {
    double ratio;
    float advantage;
    double surrogate;
    bool clipped;
  };
  const Case cases[] = {{1.5, 2, 2.4, true},   {0.5, 2, 1, false},   {1.5, -2, -3, false},
                        {0.5, -2, -1.6, true}, {1.1, 2, 2.2, false}, {0.9, -2, -1.8, false}};
  double outputs[kOut] = {}, gradient[kOut];
  outputs[kMoves] = 0.5;
  const double entropy = std::log(17.0);
  for (const Case& c : cases) {
    const Decision d{{4, float(-entropy - std::log(c.ratio)), c.advantage, 0}, false};
    const auto r = ppoLossOf(outputs, d, PpoLossSettings{}, gradient);
    EXPECT_NEAR(r.entropy, entropy, 1e-9);
    EXPECT_NEAR(r.loss, -c.surrogate + 0.5 * 0.25 / 2 - 0.01 * entropy, 1e-5) << c.ratio;
    EXPECT_EQ(r.clipped, c.clipped) << c.ratio;
    const double pull = c.clipped ? 0.0 : -c.ratio * double(c.advantage) * (1 - 1 / 17.0);
    EXPECT_NEAR(gradient[4], pull, 1e-5) << c.ratio;
    EXPECT_NEAR(gradient[kMoves], 0.25, 1e-7);
  }
}

TEST(Loss, EntropyFlattensTheDistribution) {
  double outputs[kOut] = {}, gradient[kOut];
  outputs[4] = 2;
  ppoLossOf(outputs, Decision{{4, -1, 0, 0}, true}, PpoLossSettings{}, gradient);
  EXPECT_GT(gradient[4], 1e-3) << "descent makes the most likely move less likely";
}

// The probability ratio of the loss starts at one.
TEST(Loss, ADrawnMoveHasTheProbabilityOfTheDraw) {
  Random random(4, 4);
  for (int n = 0; n < 200; ++n) {
    float outputs[kOut] = {}, gradient[kOut];
    for (int m = 0; m < kMoves; ++m) outputs[m] = 4 * random.unit() - 2;
    const bool mayJump = n % 2 == 0;
    const nn::Drawn drawn = drawMove(outputs, mayJump, random.unit());
    ASSERT_TRUE(isAllowed(drawn.action, mayJump));
    const Decision d{{drawn.action, drawn.logProbability, 1, 0}, mayJump};
    const auto r = ppoLossOf(outputs, d, PpoLossSettings{}, gradient);
    EXPECT_NEAR(r.approxKl, 0, 1e-6);
    EXPECT_FALSE(r.clipped);
  }
  const float even[kOut] = {};
  EXPECT_EQ(drawMove(even, false, 0.0f).action, 0);
  EXPECT_EQ(drawMove(even, false, 0.9999999f).action, kMoves - 2);
}

TEST(ImitationLoss, GradientsMatchFiniteDifferences) {
  Random random(3, 3);
  for (int n = 0; n < 20; ++n) {
    const auto at = nn::drawn<double>(kPaddedOutputs, random);
    const Decision d{{int(random.below(kMoves)), 0, 0, 2}, true};
    // The advantage is a constant in the gradient of the likelihood, but not in the gradient of the
    // value.
    const double better = double(d.target) - at[kMoves];
    nn::checkGradient(at, [&](const double* out, double* gradient) {
      imitationLossOf<double>(out, d, 0.1, 0.5, gradient);
      double p[kMoves];
      probabilitiesOf(out, true, p);
      const double error = double(d.target) - out[kMoves];
      return 0.1 * (-std::log(p[d.action]) * better + 0.5 * error * error / 2);
    });
  }
}

TEST(ImitationLoss, LearnsNothingFromANegativeAdvantage) {
  float outputs[kPaddedOutputs] = {}, gradient[kPaddedOutputs];
  outputs[kMoves] = 1;
  EXPECT_EQ(imitationLossOf(outputs, {{3, 0, 0, 0.5f}, true}, 0.1f, 0.5f, gradient), 0);
  for (const float s : gradient) EXPECT_EQ(s, 0);
}

}  // namespace
}  // namespace obby::policy
