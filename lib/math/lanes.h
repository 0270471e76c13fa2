// Lets the same source serve one world and many at once. Functions that matter for speed are
// templates on the number type F. float is one world (the scalar tick, and a GPU thread); WideFloat
// of simd/wide.h is as many worlds as the CPU has SIMD lanes. Every lane runs the same IEEE
// operations as a single world, so that both return the same bits. select() replaces branches, and
// a branch only skips work that no lane needs.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby {

// The integers (32 bits), truth values and width of a number type.
template <class F>
struct Lanes;

template <>
struct Lanes<float> {
  using Int = int32_t;
  using Mask = bool;
  static constexpr int kCount = 1;
};

template <class F>
using IntOf = typename Lanes<F>::Int;
template <class F>
using MaskOf = typename Lanes<F>::Mask;

OBBY_DEVICE float select(bool choose, float yes, float no) { return choose ? yes : no; }
OBBY_DEVICE int32_t select(bool choose, int32_t yes, int32_t no) { return choose ? yes : no; }
OBBY_DEVICE bool any(bool m) { return m; }
OBBY_DEVICE bool all(bool m) { return m; }
OBBY_DEVICE float toFloat(int32_t v) { return float(v); }
// Rounds toward zero. `v` must be within the range of the result.
OBBY_DEVICE int32_t toInt(float v) { return int32_t(v); }
OBBY_DEVICE float floatOfBits(int32_t v) { return __builtin_bit_cast(float, v); }

// Both return `b` if one of the numbers is NaN.
OBBY_DEVICE float minf(float a, float b) { return a < b ? a : b; }
OBBY_DEVICE float maxf(float a, float b) { return a > b ? a : b; }
OBBY_DEVICE float absf(float v) { return __builtin_fabsf(v); }
OBBY_DEVICE float sqrtf32(float v) { return __builtin_sqrtf(v); }  // correctly rounded everywhere

// These load and store the lanes of a row. A float is a row of one lane. WideFloat has its own
// functions.
OBBY_DEVICE void loadRow(const float* from, float& row) { row = *from; }
OBBY_DEVICE void storeRow(float row, float* to) { *to = row; }
OBBY_DEVICE float greatestOf(float row) { return row; }

// Returns the number in [lo, hi] nearest to `v`; `lo` for NaN.
template <class F>
OBBY_DEVICE F clampf(F v, F lo, F hi) {
  return minf(maxf(v, lo), hi);
}

}  // namespace obby
