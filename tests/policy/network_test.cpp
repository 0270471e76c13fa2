// Compares the network with a simple one in double precision. Tests moves drawn from its outputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "support/level_builder.h"
#include "support/onlooker.h"

namespace obby::policy {
namespace {

using support::LevelBuilder, support::Onlooker;

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
  // Most heights in the surroundings are empty.
  for (size_t i = kStateInputs; i < in.size(); ++i) {
    if (random.unit() < 0.7f) in[i] = kEmptyInput;
  }
  return in;
}

// Computes the outputs from every input, with the weights in the order of the file.
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

TEST(Network, EqualsASimpleOneInDoublePrecision) {
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

TEST(Network, IsBitIdenticalInOneLaneAndInMany) {
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

TEST(Moves, AreDrawnWithTheProbabilitiesOfTheirLogits) {
  float logits[kMoves] = {};
  logits[4] = std::log(3.0f);
  logits[7] = 9;  // jumps
  Random random(5, 5);
  int count[kMoves] = {};
  for (int i = 0; i < 38000; ++i) ++count[draw<float>(logits, false, random)];
  for (int m = 1; m < kMoves; m += 2) EXPECT_EQ(count[m], 0) << "jumping is not allowed";
  EXPECT_NEAR(count[4], 6000, 300);  // 3 of 19
  EXPECT_NEAR(count[32], 2000, 200);
  EXPECT_EQ(likeliest(logits, false), 4);
  EXPECT_EQ(likeliest(logits, true), 7);
}

// Returns logits as networks do, and unusual ones: equal ones, zeros of either sign, some or all
// far below the others, NaN.
std::vector<float> someLogits(Random& random) {
  const float spread = float(1u << random.below(9));
  const bool areLow = random.below(8) == 0;
  std::vector<float> logits(kMoves);
  for (size_t m = 0; m < logits.size(); ++m) {
    logits[m] = areLow ? -2e30f : spread * (random.unit() - 0.5f);
    const uint32_t kind = random.below(12);
    if (kind < 3) logits[m] = std::round(logits[m]);
    if (kind == 3) logits[m] = -3e38f;
    if (kind == 4 && m > 0) logits[m] = NAN;
  }
  return logits;
}

// Does the same as draw(), but one move at a time.
int drawPlainly(const std::vector<float>& logits, bool mayJump, Random& random) {
  const float max = logits[size_t(likeliest(logits.data(), mayJump))];
  float odds[kMoves], sum = 0;
  for (int m = 0; m < kMoves; ++m) {
    odds[m] = isAllowed(m, mayJump) ? expNegative(logits[size_t(m)] - max) : 0.0f;
    sum += odds[m];
  }
  float rest = random.unit() * sum;
  int last = 0;
  for (int m = 0; m < kMoves && !(rest < 0); ++m) {
    if (!isAllowed(m, mayJump)) continue;
    last = m;
    rest -= odds[m];
  }
  return last;
}

TEST(Moves, DrawingInLanesEqualsOneAfterTheOther) {
  Random random(6, 6);
  int others = 0;
  for (int n = 0; n < 20000; ++n) {
    const std::vector<float> logits = someLogits(random);
    for (const bool mayJump : {false, true}) {
      Random is = random, expected = random;
      const int move = draw<float>(logits.data(), mayJump, is);
      ASSERT_EQ(move, drawPlainly(logits, mayJump, expected)) << n;
      ASSERT_EQ(is.next(), expected.next()) << "the same count of random numbers";
      others += move != likeliest(logits.data(), mayJump);
    }
  }
  EXPECT_GT(others, 5000) << "not always the most likely move";
}

bool same(const sim::Action& a, const sim::Action& b) {
  return a.heading == b.heading && a.walk == b.walk && a.jump == b.jump;
}

TEST(Moves, AreTheSameInOneLaneAndInMany) {
  const level::Level level = LevelBuilder().block({0, -0.5f, 0}, {8, 1, 8}).compile();
  Onlooker look(level);
  Network network;  // its outputs are always its last biases
  const Thinker thinker(network);
  const std::vector<float> inputs(kInputs);
  Random random(7, 7);
  for (int n = 0; n < 20000; ++n) {
    const std::vector<float> logits = someLogits(random);
    std::copy(logits.begin(), logits.end(), network.numbers().end() - kPaddedOutputs);
    const bool mayJump = n % 2 == 0;
    look.world.state = mayJump ? sim::State::climbing : sim::State::freefall;
    ASSERT_EQ(jumpAllowed(look.scene, look.world), mayJump);
    const Turns ahead = Turns(random.next());
    Random narrow = random, wide = random;
    const sim::Action expected = actionOf(draw<float>(logits.data(), mayJump, narrow), ahead);
    const sim::Action is =
        decideOn(look.scene, thinker.view(), look.world, inputs.data(), ahead, &wide);
    ASSERT_TRUE(same(is, expected)) << n;
    ASSERT_EQ(wide.next(), narrow.next()) << "the same count of random numbers";
  }
}

// The player is anywhere in a level, in the air or not, and moves are sampled or greedy.
TEST(Decisions, AreTheSameInOneLaneAndInMany) {
  const level::Level level = support::boxArena(100, 3).compile();
  Onlooker look(level);
  const Network network = randomNetwork(5);
  const Thinker thinker(network);
  Random random(8, 8);
  int jumping = 0;
  for (int n = 0; n < 500; ++n) {
    look.world.position = {40 * random.unit() - 20, 8 * random.unit(), 40 * random.unit() - 20};
    look.world.velocity = {random.unit(), random.unit(), random.unit()};
    look.world.yaw = Turns(random.next());
    look.world.state = n % 3 == 0 ? sim::State::freefall : sim::State::running;
    look.world.floorlessSteps = 0;
    for (const bool draws : {false, true}) {
      Random one = random, many = random;
      const sim::Action narrow =
          decide<float>(look.scene, thinker.view(), look.world, nullptr, draws ? &one : nullptr);
      const sim::Action wide =
          decide(look.scene, thinker.view(), look.world, nullptr, draws ? &many : nullptr);
      ASSERT_TRUE(same(wide, narrow)) << n;
      ASSERT_EQ(many.next(), one.next()) << "the same count of random numbers";
      jumping += draws && wide.jump;
    }
  }
  EXPECT_GT(jumping, 50);
}

TEST(Moves, MapToHeadingsInTheFrame) {
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
