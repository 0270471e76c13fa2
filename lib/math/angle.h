// Angles as 16-bit fractions of a turn, and their sine and cosine without libm. Wrap-around is
// exact, and a heading costs two bytes in an action. A turn has 65536 units, counter-clockwise seen
// from above; 0 looks along -Z.
#pragma once

#include <stdint.h>

#include "math/vec.h"

namespace obby {

using Turns = uint16_t;  // turns / 65536

constexpr float kPi = 3.14159265358979f;
constexpr float kTurnsPerRadian = 65536.0f / (2 * kPi);
constexpr float kRadiansPerTurn = 2 * kPi / 65536.0f;

template <class F>
struct SinCosT {
  F sin, cos;
};

using SinCos = SinCosT<float>;

// Returns the sine and cosine of an angle in [0, 65536). Accurate to 1e-7, and exact at multiples
// of a quarter turn.
template <class F>
OBBY_DEVICE SinCosT<F> sinCosOf(IntOf<F> angle) {
  // Nearest quarter turn, and the rest in [-1/8, 1/8) of a turn.
  const IntOf<F> quarter = (angle + 0x2000) >> 14;
  const F r = toFloat(angle - (quarter << 14)) * kRadiansPerTurn;
  const F r2 = r * r;
  // Minimax polynomials on [-pi/4, pi/4] (Cephes sinf, cosf).
  const F s = r + r * r2 * (-1.6666654611e-1f + r2 * (8.3321608736e-3f + r2 * -1.9515295891e-4f));
  const F c =
      1.0f - 0.5f * r2 +
      r2 * r2 *
          (4.166664568298827e-2f + r2 * (-1.388731625493765e-3f + r2 * 2.443315711809948e-5f));
  const MaskOf<F> odd = (quarter & 1) != 0;
  const MaskOf<F> sinFalls = (quarter & 2) != 0, cosFalls = ((quarter + 1) & 2) != 0;
  const F sinSize = select(odd, c, s), cosSize = select(odd, s, c);
  return {select(sinFalls, -sinSize, sinSize), select(cosFalls, -cosSize, cosSize)};
}

OBBY_DEVICE SinCos sinCos(Turns angle) { return sinCosOf<float>(angle); }

// Rounds radians to the nearest unit, for magnitudes below 2^20 turns.
OBBY_DEVICE Turns turnsFromRadians(float radians) {
  const float t = radians * kTurnsPerRadian;
  return Turns(int64_t(t + (t < 0 ? -0.5f : 0.5f)));
}
// Returns radians in [-pi, pi).
OBBY_DEVICE float radiansFromTurns(Turns t) { return float(int16_t(t)) * kRadiansPerTurn; }

// Returns the walking direction of a heading, a unit vector: -Z at 0, -X after a quarter turn.
template <class F>
OBBY_DEVICE Vec3T<F> directionOf(SinCosT<F> a) {
  return {-a.sin, 0, -a.cos};
}

// Returns the angle whose direction is (x, z), accurate to 1 unit, without libm. Returns 0 for (0,
// 0).
OBBY_DEVICE Turns headingOf(float x, float z) {
  const float ax = absf(x), az = absf(z);
  const float big = maxf(ax, az), small = minf(ax, az);
  if (!(big > 0)) return 0;
  const float q = small / big, q2 = q * q;
  // atan on [0, 1], |error| < 1e-5 rad (Abramowitz and Stegun 4.4.49).
  float a = q * (0.9998660f +
                 q2 * (-0.3302995f + q2 * (0.1801410f + q2 * (-0.0851330f + q2 * 0.0208351f))));
  if (ax > az) a = 0.5f * kPi - a;  // angle from the Z axis
  if (z > 0) a = kPi - a;           // 0 is -Z
  return turnsFromRadians(x > 0 ? -a : a);
}

}  // namespace obby
