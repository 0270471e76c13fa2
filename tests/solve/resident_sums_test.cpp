// Compares the tree of sums with plain loops, for numbers of leaves near powers of its fan-out.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "base/random.h"
#include "solve/search/resident/sum_tree.h"

namespace obby::solve {
namespace {

struct Sums {
  auto leaf() const {
    return [this](uint32_t n) { return weights[n]; };
  }
  explicit Sums(std::vector<uint64_t> values) : weights(std::move(values)) {
    tree = makeSumTree(nullptr, uint32_t(weights.size()));
    memory.resize(tree.firsts[tree.levels], ~0ull);
    tree.sums = memory.data();
    for (uint32_t i = 0; i < sumCount(tree, 0); ++i) sumLeaves(tree, i, leaf());
    for (uint32_t level = 1; level < tree.levels; ++level) {
      for (uint32_t i = 0; i < sumCount(tree, level); ++i) sumLevel(tree, level, i);
    }
  }
  std::vector<uint64_t> weights, memory;
  SumTree tree;
};

std::vector<uint64_t> randomWeights(uint32_t count, uint32_t max) {
  Random random(3, count);
  std::vector<uint64_t> weights(count);
  for (uint64_t& w : weights) w = random.below(max);
  weights[count / 2] += 1;  // so that the total is above zero
  return weights;
}

TEST(SumTree, SumsBeforeALeafEqualAPlainLoop) {
  for (const uint32_t count : {1u, 2u, 63u, 64u, 65u, 4095u, 4096u, 4097u, 270'000u}) {
    const Sums s(randomWeights(count, 1u << 20));
    uint64_t sum = 0;
    for (uint32_t i = 0; i < count; ++i) {
      if (count < 10'000 || i % 997 == 0 || i + 70 > count) {
        ASSERT_EQ(sumBefore(s.tree, i, s.leaf()), sum) << i << " of " << count;
      }
      sum += s.weights[i];
    }
    EXPECT_EQ(totalOf(s.tree), sum) << count;
  }
}

// A descent with a value below the total ends at the leaf that a plain loop finds. It never ends at
// a leaf of weight 0.
TEST(SumTree, ADescentEndsAtTheLeafOfAPlainLoop) {
  for (const uint32_t count : {1u, 64u, 65u, 4097u, 9000u}) {
    const Sums s(randomWeights(count, 3));
    uint64_t rest = 0;
    for (uint32_t i = 0; i < count; ++i) {
      for (uint64_t k = 0; k < s.weights[i]; ++k) {
        ASSERT_EQ(leafAt(s.tree, rest++, s.leaf()), i) << count << " leaves";
      }
    }
    EXPECT_EQ(rest, totalOf(s.tree));
  }
}

}  // namespace
}  // namespace obby::solve
