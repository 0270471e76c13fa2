// Manoeuvres like those of the calibration course, but never quite the same: to hold a fit against
// what it has not seen.
#pragma once

#include <cmath>

#include "base/random.h"
#include "calibrate/manoeuvres.h"

namespace obby::test {

// Each hold lasts up to a fifth shorter or longer, and the stick points up to 20 degrees elsewhere,
// the same way throughout.
inline calibrate::Manoeuvre varied(calibrate::Manoeuvre manoeuvre, uint64_t seed) {
  Random random(seed, 0x7a21);
  const auto between = [&] { return 2 * random.unit() - 1; };
  const float angle = 0.35f * between();
  const float c = std::cos(angle), s = std::sin(angle);
  for (calibrate::Hold& hold : manoeuvre.holds) {
    hold.seconds *= 1 + 0.2f * between();
    const float x = hold.x;
    hold.x = c * x + s * hold.z;
    hold.z = c * hold.z - s * x;
  }
  return manoeuvre;
}

}  // namespace obby::test
