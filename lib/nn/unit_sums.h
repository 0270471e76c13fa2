// Sums over a layer's units as lanes, and over lists of bits: what learning on the CPU is made of.
// Host only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/bits.h"
#include "simd/wide.h"

namespace obby::nn {

// A number for each of some units, in registers. Products are added unfused, so that the sums are
// the same for any number of lanes.
template <int kUnits>
struct UnitSums {
  static constexpr int kGroups = kUnits / kLanes;
  static_assert(kUnits % kLanes == 0);

  WideFloat group[kGroups];

  // Unrolled: at -O2 the sums would stay in memory.
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
  // 0 for units that are off in `row`.
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

constexpr size_t kWord = 64;      // numbers that have a bit each in a word
constexpr size_t kRowBlock = 64;  // rows whose gradients are summed in registers

// A bit for each of up to kWord numbers that is not zero.
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

// Calls visit(number of the bit) from the lowest on.
template <class Visit>
OBBY_LANES void forBits(uint64_t bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(lowestBit(bits));
}

// Bit j of word i becomes bit i of word j: blocks of 32, 16, ... 1 change sides.
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

// Some rows of inputs give, in words of kWord inputs, which of them are not zero, `bits(r, w)`, and
// these inputs' values: for a row and word `cursor(r, w)`, called with each bit in their order, and
// given back to `end(r, cursor)`; or one by one, `value(r, w, bit)`. Only they are multiplied.
// Widths may be constants: std::integral_constant.

// out = begin + rows x b, (count, columns), for the first kUnits columns; `finish(r, sums)` is the
// last to change a row. A word after the other: its weights stay in a core's nearest cache while
// all rows pass.
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
// kRowBlock rows. An input after the other.
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
