// Long walkways with round corners. Hard ones are as narrow as a beam.
#include "gen/styles/all.h"

namespace obby::gen {

void buildWalkway(Sketch& s) {
  const uint32_t segments = s.mixCount(2, 4);
  const float width = s.mix(8, 2.5f), corner = width + 2;
  for (uint32_t i = 0; i < segments; ++i) {
    s.floor("Walkway", s.mix(12, 26), width);
    if (i + 1 == segments) break;
    // Above the ends of the lanes, so that tops do not flicker.
    constexpr float kLip = 0.1f;
    s.disc("Corner", corner, -width / 2, kLip);
    s.bend(corner);
    s.advance(-width / 2, -kLip);
  }
}

}  // namespace obby::gen
