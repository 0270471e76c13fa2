// Platforms that rise to a ledge beyond a jump.
#include "gen/styles/all.h"

namespace obby::gen {

void buildElevator(Sketch& s) {
  const uint32_t lifts = s.mixCount(1, 2);
  for (uint32_t i = 0; i < lifts; ++i) {
    const float size = s.mix(8, 4.5f), gap = s.gap(0, 0.4f), speed = s.mix(4, 8);
    const float up = s.highLedge(2, 10), seconds = maxf(up / speed, 1.0f);
    const float ahead = gap + size / 2;
    s.noteCarrier(2 * speed);
    if (s.broken("lift")) {
      s.part("Platform", {0, -0.5f, ahead}, {size, 1, size}).colored(s.shade());
    } else {
      s.part("Lift", {0, -0.5f, ahead}, {size, 1, size})
          .colored(colors::kMoving)
          .moving(s.slide({0, -0.5f, ahead}, {0, up - 0.5f, ahead}, seconds, 0));
      s.expectWait(2 * seconds);
    }
    s.via({0, 0, ahead});
    s.via({0, up, ahead});
    s.advance(gap + size, up);
    const float edge = s.mix(1, 3);
    s.floor("Ledge", 8, s.mix(10, 6), edge);
    s.wall("Cliff", 0, -4, 6, up + 4, 6, -up - 4.5f);
  }
}

}  // namespace obby::gen
