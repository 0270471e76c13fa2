// Thin beams from pad to pad.
#include "gen/styles/all.h"

namespace obby::gen {

void buildBeam(Sketch& s) {
  const uint32_t beams = s.mixCount(1, 3);
  for (uint32_t i = 0; i < beams; ++i) {
    const float pad = s.mix(6, 4);
    const float width = s.mix(3, 0.75f), long_ = s.mix(10, 22);
    s.floor("Beam", long_, width).colored(colors::kWood);
    s.floor("Pad", pad, pad);
    s.expectWait(0.5f);
  }
}

}  // namespace obby::gen
