// Walls to jump over, on a floor.
#include "gen/styles/all.h"

namespace obby::gen {

void buildWall(Sketch& s) {
  constexpr float kRoundabout = 30;  // studs beside a wall that nobody jumps round
  constexpr float kSure = 0.9f;      // of the highest jump
  const uint32_t walls = s.mixCount(1, 2);
  const float width = s.mix(12, 8), before = 9, thick = s.mix(2, 1);
  const float behind = 9;
  for (uint32_t i = 0; i < walls; ++i) {
    const float rise = s.straight() ? s.rise() : s.easyRise();
    // Not to be stepped over, where somebody can jump higher than that.
    const float least = minf(s.reach().params().hipHeight + 1, kSure * s.reach().rise());
    const float height = maxf(rise, least);
    const bool high = height > s.reach().rise();
    s.wall("Wall", 0, before, high ? width + 2 * kRoundabout : width, height, thick);
    s.floor("Floor", before + behind, width);
  }
}

}  // namespace obby::gen
