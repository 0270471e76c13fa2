// Variations of the calibration course's manoeuvres, to test a fit against unseen recordings.
#pragma once

#include <cmath>

#include "base/random.h"
#include "calibrate/manoeuvres.h"

namespace obby::test {

// Maximum variation of a manoeuvre.
struct Variation {
  float share;    // relative change of the duration of each hold
  float radians;  // change of the stick's direction, constant during the manoeuvre
};
constexpr Variation kElsewhere{0.2f, 0.35f};  // another trajectory through the same place
constexpr Variation kAgain{0.05f, 0.05f};     // a repetition by the same player

inline calibrate::Manoeuvre varied(calibrate::Manoeuvre manoeuvre, uint64_t seed,
                                   Variation max = kElsewhere) {
  Random random(seed, 0x7a21);
  const auto between = [&] { return 2 * random.unit() - 1; };
  const float angle = max.radians * between();
  const float c = std::cos(angle), s = std::sin(angle);
  for (calibrate::Hold& hold : manoeuvre.holds) {
    hold.seconds *= 1 + max.share * between();
    const float x = hold.x;
    hold.x = c * x + s * hold.z;
    hold.z = c * hold.z - s * x;
  }
  return manoeuvre;
}

}  // namespace obby::test
