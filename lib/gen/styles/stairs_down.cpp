// Drops onto ever smaller steps, out of a jump the harder.
#include "gen/styles/all.h"

namespace obby::gen {

void buildStairsDown(Sketch& s) {
  const uint32_t steps = s.mixCount(3, 5);
  for (uint32_t i = 0; i < steps; ++i) {
    const float down = -s.mix(3, 12), size = s.mix(7, 3.5f);
    s.floor("Step down", size, size, s.gap(down, 0.72f), down);
  }
}

}  // namespace obby::gen
