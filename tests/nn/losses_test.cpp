// Gradients of losses against finite differences in double precision, losses against published
// formulas, and advantages against hand-computed values.
#include "nn/losses.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn.h"
#include "nn/advantages.h"

namespace obby::nn {
namespace {

constexpr size_t kQuantiles = 8;

TEST(QuantileLoss, GradientsMatchFiniteDifferences) {
  Random random(4, 4);
  for (int n = 0; n < 20; ++n) {
    const auto targets = drawn<double>(kQuantiles, random);
    auto at = drawn<double>(kQuantiles, random);
    for (double& v : at) v *= 3;  // covers both the quadratic and the linear part of the loss
    checkGradient(at, [&](const double* predicted, double* gradient) {
      return quantileLoss<kQuantiles>(predicted, targets.data(), gradient);
    });
  }
}

// Gradient descent moves the predictions to the quantiles of the targets.
TEST(QuantileLoss, ConvergesToTheQuantilesOfTheTargets) {
  double targets[kQuantiles], predicted[kQuantiles] = {}, gradient[kQuantiles];
  for (size_t i = 0; i < kQuantiles; ++i) targets[i] = 100 * double(i);
  for (int n = 0; n < 20000; ++n) {
    quantileLoss<kQuantiles>(predicted, targets, gradient);
    for (size_t i = 0; i < kQuantiles; ++i) predicted[i] -= gradient[i];
  }
  for (size_t i = 0; i < kQuantiles; ++i) EXPECT_NEAR(predicted[i], targets[i], 5) << i;
}

TEST(CrossEntropy, GradientsMatchFiniteDifferences) {
  constexpr int kActions = 10;
  Random random(5, 5);
  for (const int action : {4, 9}) {
    checkGradient(drawn<double>(kActions, random), [&](const double* logits, double* gradient) {
      double p[kActions];
      softmax<kActions>(
          logits, [](int) { return 0.0; }, p);
      return crossEntropy<kActions>(p, action, gradient);
    });
  }
}

// The first episode ends in death at its second decision. The second episode continues or is
// truncated, so the last value estimates the rest.
TEST(Advantages, BootstrapOnlyUnfinishedPlaythroughs) {
  const float values[] = {1, 1, 2, 2, 3, 3}, rewards[] = {1, 1, -1, 0, 2, 2}, last[] = {4, 4};
  const uint8_t done[] = {0, 0, 1, 0, 0, 0};
  float advantages[6], targets[6];
  fillAdvantages({3, 2, values, rewards, done, last}, 0.5f, 0.5f, advantages, targets);
  const float dies[] = {0.25f, -3, 1}, goesOn[] = {0.9375f, -0.25f, 1};
  for (int t = 0; t < 3; ++t) {
    EXPECT_FLOAT_EQ(advantages[2 * t], dies[t]) << t;
    EXPECT_FLOAT_EQ(advantages[2 * t + 1], goesOn[t]) << t;
    EXPECT_FLOAT_EQ(targets[2 * t], values[2 * t] + dies[t]) << t;
    EXPECT_FLOAT_EQ(targets[2 * t + 1], values[2 * t + 1] + goesOn[t]) << t;
  }
}

TEST(AdvantageScale, IsMeanAndDeviation) {
  const AdvantageScale scale = advantageScale({1 + 2 + 3 + 6, 1 + 4 + 9 + 36}, 4, 1e-8);
  EXPECT_FLOAT_EQ(scale.mean, 3);
  EXPECT_FLOAT_EQ(scale.scale, float(1 / std::sqrt(3.5)));
  EXPECT_FLOAT_EQ(scale(5), 2 * scale.scale);
  EXPECT_EQ(advantageScale({}, 0, 1e-6f).mean, 0) << "of none";
  EXPECT_TRUE(std::isfinite(advantageScale({8, 16}, 4, 1e-8).scale)) << "all alike";
}

TEST(Advantages, DiscountAndLambdaActSeparately) {
  const float values[] = {1, 2, 3}, rewards[] = {1, 0, 2}, last[] = {4};
  const uint8_t done[] = {0, 0, 0};
  float advantages[3], targets[3];
  fillAdvantages({3, 1, values, rewards, done, last}, 0.5f, 0.25f, advantages, targets);
  EXPECT_FLOAT_EQ(advantages[2], 1);
  EXPECT_FLOAT_EQ(advantages[1], -0.375f);
  EXPECT_FLOAT_EQ(advantages[0], 0.953125f);
}

}  // namespace
}  // namespace obby::nn
