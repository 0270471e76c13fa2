// Sums over a layer's units, vectorised, and sparse products by bit masks: the core of learning on
// the CPU. Host only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/bits.h"
#include "simd/wide.h"

namespace obby::nn {

// Sums of kUnits units, in registers. Products are added unfused, so that the sums are the same for
// any lane width.
template <int kUnits>
struct UnitSums {
  static constexpr int kGroups = kUnits / kLanes;
  static_assert(kUnits % kLanes == 0);

  WideFloat group[kGroups];

  // The pragma unrolls the loop, since -O2 would otherwise keep the sums in memory.
  template <class Visit>
  OBBY_LANES static void forGroups(Visit&& visit) {
#pragma GCC unroll 16
    for (int g = 0; g < kGroups; ++g) visit(g);
  }

  OBBY_LANES explicit UnitSums(const float* from) {
    forGroups([&](int g) OBBY_INLINED { group[g] = load(from + g * kLanes); });
  }
  OBBY_LANES void add(const float* row) {
    forGroups([&](int g) OBBY_INLINED { group[g] = group[g] + load(row + g * kLanes); });
  }
  OBBY_LANES void add(const float* row, float times) {
    const WideFloat all(times);
    forGroups([&](int g) OBBY_INLINED { group[g] = group[g] + load(row + g * kLanes) * all; });
  }
  OBBY_LANES void rectify() {
    forGroups([&](int g) OBBY_INLINED { group[g] = maxf(group[g], WideFloat(0.0f)); });
  }
  // Sets the units to 0 that are off in `row`.
  OBBY_LANES void stopWhereOff(const float* row) {
    const WideFloat zero(0.0f);
    forGroups([&](int g) OBBY_INLINED {
      group[g] = select(load(row + g * kLanes) > zero, group[g], zero);
    });
  }
  OBBY_LANES void put(float* to) const {
    forGroups([&](int g) OBBY_INLINED { store(group[g], to + g * kLanes); });
  }
};

constexpr size_t kWord = 64;      // numbers with one bit each in a word
constexpr size_t kRowBlock = 64;  // rows whose gradients are summed in registers

// Returns a mask of the numbers that are not zero, for up to kWord of them.
OBBY_LANES uint64_t nonZero(const float* row, size_t count) {
  uint64_t bits = 0;
  if (count == kWord) {
    for (size_t i = 0; i < kWord; i += kLanes)
      bits |= uint64_t(bitsOf(load(row + i) != WideFloat(0.0f))) << i;
    return bits;
  }
  for (size_t i = 0; i < count; ++i) bits |= uint64_t(row[i] != 0) << i;
  return bits;
}

// Calls visit(index) for each set bit, from the lowest.
template <class Visit>
OBBY_LANES void forBits(uint64_t bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(lowestBit(bits));
}

// Transposes a 64 x 64 bit matrix by swapping blocks of 32, 16, ... 1.
inline void transpose(uint64_t words[64]) {
  uint64_t mask = 0xffffffffu;
  for (int size = 32; size != 0; size /= 2, mask ^= mask << size) {
    for (int i = 0; i < 64; i = (i + size + 1) & ~size) {
      const uint64_t swap = (words[i] >> size ^ words[i + size]) & mask;
      words[i] ^= swap << size;
      words[i + size] ^= swap;
    }
  }
}

// Requirements on Rows. `bits(r, w)` is the mask of non-zero inputs of row r in word w. `cursor(r,
// w)` returns their values in order, one per call, and is passed to `end(r, cursor)` after that.
// `value(r, w, bit)` returns a single value. Widths may be std::integral_constant.

// out = begin + rows x b, (count, columns), for the first kUnits columns. `finish(r, sums)` makes
// the last change to a row. The outer loop is over words, so that a word's weights stay in the L1
// cache for all rows.
template <int kUnits, class Rows, class Inner, class Columns, class Finish>
OBBY_LANES void multiplyUnits(Rows& rows, size_t count, Inner inner, const float* b,
                              Columns columns, const float* begin, float* out, Finish&& finish) {
  const size_t words = (inner + kWord - 1) / kWord;
  for (size_t w = 0; w < words; ++w, b += kWord * columns) {
    for (size_t r = 0; r < count; ++r) {
      float* const to = out + r * columns;
      UnitSums<kUnits> sums(w == 0 ? begin : to);
      auto cursor = rows.cursor(r, w);
      forBits(rows.bits(r, w),
              [&](int i) OBBY_INLINED { sums.add(b + size_t(i) * columns, cursor(i)); });
      rows.end(r, cursor);
      if (w + 1 == words) finish(r, sums);
      sums.put(to);
    }
  }
}

// sums += transposed(rows) x gradient, (inner, columns), for the first kUnits columns and up to
// kRowBlock rows, one input after the other.
template <int kUnits, class Rows, class Inner, class Columns>
OBBY_LANES void addGradientUnits(Rows& rows, size_t count, Inner inner, const float* gradient,
                                 Columns columns, float* sums) {
  for (size_t first = 0; first < inner; first += kWord) {
    uint64_t on[kRowBlock] = {};
    const size_t w = first / kWord;
    for (size_t r = 0; r < count; ++r) on[r] = rows.bits(r, w);
    transpose(on);
    const size_t inputs = inner - first < kWord ? inner - first : kWord;
    for (size_t i = 0; i < inputs; ++i, sums += columns) {
      if (on[i] == 0) continue;
      UnitSums<kUnits> sum(sums);
      forBits(on[i], [&](int r) OBBY_INLINED {
        sum.add(gradient + size_t(r) * columns, rows.value(size_t(r), w, int(i)));
      });
      sum.put(sums);
    }
  }
}

}  // namespace obby::nn
