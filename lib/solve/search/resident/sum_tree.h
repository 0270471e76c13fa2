// A tree of integer sums with a fan-out of 64. A draw by weight goes down the tree, and the sum
// before a leaf goes up. The tree does not store the leaves. For host and device.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby::solve {

constexpr uint32_t kFan = 64;
constexpr uint32_t kMaxLevels = 5;  // enough for 2^30 leaves

struct SumTree {
  uint64_t* sums = nullptr;              // level by level, sums of leaves first
  uint32_t leaves = 0;                   // at least 1
  uint32_t levels = 0;                   // the last has one sum
  uint32_t firsts[kMaxLevels + 1] = {};  // index into sums of each level's first
};

// `sums` must have as many entries as the tree's last entry of `firsts`.
OBBY_DEVICE SumTree makeSumTree(uint64_t* sums, uint32_t leaves) {
  SumTree t;
  t.sums = sums;
  t.leaves = leaves;
  uint32_t count = leaves;
  do {
    count = (count + kFan - 1) / kFan;
    t.firsts[t.levels + 1] = t.firsts[t.levels] + count;
    ++t.levels;
  } while (count > 1);
  return t;
}

OBBY_DEVICE uint32_t sumCount(const SumTree& t, uint32_t level) {
  return t.firsts[level + 1] - t.firsts[level];
}

OBBY_DEVICE uint64_t totalOf(const SumTree& t) { return t.sums[t.firsts[t.levels - 1]]; }

// Computes sum i of the lowest level. leaf(n) is the weight of leaf n.
template <class Leaf>
OBBY_DEVICE void sumLeaves(const SumTree& t, uint32_t i, Leaf&& leaf) {
  const uint32_t first = i * kFan;
  const uint32_t end = t.leaves - first < kFan ? t.leaves : first + kFan;
  uint64_t sum = 0;
  for (uint32_t n = first; n < end; ++n) sum += leaf(n);
  t.sums[i] = sum;
}

// Computes sum i of a higher level. The level below must be done.
OBBY_DEVICE void sumLevel(const SumTree& t, uint32_t level, uint32_t i) {
  const uint64_t* const below = t.sums + t.firsts[level - 1];
  const uint32_t first = i * kFan, count = sumCount(t, level - 1);
  const uint32_t end = count - first < kFan ? count : first + kFan;
  uint64_t sum = 0;
  for (uint32_t n = first; n < end; ++n) sum += below[n];
  t.sums[t.firsts[level] + i] = sum;
}

// Returns the leaf at which the running sum of the weights exceeds `rest`, which must be below the
// total.
template <class Leaf>
OBBY_DEVICE uint32_t leafAt(const SumTree& t, uint64_t rest, Leaf&& leaf) {
  uint32_t at = 0;
  for (uint32_t level = t.levels - 1; level > 0; --level) {
    const uint64_t* const sums = t.sums + t.firsts[level - 1];
    at *= kFan;
    for (; rest >= sums[at]; ++at) rest -= sums[at];
  }
  for (at *= kFan;; ++at) {
    const uint64_t weight = leaf(at);
    if (rest < weight) return at;
    rest -= weight;
  }
}

// Returns the sum of the weights before a leaf.
template <class Leaf>
OBBY_DEVICE uint64_t sumBefore(const SumTree& t, uint32_t at, Leaf&& leaf) {
  uint64_t sum = 0;
  for (uint32_t n = at / kFan * kFan; n < at; ++n) sum += leaf(n);
  for (uint32_t level = 0; level + 1 < t.levels; ++level) {
    at /= kFan;
    const uint64_t* const sums = t.sums + t.firsts[level];
    for (uint32_t n = at / kFan * kFan; n < at; ++n) sum += sums[n];
  }
  return sum;
}

}  // namespace obby::solve
