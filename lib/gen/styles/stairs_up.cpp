// Steps to jump up. Solid down to the foot, as stairs are built.
#include "gen/styles/all.h"

namespace obby::gen {

void buildStairsUp(Sketch& s) {
  const uint32_t steps = s.mixCount(3, 5);
  const float width = s.mix(8, 5);
  s.floor("Foot", 6, width);
  float height = 0;
  for (uint32_t i = 0; i < steps; ++i) {
    const float up = s.rise(), deep = s.mix(6, 4);
    height += up;
    s.part("Step", {0, up - height / 2 - 0.5f, deep / 2}, {width, height + 1, deep})
        .colored(s.shade());
    s.advance(deep, up);
  }
}

}  // namespace obby::gen
