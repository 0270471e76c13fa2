// A shuffle contains every index once, in an order without visible structure.
#include "base/shuffle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace obby {
namespace {

TEST(Shuffle, ContainsEveryIndexOnce) {
  for (const uint32_t count : {1u, 2u, 3u, 4u, 5u, 17u, 64u, 65u, 1000u, 4096u, 70'001u}) {
    const Shuffle shuffle(7, count, count);
    std::vector<int> seen(count);
    for (uint32_t i = 0; i < count; ++i) {
      ASSERT_LT(shuffle(i), count);
      ++seen[shuffle(i)];
    }
    for (uint32_t i = 0; i < count; ++i) EXPECT_EQ(seen[i], 1) << i << " of " << count;
  }
}

TEST(Shuffle, DiffersForAnotherStreamOrSeed) {
  const Shuffle a(1, 1, 1000), b(1, 2, 1000), c(2, 1, 1000);
  int likeB = 0, likeC = 0;
  for (uint32_t i = 0; i < 1000; ++i) {
    likeB += a(i) == b(i);
    likeC += a(i) == c(i);
  }
  EXPECT_LT(likeB, 10);
  EXPECT_LT(likeC, 10);
}

// The first part of a shuffle covers all indices evenly, and neighbours move apart.
TEST(Shuffle, HasNoVisibleStructure) {
  constexpr uint32_t kCount = 65'536, kPart = 4096, kBins = 16;
  double worst = 0;
  int close = 0;
  for (uint64_t stream = 0; stream < 20; ++stream) {
    const Shuffle shuffle(3, stream, kCount);
    int bins[kBins] = {};
    for (uint32_t i = 0; i < kPart; ++i) {
      ++bins[shuffle(i) / (kCount / kBins)];
      const int64_t apart = int64_t(shuffle(i)) - int64_t(shuffle(i + 1));
      close += std::abs(apart) <= 16;
    }
    for (const int n : bins) worst = std::max(worst, std::abs(n - double(kPart) / kBins));
  }
  EXPECT_LT(worst, 80) << "five deviations of 15.5";
  // A pair is this close with probability 32 / 65,536. Of 20 x 4096 pairs, 40 are expected to be.
  EXPECT_LT(close, 80);
  EXPECT_GT(close, 10);
}

}  // namespace
}  // namespace obby
