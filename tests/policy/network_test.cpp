// The network against a plain one in double precision, and what becomes of its answers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "policy/policy.h"

namespace obby::policy {
namespace {

Network randomNetwork(uint64_t seed) {
  Network n;
  Random random(seed, 0);
  for (float& v : n.numbers()) v = 0.4f * (random.unit() - 0.5f);
  for (int i = 0; i < kInputs; ++i) n.numbers()[size_t(kInputs + i)] = 0.5f + random.unit();
  return n;
}

std::vector<float> randomInputs(uint64_t seed) {
  std::vector<float> in(kInputs);
  Random random(seed, 1);
  for (float& v : in) v = 4 * random.unit() - 2;
  // Most of what is around is void.
  for (size_t i = kStateInputs; i < in.size(); ++i) {
    if (random.unit() < 0.7f) in[i] = kEmptyInput;
  }
  return in;
}

// Every input counts, in the order of the file.
std::vector<double> plain(const Network& n, const std::vector<float>& in) {
  const float* const means = n.numbers().data();
  const float* const scales = means + kInputs;
  const float* weights = scales + kInputs;
  std::vector<double> x;
  for (int i = 0; i < kInputs; ++i) x.push_back(normalised(in[size_t(i)], means[i], scales[i]));
  for (const size_t width : {kHidden, kHidden, kPaddedOutputs}) {
    const float* const biases = weights + x.size() * width;
    std::vector<double> y;
    for (size_t o = 0; o < width; ++o) {
      double sum = biases[o];
      for (size_t i = 0; i < x.size(); ++i) sum += double(weights[i * width + o]) * x[i];
      y.push_back(width == kHidden ? std::max(sum, 0.0) : sum);
    }
    weights = biases + width;
    x = y;
  }
  return x;
}

TEST(Network, IsTheOneInDoublePrecision) {
  const Network n = randomNetwork(3);
  const Thinker thinker(n);
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<float> in = randomInputs(seed);
    float out[kPaddedOutputs];
    think(thinker.view(), in.data(), out);
    const std::vector<double> expected = plain(n, in);
    for (int o = 0; o < kPaddedOutputs; ++o) EXPECT_NEAR(out[o], expected[size_t(o)], 2e-4) << o;
  }
}

TEST(Network, HasTheSameBitsInOneLaneAndInMany) {
  const Network n = randomNetwork(4);
  const Thinker thinker(n);
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<float> in = randomInputs(seed);
    float wide[kPaddedOutputs], narrow[kPaddedOutputs];
    think(thinker.view(), in.data(), wide);
    think<float>(thinker.view(), in.data(), narrow);
    EXPECT_EQ(std::memcmp(wide, narrow, sizeof wide), 0);
  }
}

TEST(Moves, AreDrawnAsTheirLogitsSay) {
  float logits[kMoves] = {};
  logits[4] = std::log(3.0f);
  logits[7] = 9;  // jumps
  Random random(5, 5);
  int count[kMoves] = {};
  for (int i = 0; i < 38000; ++i) ++count[draw(logits, false, random)];
  for (int m = 1; m < kMoves; m += 2) EXPECT_EQ(count[m], 0) << "jumping is not allowed";
  EXPECT_NEAR(count[4], 6000, 300);  // 3 of 19
  EXPECT_NEAR(count[32], 2000, 200);
  EXPECT_EQ(likeliest(logits, false), 4);
  EXPECT_EQ(likeliest(logits, true), 7);
}

TEST(Moves, AreHeadingsInTheFrame) {
  EXPECT_EQ(actionOf(0, 1000).heading, 1000);
  EXPECT_TRUE(actionOf(0, 1000).walk);
  EXPECT_FALSE(actionOf(0, 1000).jump);
  EXPECT_EQ(actionOf(9, 1000).heading, 1000 + 4 * 4096);
  EXPECT_TRUE(actionOf(9, 1000).jump);
  EXPECT_FALSE(actionOf(33, 1000).walk);
  EXPECT_TRUE(actionOf(33, 1000).jump);
}

}  // namespace
}  // namespace obby::policy
