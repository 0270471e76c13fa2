// Stones with air between them, a little up and down, smaller and further apart the harder.
#include "gen/styles/all.h"

namespace obby::gen {

void buildGaps(Sketch& s) {
  const uint32_t stones = s.mixCount(2, 4);
  for (uint32_t i = 0; i < stones; ++i) {
    const float up = s.mixEitherSign(0, 2), size = s.mix(7, 4);
    const float aside = s.mixEitherSign(0, 1.5f);
    s.floor("Stone", size, size, s.gap(up), up, aside);
  }
}

}  // namespace obby::gen
