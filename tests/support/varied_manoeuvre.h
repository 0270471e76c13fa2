// Manoeuvres like those of the calibration course, but never quite the same: to hold a fit against
// what it has not seen.
#pragma once

#include <cmath>

#include "base/random.h"
#include "calibrate/manoeuvres.h"

namespace obby::test {

// At most by so much.
struct Variation {
  float share;    // that a hold lasts shorter or longer, each its own
  float radians;  // that the stick points elsewhere, the same way throughout
};
constexpr Variation kElsewhere{0.2f, 0.35f};  // another way through the same place
constexpr Variation kAgain{0.05f, 0.05f};     // as somebody does the same thing once more

inline calibrate::Manoeuvre varied(calibrate::Manoeuvre manoeuvre, uint64_t seed,
                                   Variation most = kElsewhere) {
  Random random(seed, 0x7a21);
  const auto between = [&] { return 2 * random.unit() - 1; };
  const float angle = most.radians * between();
  const float c = std::cos(angle), s = std::sin(angle);
  for (calibrate::Hold& hold : manoeuvre.holds) {
    hold.seconds *= 1 + most.share * between();
    const float x = hold.x;
    hold.x = c * x + s * hold.z;
    hold.z = c * hold.z - s * x;
  }
  return manoeuvre;
}

}  // namespace obby::test
