// Stones over lava, which lies so high that it catches who falls short.
#include "gen/styles/all.h"

namespace obby::gen {

void buildKillFloor(Sketch& s) {
  constexpr float kWide = 16, kDepth = 4, kDeeper = 20;
  const uint32_t stones = s.mixCount(2, 4);
  for (uint32_t i = 0; i < stones; ++i) {
    const float size = s.mix(6, 3.5f), gap = s.gap();
    // A gap that nobody crosses has its lava further down, where it is no step.
    const float depth = gap > s.reach().gap(0) ? kDeeper + kDepth : kDepth;
    Sketch::deadly(s.part("Lava", {0, -depth - 0.5f, (gap + size) / 2}, {kWide, 1, gap + size}));
    s.floor("Stone", size, size, gap, 0, s.mixEitherSign(0, 2));
  }
}

}  // namespace obby::gen
