// A run over tiles that disappear soon after they are touched.
#include "gen/styles/all.h"

namespace obby::gen {

void buildVanish(Sketch& s) {
  const uint32_t tiles = s.mixCount(3, 6);
  for (uint32_t i = 0; i < tiles; ++i) {
    const float size = s.mix(6, 4), delay = s.mix(1.5f, 0.5f);
    const float aside = s.mixEitherSign(0, 1.5f), gap = s.gap(0, 0.55f);
    s.floor("Fading tile", size, size, gap, 0, aside)
        .colored(colors::kFading)
        .vanishing({schema::VanishTrigger::TOUCH, delay, 3, 0, false});
  }
}

}  // namespace obby::gen
