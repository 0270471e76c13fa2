// Platforms that slide from side to side; most do not carry, as where a tween moves them.
#include "gen/styles/all.h"

namespace obby::gen {

void buildSlider(Sketch& s) {
  const uint32_t platforms = s.mixCount(1, 4);
  for (uint32_t i = 0; i < platforms; ++i) {
    const float size = s.mix(7, 4), way = s.mix(3, 8), gap = s.gap(0, 0.65f);
    const float seconds = 1.5f + 2 * way / s.mix(6, 9);
    const float ahead = gap + size / 2;
    const bool carries = s.chance(0.3f);
    MotionSketch m = s.slide({-way, -0.5f, ahead}, {way, -0.5f, ahead}, seconds, 8 * s.unit());
    m.carries = carries;
    s.noteCarrier(3.2f * way / seconds);
    s.part("Slider", {-way, -0.5f, ahead}, {size, 1, size}).colored(colors::kMoving).moving(m);
    s.advance(gap + size);
  }
}

}  // namespace obby::gen
