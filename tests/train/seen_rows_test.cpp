// Rows that are lists of what is seen, held against the same rows in full.
#include "train/seen_rows.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/random.h"

namespace obby::train {
namespace {

const float kEmpty = policy::scaledHeight(policy::kDeepest);

// Observations, raw: states, and maps of which one height in three is not empty.
struct Seen {
  std::vector<float> means, scales;
  Rows<float> raw, full;  // full: normalised
  SeenRows rows;

  explicit Seen(uint32_t count, uint64_t seed = 1)
      : means(policy::kInputs),
        scales(policy::kInputs),
        raw(count, policy::kInputs),
        full(count, policy::kInputs),
        rows(count) {
    Random random(seed, 0);
    for (size_t i = 0; i < means.size(); ++i) {
      means[i] = 2 * random.unit() - 1;
      scales[i] = 0.2f + 4 * random.unit();
    }
    scales[40] = 0;  // hidden
    rows.normaliseBy(means, scales);
    for (Eigen::Index r = 0; r < raw.rows(); ++r) {
      for (int i = 0; i < policy::kInputs; ++i) {
        const bool empty = i >= policy::kStateInputs && random.below(3) != 0;
        raw(r, i) = empty ? kEmpty : 3 * random.unit() - 1.9f;
        full(r, i) = policy::normalised(raw(r, i), means[size_t(i)], scales[size_t(i)]);
      }
      rows.take(size_t(r), raw.row(r).data());
    }
  }
};

Weights<float> someWeights(uint64_t seed) {
  Random random(seed, 1);
  Weights<float> net;
  net.blocks([&](float* w, size_t count) {
    for (size_t i = 0; i < count; ++i) w[i] = 0.3f * (random.unit() - 0.5f);
  });
  return net;
}

TEST(SeenRows, InFullAreTheNormalisedInputs) {
  const Seen seen(50);
  for (Eigen::Index r = 0; r < seen.full.rows(); ++r) {
    float out[policy::kInputs];
    seen.rows.expand(size_t(r), out);
    for (int i = 0; i < policy::kInputs; ++i) ASSERT_NEAR(out[i], seen.full(r, i), 2e-6f) << i;
  }
}

TEST(SeenRows, ARowTakenAgainForgetsWhatItHad) {
  Seen seen(2);
  seen.rows.take(0, seen.raw.row(1).data());
  float out[policy::kInputs], other[policy::kInputs];
  seen.rows.expand(0, out);
  seen.rows.expand(1, other);
  for (int i = 0; i < policy::kInputs; ++i) ASSERT_EQ(out[i], other[i]);
}

// Any rows in any order.
TEST(SeenRows, GiveOutputsAndGradientsOfFullRows) {
  const Seen seen(64, 2);
  const Weights<float> net = someWeights(3);
  const std::vector<uint32_t> which = {5, 63, 0, 17, 5, 40, 8};
  const auto count = Eigen::Index(which.size());
  Rows<float> full(count, policy::kInputs), slope(count, policy::kPaddedOutputs);
  Random random(4, 4);
  for (Eigen::Index i = 0; i < slope.size(); ++i) slope.data()[i] = random.unit() - 0.5f;
  for (Eigen::Index i = 0; i < count; ++i)
    full.row(i) = seen.full.row(Eigen::Index(which[size_t(i)]));

  const Line<float> begin = voidSums(seen.rows, net);
  const SeenPart part(seen.rows, which, begin);
  Pass<float> pass, fullPass;
  const Rows<float>& out = pass.forward(net, part);
  const Rows<float>& expected = fullPass.forward(net, FullRows(full));
  ASSERT_EQ(out.rows(), count);
  EXPECT_LT((out - expected).cwiseAbs().maxCoeff(), 2e-5f);
  EXPECT_GT(expected.cwiseAbs().maxCoeff(), 0.1f);

  Weights<float> sums, fullSums;
  pass.backward(net, part, slope, sums);
  addVoidSlopes(seen.rows, sums);
  fullPass.backward(net, FullRows(full), slope, fullSums);
  for (int l = 0; l < 3; ++l) {
    EXPECT_LT((sums.w[l] - fullSums.w[l]).cwiseAbs().maxCoeff(), 1e-4f) << l;
    EXPECT_LT((sums.b[l] - fullSums.b[l]).cwiseAbs().maxCoeff(), 1e-5f) << l;
    EXPECT_GT(fullSums.w[l].cwiseAbs().maxCoeff(), 0.1f) << l;
  }
}

// Gradients add up: of two parts, what those of both together are.
TEST(SeenRows, PartsAddUp) {
  const Seen seen(40, 5);
  const Weights<float> net = someWeights(6);
  const Line<float> begin = voidSums(seen.rows, net);
  std::vector<uint32_t> all(40);
  std::iota(all.begin(), all.end(), 0u);
  const auto gradient = [&](std::span<const uint32_t> which, Weights<float>& sums) {
    Pass<float> pass;
    const SeenPart part(seen.rows, which, begin);
    const Rows<float> slope = pass.forward(net, part);
    pass.backward(net, part, slope, sums);
  };
  Weights<float> whole, parts;
  gradient(all, whole);
  gradient(std::span(all).first(13), parts);
  gradient(std::span(all).subspan(13), parts);
  EXPECT_LT((whole.w[0] - parts.w[0]).cwiseAbs().maxCoeff(), 1e-4f);
  EXPECT_GT(whole.w[0].cwiseAbs().maxCoeff(), 0.1f);
}

}  // namespace
}  // namespace obby::train
