// The exponential function and the logarithm without libm. They are fixed sequences of IEEE
// operations, so that they return the same bits on every machine.
#pragma once

#include <stdint.h>

#include "math/lanes.h"

namespace obby {

// Returns e^x for x <= 0 with a relative error below 3e-7, and 0 below -80. F is one number or
// lanes of numbers.
template <class F>
OBBY_DEVICE F expOfNegative(F x) {
  using Int = IntOf<F>;
  // Used without a branch, so that the compiler can vectorize.
  const MaskOf<F> some = x > F(-80.0f);
  const F y = select(some, x, F(-80.0f));
  const F t = y * F(1.44269504f);
  const Int whole = toInt(t - F(0.5f));  // nearest whole number, as t <= 0
  const F n = toFloat(whole);
  const F r = (y - n * F(0.693359375f)) + n * F(2.12194440e-4f);
  const F tail = F(4.1666668e-2f) + r * (F(8.3333477e-3f) + r * F(1.3930436e-3f));
  const F e = F(1.0f) + r * (F(1.0f) + r * (F(0.5f) + r * (F(1.6666667e-1f) + r * tail)));
  const Int bits = select(some, (whole + Int(127)) << 23, Int(0));
  return e * floatOfBits(bits);
}
OBBY_DEVICE float expNegative(float x) { return expOfNegative<float>(x); }

// Returns e^x with a relative error below 4e-7; 0 below -80, and e^80 above 80.
OBBY_DEVICE float expOf(float x) {
  return x > 0 ? 1.0f / expNegative(x < 80.0f ? -x : -79.99999f) : expNegative(x);
}

// Returns the natural logarithm of a normal number above 0. The error is below 2e-7, or 2e-7 times
// the magnitude of the result if that is above 1.
OBBY_DEVICE float logOf(float x) {
  const uint32_t bits = __builtin_bit_cast(uint32_t, x);
  // x = m 2^e with m in [sqrt(1/2), sqrt(2)).
  const uint32_t shifted = bits + (0x3f800000u - 0x3f3504f3u);
  const int32_t e = int32_t(shifted >> 23) - 127;
  const float m = __builtin_bit_cast(float, (shifted & 0x007fffffu) + 0x3f3504f3u);
  // log m = 2 artanh s.
  const float s = (m - 1.0f) / (m + 1.0f), s2 = s * s;
  const float series =
      2.0f * s * (1.0f + s2 * (0.33333333f + s2 * (0.2f + s2 * (0.14285714f + s2 * 0.11111111f))));
  return float(e) * 0.693359375f + (series - float(e) * 2.12194440e-4f);
}

}  // namespace obby
