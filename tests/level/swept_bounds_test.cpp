// Bounds of moving parts equal the bounds over all their rows, bit for bit, however the rows share
// rotations.
#include "level/swept_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"

namespace obby::level {
namespace {

struct SweptBoundsDice {
  Random random;
  float number(float size) { return (2 * random.unit() - 1) * size; }
  Vec3 vec(float size) { return {number(size), number(size), number(size)}; }
  Vec3 half() { return abs(vec(5)) + Vec3{0.025f, 0.025f, 0.025f}; }

  // Returns five rows for each rotation.
  std::vector<Pose> keys() {
    std::vector<Pose> keys;
    Mat3 turned;
    for (int k = 0; k < 20; ++k) {
      if (k % 5 == 0) {
        turned = toMat3(normalize(Quat{number(1), number(1), number(1), 0.1f + random.unit()}));
      }
      keys.push_back({vec(50), turned});
    }
    return keys;
  }
};

void expectSame(const Box& a, const Box& b) {
  EXPECT_TRUE(a.lo == b.lo);
  EXPECT_TRUE(a.hi == b.hi);
}

Box boundsOfAll(const std::vector<Pose>& keys, Vec3 half) {
  Box all = boundsOf(keys[0], half);
  for (const Pose& key : keys) all = join(all, boundsOf(key, half));
  return all;
}

TEST(SweptBounds, EqualTheBoundsOfAllKeys) {
  SweptBoundsDice dice{Random(50, 0)};
  for (int round = 0; round < 100; ++round) {
    const std::vector<Pose> keys = dice.keys();
    const Mover m{keys.data(), nullptr, uint32_t(keys.size()), 0, dice.vec(3), false};
    const Vec3 half = dice.half();
    expectSame(SweptBounds(m).of(half), boundsOfAll(keys, half));
  }
}

// Returns a rotation about a slanting axis, from one side to the other.
std::vector<Pose> longTurn(uint32_t rows) {
  std::vector<Pose> keys;
  for (uint32_t k = 0; k < rows; ++k) {
    const float share = float(k) / float(rows), angle = 4.7f * share;
    const Quat turned{0.5f * std::sin(angle), 0.2f * std::sin(angle), 0, std::cos(angle)};
    keys.push_back({Vec3{40 * share, 5, 30 * std::sin(3 * share)}, toMat3(normalize(turned))});
  }
  return keys;
}

TEST(SweptBounds, EqualTheBoundsOfAllKeysForManyHulls) {
  SweptBoundsDice dice{Random(52, 0)};
  const std::vector<Pose> keys = longTurn(30000);
  const Mover m{keys.data(), nullptr, uint32_t(keys.size()), 0, {}, false};
  const Vec3 half = dice.half();
  expectSame(SweptBounds(m, 500).of(half), boundsOfAll(keys, half));
}

// A scanned mesh spins for twenty minutes. Testing each row with each hull would take minutes.
TEST(SweptBounds, ContainAHundredThousandHullsInLittleTime) {
  SweptBoundsDice dice{Random(53, 0)};
  const std::vector<Pose> keys = longTurn(72000);
  const Mover m{keys.data(), nullptr, uint32_t(keys.size()), 0, {}, false};
  const SweptBounds swept(m, 100000);
  for (int i = 0; i < 100000; ++i) {
    const Vec3 half = dice.half();
    const Box box = swept.of(half);
    if (i % 1000 != 0) continue;
    const Box all = boundsOfAll(keys, half);
    EXPECT_TRUE(min(box.lo, all.lo) == box.lo && max(box.hi, all.hi) == box.hi) << i;
    const Vec3 more = max(all.lo - box.lo, box.hi - all.hi);
    EXPECT_LT(std::max({more.x, more.y, more.z}), 2.0f);
  }
}

TEST(SweptBounds, ContainTheLargestRadiusOfASpin) {
  SweptBoundsDice dice{Random(51, 0)};
  const Mat3 spin{};
  for (int round = 0; round < 100; ++round) {
    const std::vector<Pose> keys = dice.keys();
    const Mover m{keys.data(), &spin, uint32_t(keys.size()), 1, dice.vec(3), false};
    const Vec3 half = dice.half();
    const float radius = length(half) + length(m.pivot);
    const Vec3 r{radius, radius, radius};
    Box all{toWorld(keys[0], m.pivot) - r, toWorld(keys[0], m.pivot) + r};
    for (const Pose& key : keys) {
      const Vec3 pivot = toWorld(key, m.pivot);
      all = join(all, {pivot - r, pivot + r});
    }
    expectSame(SweptBounds(m).of(half), all);
  }
}

}  // namespace
}  // namespace obby::level
