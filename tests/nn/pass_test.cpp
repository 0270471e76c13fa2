// Tests forward and backward passes of a network: products in a fixed order, gradients against
// finite differences in double precision, and a step of the optimiser.
#include "nn/pass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>
#include <tuple>

#include "drawn.h"
#include "nn/learner.h"
#include "nn/normal.h"
#include "nn/orthogonal.h"

namespace obby::nn {
namespace {

std::vector<float> halfZeros(size_t count, Random& random) {
  std::vector<float> v = drawn<float>(count, random);
  for (float& x : v) x = x < 0 ? 0 : x;
  return v;
}

// Each number is summed in the order of a plain loop, with any lanes and zeros.
TEST(Product, EqualsAPlainLoopBitForBit) {
  Random random(1, 1);
  for (const size_t rows : {1u, 7u, 64u, 130u}) {
    for (const size_t columns : {16u, 48u, 64u, 160u}) {
      const size_t inner = columns == 16 ? 8 : 100;
      const auto a = halfZeros(rows * inner, random), unit = halfZeros(rows * columns, random);
      const auto b = drawn<float>(inner * columns, random), bias = drawn<float>(columns, random);
      std::vector<float> c(rows * columns), expected = c;
      for (const auto& [begin, on, rectified] :
           {std::tuple(bias.data(), (const float*)nullptr, true),
            std::tuple((const float*)nullptr, unit.data(), false)}) {
        Product<float> p{a.data(), b.data(), begin, on, c.data(), rows, inner, columns, rectified};
        multiply(p);
        p.out = expected.data();
        multiply<float>(p);
        EXPECT_EQ(std::memcmp(c.data(), expected.data(), c.size() * sizeof(float)), 0) << columns;
      }
      std::vector<float> sums = drawn<float>((inner + 1) * columns, random), others = sums;
      const auto add = [&](std::vector<float>& to) {
        return GradientProduct<float>{a.data(), c.data(), to.data(), to.data() + inner * columns,
                                      rows,     inner,    columns};
      };
      addGradient(add(sums));
      addGradient<float>(add(others));
      EXPECT_EQ(sums, others) << rows << " x " << columns;
    }
  }
}

// The total is the sum of the outputs weighted by outGradient, so its gradient by the outputs is
// outGradient.
TEST(Pass, GradientsMatchFiniteDifferences) {
  constexpr size_t kRows = 5;
  Random random(2, 2);
  Network<double> net({16, 32, 32, 16});
  net.parameters() = drawn<double>(net.parameters().size(), random);
  auto inputs = drawn<double>(kRows * 16, random);
  const auto outGradient = drawn<double>(kRows * 16, random);
  const DenseRows<double> rows{inputs.data(), kRows};
  Pass<double> pass;
  const auto total = [&] {
    const double* out = pass.forward(net, rows);
    return std::inner_product(outGradient.begin(), outGradient.end(), out, 0.0);
  };
  std::vector<double> gradient(net.parameters().size(), 0.0), inputGradient(inputs.size(), 0.0);
  total();
  pass.backward(net, rows, outGradient.data(), gradient, inputGradient.data());
  const auto check = [&](std::vector<double>& numbers, const std::vector<double>& gradients) {
    for (int n = 0; n < 200; ++n) {
      const size_t i = random.below(uint32_t(numbers.size()));
      const double step = 1e-6, old = numbers[i];
      numbers[i] = old + step;
      const double more = total();
      numbers[i] = old - step;
      const double less = total();
      numbers[i] = old;
      EXPECT_NEAR(gradients[i], (more - less) / (2 * step), 1e-6) << i;
    }
  };
  check(net.parameters(), gradient);
  check(inputs, inputGradient);
}

// Compares with algorithm 1 of Kingma and Ba 2015, in double precision.
TEST(Adam, MovesAParameterAsPublished) {
  float parameter = 1, momentum = 0, squares = 0;
  double w = 1, m = 0, v = 0;
  uint64_t t = 0;
  for (const float g : {2.0f, -1.0f, 0.5f, 0.0f}) {
    AdamStep::at(++t, 0.1f).update(g, parameter, momentum, squares);
    m = 0.9 * m + 0.1 * double(g);
    v = 0.999 * v + 0.001 * double(g) * double(g);
    const double n = double(t);
    w -= 0.1 * (m / (1 - std::pow(0.9, n))) / (std::sqrt(v / (1 - std::pow(0.999, n))) + 1e-5);
    EXPECT_NEAR(parameter, w, 1e-6) << t;
  }
}

TEST(ClipGradNorm, ScalesDownLongerGradients) {
  std::vector<float> gradient(32);
  gradient[3] = 3;
  gradient[20] = -4;
  EXPECT_EQ(clipGradNorm<float>(gradient, 5), 5);
  EXPECT_EQ(gradient[3], 3);
  EXPECT_EQ(clipGradNorm<double>(gradient, 1), 5);
  EXPECT_FLOAT_EQ(gradient[3], 0.6f);
  EXPECT_FLOAT_EQ(gradient[20], -0.8f);
}

TEST(Learner, StepsAlongTheSummedSharesAndClearsThem) {
  Learner learner(Network<float>({2, 16}), 3);
  for (size_t s = 0; s < 3; ++s) learner.gradient(s)[5] = float(s + 1);
  learner.step(LearnerSettings{.learningRate = 0.5f}, 0.5f);
  EXPECT_FLOAT_EQ(learner.state().momentum[5], 0.1f * 3);
  EXPECT_NEAR(learner.net().parameters()[5], -0.5f, 1e-4f) << "the first step is the rate";
  EXPECT_EQ(learner.net().parameters()[6], 0);
  for (size_t s = 0; s < 3; ++s) EXPECT_EQ(learner.gradient(s)[5], 0) << s;
  Learner other(Network<float>({2, 16}), 3);
  other.restore(learner.state());
  EXPECT_EQ(other.steps(), 1u);
  EXPECT_EQ(other.state().parameters, learner.state().parameters);
}

TEST(Normal, IsNearlyNormal) {
  Random random(3, 5);
  double sum = 0, squares = 0;
  int beyond = 0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const double g = normal(random);
    sum += g;
    squares += g * g;
    beyond += g > 1 || g < -1 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.03);
  EXPECT_NEAR(squares / kDraws, 1, 0.05);
  EXPECT_NEAR(double(beyond) / kDraws, 0.317, 0.02);
}

// Columns (or rows, if there are fewer rows) are orthogonal and have the stated length. The padding
// stays unchanged.
TEST(Orthogonal, FillsColumnsOrRows) {
  for (const size_t rows : {3u, 9u}) {
    constexpr size_t kColumns = 5, kStride = 7;
    Random random(3, 3);
    std::vector<float> m(rows * kStride, 42.0f);
    fillOrthogonal(m.data(), rows, kColumns, kStride, 2, random);
    const size_t fewer = std::min(rows, kColumns), more = std::max(rows, kColumns);
    const auto at = [&](size_t a,
                        size_t b) {  // element b of the a-th column or row, whichever are fewer
      return rows < kColumns ? m[a * kStride + b] : m[b * kStride + a];
    };
    for (size_t a = 0; a < fewer; ++a) {
      for (size_t b = 0; b < fewer; ++b) {
        float product = 0;
        for (size_t k = 0; k < more; ++k) product += at(a, k) * at(b, k);
        EXPECT_NEAR(product, a == b ? 4.0f : 0.0f, 1e-5f) << a << " " << b;
      }
    }
    for (size_t r = 0; r < rows; ++r) EXPECT_EQ(m[r * kStride + kColumns], 42.0f);
  }
}

}  // namespace
}  // namespace obby::nn
