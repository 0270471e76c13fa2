// Every operation of WideFloat, WideInt and WideMask equals the scalar one, bit for bit in each
// lane.
#include "simd/wide.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>

#include "base/random.h"
#include "math/angle.h"
#include "math/exponential.h"
#include "simd/rows.h"

namespace obby {
namespace {

using Floats = std::array<float, size_t(kLanes)>;
using Ints = std::array<int32_t, size_t(kLanes)>;

Floats valuesOf(WideFloat v) {
  Floats out;
  store(v, out.data());
  return out;
}
Ints valuesOf(WideInt v) {
  Ints out;
  store(v, out.data());
  return out;
}

uint32_t bitsOfFloat(float v) {
  uint32_t bits;
  std::memcpy(&bits, &v, sizeof bits);
  return bits;
}
bool same(float a, float b) { return bitsOfFloat(a) == bitsOfFloat(b); }
bool same(int32_t a, int32_t b) { return a == b; }

// Draws two sets of operands per round: usual numbers, and sometimes zeros, equal numbers and huge
// ones.
class Wide : public testing::Test {
 protected:
  float number() {
    switch (random_.below(12)) {
      case 0: return 0;
      case 1: return -0.0f;
      case 2: return 1e30f;
      case 3: return 1;
      default: return (random_.unit() - 0.5f) * 200;
    }
  }
  void draw() {
    for (size_t k = 0; k < size_t(kLanes); ++k) {
      a[k] = number();
      b[k] = random_.below(4) == 0 ? a[k] : number();
      i[k] = int32_t(random_.next());
      j[k] = random_.below(4) == 0 ? i[k] : int32_t(random_.below(100)) - 50;
    }
    wa = load(a.data());
    wb = load(b.data());
    wi = load(i.data());
    wj = load(j.data());
  }
  template <class Result, class Each>
  void expect(Result wide, Each&& each) {
    const auto got = valuesOf(wide);
    for (size_t k = 0; k < size_t(kLanes); ++k) {
      ASSERT_TRUE(same(got[k], each(k))) << "lane " << k << ": " << got[k] << ", " << each(k);
    }
  }
  template <class Each>
  void expectMask(WideMask wide, Each&& each) {
    uint32_t bits = 0;
    for (size_t k = 0; k < size_t(kLanes); ++k) bits |= uint32_t(each(k)) << k;
    ASSERT_EQ(bitsOf(wide), bits);
    ASSERT_EQ(any(wide), bits != 0);
    ASSERT_EQ(all(wide), bits == (uint64_t(1) << kLanes) - 1);
    expect(select(wide, wa, wb), [&](size_t k) { return each(k) ? a[k] : b[k]; });
    expect(select(wide, wi, wj), [&](size_t k) { return each(k) ? i[k] : j[k]; });
  }

  Random random_{1, 0};
  Floats a, b;
  Ints i, j;
  WideFloat wa, wb;
  WideInt wi, wj;
};

TEST_F(Wide, ArithmeticIsTheScalarOne) {
  for (int round = 0; round < 500; ++round) {
    draw();
    expect(wa + wb, [&](size_t k) { return a[k] + b[k]; });
    expect(wa - wb, [&](size_t k) { return a[k] - b[k]; });
    expect(wa * wb, [&](size_t k) { return a[k] * b[k]; });
    expect(wa / (wb * wb + 1.0f), [&](size_t k) { return a[k] / (b[k] * b[k] + 1.0f); });
    expect(-wa, [&](size_t k) { return -a[k]; });
    expect(absf(wa), [&](size_t k) { return absf(a[k]); });
    expect(sqrtf32(absf(wa)), [&](size_t k) { return sqrtf32(absf(a[k])); });
    expect(minf(wa, wb), [&](size_t k) { return minf(a[k], b[k]); });
    expect(maxf(wa, wb), [&](size_t k) { return maxf(a[k], b[k]); });
    const WideFloat small = clampf<WideFloat>(wa, -1e6f, 1e6f);
    expect(toInt(small), [&](size_t k) { return toInt(clampf(a[k], -1e6f, 1e6f)); });
    expect(toFloat(wi), [&](size_t k) { return toFloat(i[k]); });
    expect(wj + wj, [&](size_t k) { return j[k] + j[k]; });
    expect(wj - WideInt(7), [&](size_t k) { return j[k] - 7; });
    expect(wj * wj, [&](size_t k) { return j[k] * j[k]; });
    expect(wi & wj, [&](size_t k) { return i[k] & j[k]; });
    expect(wi | wj, [&](size_t k) { return i[k] | j[k]; });
    expect(wi >> 5, [&](size_t k) { return i[k] >> 5; });
    expect((wj & 0xff) << 16, [&](size_t k) { return (j[k] & 0xff) << 16; });
    expect(bitsOf(wa), [&](size_t k) { return int32_t(bitsOfFloat(a[k])); });
    expect(floatOfBits(bitsOf(wa)), [&](size_t k) { return a[k]; });
  }
}

// Compares every ordered pair of special values.
TEST_F(Wide, MinAndMaxAreTheScalarOnesForSpecialValues) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const float odd[] = {kNaN, kInfinity, -kInfinity, 0.0f, -0.0f, 1e-40f, 1.0f};
  for (const float x : odd) {
    for (const float y : odd) {
      a.fill(x);
      b.fill(y);
      wa = load(a.data());
      wb = load(b.data());
      expect(minf(wa, wb), [&](size_t k) { return minf(a[k], b[k]); });
      expect(maxf(wa, wb), [&](size_t k) { return maxf(a[k], b[k]); });
    }
  }
}

TEST_F(Wide, ComparisonsMasksAndSelectionAreTheScalarOnes) {
  for (int round = 0; round < 500; ++round) {
    draw();
    expectMask(wa < wb, [&](size_t k) { return a[k] < b[k]; });
    expectMask(wa > wb, [&](size_t k) { return a[k] > b[k]; });
    expectMask(wa <= wb, [&](size_t k) { return a[k] <= b[k]; });
    expectMask(wa >= wb, [&](size_t k) { return a[k] >= b[k]; });
    expectMask(wa == wb, [&](size_t k) { return a[k] == b[k]; });
    expectMask(wa != wb, [&](size_t k) { return a[k] != b[k]; });
    expectMask(wi < wj, [&](size_t k) { return i[k] < j[k]; });
    expectMask(wi > wj, [&](size_t k) { return i[k] > j[k]; });
    expectMask(wi <= wj, [&](size_t k) { return i[k] <= j[k]; });
    expectMask(wi >= wj, [&](size_t k) { return i[k] >= j[k]; });
    expectMask(wi == wj, [&](size_t k) { return i[k] == j[k]; });
    expectMask(wi != wj, [&](size_t k) { return i[k] != j[k]; });
    expectMask((wa < wb) & (wi < wj), [&](size_t k) { return a[k] < b[k] && i[k] < j[k]; });
    expectMask((wa < wb) | (wi < wj), [&](size_t k) { return a[k] < b[k] || i[k] < j[k]; });
    expectMask(!(wa < wb), [&](size_t k) { return !(a[k] < b[k]); });
  }
  expectMask(WideMask(true), [](size_t) { return true; });
  expectMask(WideMask(), [](size_t) { return false; });
}

TEST_F(Wide, Gathers) {
  draw();
  Ints reversed;
  for (int k = 0; k < kLanes; ++k) reversed[size_t(k)] = kLanes - 1 - k;
  const auto mirror = [](size_t k) { return size_t(kLanes) - 1 - k; };
  expect(gather(a.data(), reversed.data()), [&](size_t k) { return a[mirror(k)]; });
}

TEST_F(Wide, SelectedLanesAreStoredContiguously) {
  draw();
  for (uint32_t chosen : {0u, 1u, 0x9au, 0x5e31u, 0xffffu}) {
    chosen &= (uint64_t(1) << kLanes) - 1;
    Floats out;
    storeChosen(wa, chosen, out.data());
    const float* next = out.data();
    for (size_t k = 0; k < size_t(kLanes); ++k) {
      if ((chosen >> k & 1) == 0) continue;
      EXPECT_EQ(*next++, a[k]);
    }
  }
}

TEST_F(Wide, RowsBecomeWordsAndRowsAgain) {
  int32_t rows[kLanes][kRowWords], back[kLanes][kRowWords] = {};
  const void* from[kLanes];
  void* to[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int w = 0; w < kRowWords; ++w) rows[lane][w] = 100 * lane + w;
    from[lane] = rows[lane];
    to[lane] = back[kLanes - 1 - lane];
  }
  const Rows words = loadRows(from);
  for (int w = 0; w < kRowWords; ++w) {
    expect(words.word[w], [&](size_t k) { return rows[k][w]; });
  }
  storeRows(words, to);
  for (int lane = 0; lane < kLanes; ++lane) {
    EXPECT_EQ(std::memcmp(back[kLanes - 1 - lane], rows[lane], sizeof rows[lane]), 0);
  }
}

TEST_F(Wide, SineAndCosineOfEveryAngle) {
  for (int32_t angle = 0; angle < 65536; angle += kLanes) {
    for (int k = 0; k < kLanes; ++k) i[size_t(k)] = angle + k;
    const SinCosT<WideFloat> both = sinCosOf<WideFloat>(load(i.data()));
    expect(both.sin, [&](size_t k) { return sinCos(Turns(i[k])).sin; });
    expect(both.cos, [&](size_t k) { return sinCos(Turns(i[k])).cos; });
  }
}

TEST_F(Wide, ExponentialOfEveryLane) {
  for (int round = 0; round < 500; ++round) {
    draw();
    expect(expOfNegative<WideFloat>(-absf(wa)), [&](size_t k) { return expNegative(-absf(a[k])); });
  }
  a.fill(std::numeric_limits<float>::quiet_NaN());
  expect(expOfNegative<WideFloat>(load(a.data())), [](size_t) { return 0.0f; });
}

}  // namespace
}  // namespace obby
