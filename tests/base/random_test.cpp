// Counter-based random numbers are uniform, pure functions of (seed, stream, index), the same on
// every machine.
#include "base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace obby {
namespace {

std::vector<uint32_t> draw(Random random, int count) {
  std::vector<uint32_t> out;
  for (int i = 0; i < count; ++i) out.push_back(random.next());
  return out;
}

TEST(Random, StartsWithThePublishedPhiloxNumbers) {
  // Known answer of Random123 for philox4x32-10 with counter 0 and key 0.
  EXPECT_EQ(draw(Random(0, 0), 4),
            (std::vector<uint32_t>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(Random, SameSeedAndStreamGiveTheSameNumbers) {
  for (uint64_t seed : {0ull, 1ull, 0x123456789abcdef0ull, ~0ull}) {
    for (uint64_t stream : {0ull, 7ull, 0xffffffff00000000ull}) {
      EXPECT_EQ(draw(Random(seed, stream), 100), draw(Random(seed, stream), 100));
    }
  }
}

TEST(Random, EveryBitOfSeedAndStreamMatters) {
  std::set<std::vector<uint32_t>> seen{draw(Random(0, 0), 4)};
  for (int bit = 0; bit < 64; ++bit) {
    EXPECT_TRUE(seen.insert(draw(Random(1ull << bit, 0), 4)).second) << "seed bit " << bit;
    EXPECT_TRUE(seen.insert(draw(Random(0, 1ull << bit), 4)).second) << "stream bit " << bit;
  }
}

TEST(Random, ACopyForksTheSequence) {
  Random a(3, 4);
  for (int i = 0; i < 5; ++i) a.next();  // stops in the middle of a block
  EXPECT_EQ(draw(a, 20), draw(Random(a), 20));
}

TEST(Random, BelowStaysInRangeAndIsUniform) {
  Random random(11, 0);
  for (const uint32_t n : {1u, 2u, 3u, 10u, 0x80000001u, 0xffffffffu}) {
    for (int i = 0; i < 2000; ++i) ASSERT_LT(random.below(n), n);
  }
  std::array<int, 12> bins{};
  constexpr int kDraws = 120000;
  for (int i = 0; i < kDraws; ++i) ++bins[random.below(12)];
  double chi2 = 0;
  for (const int n : bins) chi2 += (n - 10000.0) * (n - 10000.0) / 10000.0;
  EXPECT_LT(chi2, 31.3);  // the 99.9 % quantile for 11 degrees of freedom; the draws are fixed
}

TEST(Random, UnitIsIn0To1AndUniform) {
  Random random(12, 1);
  double sum = 0, sum2 = 0;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const float u = random.unit();
    ASSERT_GE(u, 0.0f);
    ASSERT_LT(u, 1.0f);
    ASSERT_EQ(u * 0x1p24f, float(uint32_t(u * 0x1p24f)));  // a multiple of 2^-24
    sum += double(u);
    sum2 += double(u) * double(u);
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.003);
  EXPECT_NEAR(sum2 / kDraws, 1.0 / 3, 0.003);
}

TEST(Random, NeighbouringStreamsAreIndependent) {
  int equalBits = 0;
  constexpr int kStreams = 1000;
  for (uint64_t s = 0; s < kStreams; ++s) {
    equalBits += __builtin_popcount(~(Random(5, s).next() ^ Random(5, s + 1).next()));
  }
  EXPECT_NEAR(double(equalBits) / (32 * kStreams), 0.5, 0.02);
}

}  // namespace
}  // namespace obby
