// Pads that throw the player up to a ledge that no jump reaches.
#include "gen/styles/all.h"

namespace obby::gen {

void buildJumpPad(Sketch& s) {
  const uint32_t pads = s.mixCount(1, 2);
  for (uint32_t i = 0; i < pads; ++i) {
    const float up = s.highLedge(2, 12), spare = s.mix(6, 1.5f),
                speed = s.reach().speedFor(up + spare);
    const float width = s.mix(10, 7), size = s.mix(6, 3), edge = s.mix(2, 5);
    s.floor("Floor", 12, width);
    if (!s.broken("pad")) {
      s.part("Jump pad", {0, 0.15f, -1 - size / 2}, {size, 0.3f, size}).colored(colors::kPad).pad =
          {0, speed, 0};
    }
    s.advance(0, up);
    s.floor("Ledge", 12, width, edge);
    s.expectWait(1.5f);
  }
}

}  // namespace obby::gen
