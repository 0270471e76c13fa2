// Slippery lanes, with a corner to slide round or a gap to leave at speed.
#include "gen/styles/all.h"

namespace obby::gen {

void buildIce(Sketch& s) {
  const uint32_t lanes = s.mixCount(1, 3);
  for (uint32_t i = 0; i < lanes; ++i) {
    const float width = s.mix(10, 5), friction = 0.09f - 0.07f * s.difficulty();
    const float gap = i == 0 ? 0 : s.gap(0, 0.5f), long_ = s.mix(10, 18);
    s.floor("Ice", long_, width, gap).colored(colors::kIce).friction = friction;
    const float corner = width + 2;
    PartSketch& p = s.disc("Ice corner", corner, -width / 4, 0.1f);
    p.colored(colors::kIce).friction = friction;
    s.bend(corner);
    s.advance(0, -0.1f);
    s.expectWait(1);
  }
  s.floor("Strip", 8, 6);
}

}  // namespace obby::gen
