// Bounds of what moves are those of all its rows, to the bit, however rows share their rotation.
#include "level/swept_bounds.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.h"

namespace obby::level {
namespace {

struct Dice {
  Random random;
  float number(float size) { return (2 * random.unit() - 1) * size; }
  Vec3 vec(float size) { return {number(size), number(size), number(size)}; }
  Vec3 half() { return abs(vec(5)) + Vec3{0.025f, 0.025f, 0.025f}; }

  // Five rows with each rotation.
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

TEST(SweptBounds, AreThoseOfAllKeys) {
  Dice dice{Random(50, 0)};
  for (int round = 0; round < 100; ++round) {
    const std::vector<Pose> keys = dice.keys();
    const Mover m{keys.data(), nullptr, uint32_t(keys.size()), 0, dice.vec(3), false};
    const Vec3 half = dice.half();
    Box all = boundsOf(keys[0], half);
    for (const Pose& key : keys) all = join(all, boundsOf(key, half));
    expectSame(SweptBounds(m).of(half), all);
  }
}

TEST(SweptBounds, OfWhatSpinsHoldItsLargestRadius) {
  Dice dice{Random(51, 0)};
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
