// Rows that are lists of what is seen, there and back over what is not zero: held against the
// network of the search, and against the same rows in full in double precision.
#include "train/pass.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "policy/policy.h"
#include "train/full_pass.h"

namespace obby::train {
namespace {

Weights<float> someWeights(uint64_t seed) {
  Random random(seed, 1);
  Weights<float> net;
  net.blocks([&](float* w, size_t count) {
    for (size_t i = 0; i < count; ++i) w[i] = 0.3f * (random.unit() - 0.5f);
  });
  return net;
}

Weights<double> asDouble(const Weights<float>& net) {
  Weights<double> out;
  for (int l = 0; l < 3; ++l) {
    out.w[l] = net.w[l].cast<double>();
    out.b[l] = net.b[l].cast<double>();
  }
  return out;
}

// Observations: states, and maps of which one height in three is not empty; with a network.
struct Seen {
  std::vector<float> means, scales;
  Rows<float> raw;
  SeenRows rows;
  Weights<float> net;
  Line<float> begin;

  explicit Seen(uint32_t count, uint64_t seed = 1)
      : means(policy::kInputs),
        scales(policy::kInputs),
        raw(count, policy::kInputs),
        rows(count),
        net(someWeights(seed)) {
    Random random(seed, 0);
    for (size_t i = 0; i < means.size(); ++i) {
      means[i] = 2 * random.unit() - 1;
      scales[i] = 0.2f + 4 * random.unit();
    }
    scales[40] = 0;  // hidden
    rows.normaliseBy(means, scales);
    voidSums(rows, net, begin);
    for (Eigen::Index r = 0; r < raw.rows(); ++r) {
      for (int i = 0; i < policy::kInputs; ++i) {
        const bool empty = i >= policy::kStateInputs && random.below(3) != 0;
        raw(r, i) = empty ? policy::kEmptyInput : 3 * random.unit() - 1.9f;
      }
      rows.take(size_t(r), raw.row(r).data());
    }
  }

  SeenPart part(std::span<const uint32_t> which) const { return {rows, which, begin}; }

  Rows<double> normalised(std::span<const uint32_t> which) const {
    Rows<double> out(Eigen::Index(which.size()), policy::kInputs);
    for (Eigen::Index r = 0; r < out.rows(); ++r) {
      for (int i = 0; i < policy::kInputs; ++i) {
        out(r, i) = double(policy::normalised(raw(Eigen::Index(which[size_t(r)]), i),
                                              means[size_t(i)], scales[size_t(i)]));
      }
    }
    return out;
  }

  // As the search has it.
  policy::Network network() const {
    policy::Network out;
    std::vector<float> numbers = means;
    numbers.insert(numbers.end(), scales.begin(), scales.end());
    const std::vector<float> weights = net.flat();
    numbers.insert(numbers.end(), weights.begin(), weights.end());
    EXPECT_EQ(numbers.size(), out.numbers().size());
    std::copy(numbers.begin(), numbers.end(), out.numbers().begin());
    return out;
  }
};

// Any rows, in any order, some twice.
std::vector<uint32_t> someRows(uint32_t count, uint32_t of) {
  Random random(count, 5);
  std::vector<uint32_t> out(count);
  for (uint32_t& r : out) r = random.below(of);
  return out;
}

Rows<float> someSlopes(size_t rows) {
  Random random(rows, 6);
  Rows<float> out(Eigen::Index(rows), policy::kPaddedOutputs);
  for (Eigen::Index i = 0; i < out.size(); ++i)
    out.data()[i] = random.below(3) == 0 ? 0 : random.unit() - 0.5f;
  return out;
}

// What learns and what the search runs are the same network: all bits.
TEST(Pass, HasTheOutputsOfTheSearch) {
  const Seen seen(100);
  const policy::Network network = seen.network();
  const policy::Thinker thinker(network);
  const std::vector<uint32_t> which = someRows(150, 100);
  Pass pass;
  const Rows<float>& out = pass.forward(seen.net, seen.part(which));
  ASSERT_EQ(out.rows(), 150);
  for (Eigen::Index r = 0; r < out.rows(); ++r) {
    float expected[policy::kPaddedOutputs];
    policy::think(thinker.view(), seen.raw.row(which[size_t(r)]).data(), expected);
    for (int m = 0; m < policy::kPaddedOutputs; ++m) ASSERT_EQ(out(r, m), expected[m]) << r;
  }
  EXPECT_GT(out.cwiseAbs().maxCoeff(), 0.1f);
}

class PassOf : public testing::TestWithParam<uint32_t> {};

// One row, less than a block, one, more, several.
INSTANTIATE_TEST_SUITE_P(Pass, PassOf, testing::Values(1, 7, 64, 65, 200));

TEST_P(PassOf, HasTheOutputsAndGradientsOfFullRows) {
  const Seen seen(100, 2);
  const std::vector<uint32_t> which = someRows(GetParam(), 100);
  const Rows<double> full = seen.normalised(which);
  const Rows<float> slope = someSlopes(which.size());
  Pass pass;
  Weights<float> sums;
  const Rows<float> out = pass.forward(seen.net, seen.part(which));
  pass.backward(WeightsBack(seen.net), seen.part(which), slope, sums);
  addVoidSlopes(seen.rows, sums);

  const Weights<double> net = asDouble(seen.net);
  FullPass<double> exact;
  Weights<double> expected;
  EXPECT_LT((out.cast<double>() - exact.forward(net, full)).cwiseAbs().maxCoeff(), 2e-5);
  exact.backward(net, full, slope.cast<double>(), expected);
  for (int l = 0; l < 3; ++l) {
    const double largest = expected.w[l].cwiseAbs().maxCoeff();
    EXPECT_GT(largest, 0.05) << l;
    EXPECT_LT((sums.w[l].cast<double>() - expected.w[l]).cwiseAbs().maxCoeff(), 1e-5 * largest)
        << l;
    EXPECT_LT((sums.b[l].cast<double>() - expected.b[l]).cwiseAbs().maxCoeff(), 1e-5 * largest)
        << l;
  }
}

// Of two parts, what those of both together are, also by a pass that had more rows before.
TEST(Pass, GradientsAddUp) {
  const Seen seen(100, 5);
  const std::vector<uint32_t> all = someRows(100, 100);
  const WeightsBack back(seen.net);
  Pass pass;
  const auto gradient = [&](std::span<const uint32_t> which, Weights<float>& sums) {
    const SeenPart part = seen.part(which);
    const Rows<float> slope = pass.forward(seen.net, part);
    pass.backward(back, part, slope, sums);
  };
  Weights<float> whole, parts;
  gradient(all, whole);
  gradient(std::span(all).first(33), parts);
  gradient(std::span(all).subspan(33), parts);
  for (int l = 0; l < 3; ++l) {
    EXPECT_LT((whole.w[l] - parts.w[l]).cwiseAbs().maxCoeff(), 1e-4f) << l;
    EXPECT_GT(whole.w[l].cwiseAbs().maxCoeff(), 0.1f) << l;
  }
}

TEST(SeenRows, ARowTakenAgainForgetsWhatItHad) {
  Seen seen(2);
  seen.rows.take(0, seen.raw.row(1).data());
  const std::vector<uint32_t> both = {0, 1};
  Pass pass;
  const Rows<float>& out = pass.forward(seen.net, seen.part(both));
  EXPECT_EQ(out.row(0), out.row(1));
}

}  // namespace
}  // namespace obby::train
