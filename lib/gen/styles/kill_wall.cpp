// Low walls of lava across a floor, to be jumped.
#include "gen/styles/all.h"

namespace obby::gen {

void buildKillWall(Sketch& s) {
  const uint32_t walls = s.mixCount(1, 4);
  const float width = s.mix(12, 6), apex = s.reach().apex();
  for (uint32_t i = 0; i < walls; ++i) {
    const float height = clampf(apex * (0.15f + 0.55f * s.difficulty()), 0.5f, apex);
    const float run = s.mix(14, 9);
    Sketch::deadly(s.wall("Kill wall", 0, run - 5, width, height, 1));
    s.floor("Floor", run, width);
    s.expectJumps(1);
  }
}

}  // namespace obby::gen
