// Platforms that come and go to a beat, every other one in turn.
#include "gen/styles/all.h"

namespace obby::gen {

void buildBeat(Sketch& s) {
  const uint32_t platforms = s.mixCount(2, 5);
  const float beat = s.mix(2.5f, 1.25f);
  for (uint32_t i = 0; i < platforms; ++i) {
    const float size = s.mix(7, 4.5f), phase = i % 2 == 0 ? 0 : beat;
    s.floor("Beat block", size, size, s.gap(0, 0.6f))
        .colored(colors::kBeat[i % 2])
        .vanishing({schema::VanishTrigger::TIMER, beat, beat, phase, false});
    s.expectWait(2 * beat);
  }
}

}  // namespace obby::gen
