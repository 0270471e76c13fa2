// Stones to this side and that, up and down: each jump goes another way than the one before.
#include "gen/styles/all.h"

namespace obby::gen {

void buildZigzag(Sketch& s) {
  const uint32_t stones = s.mixCount(3, 6);
  const float most = 0.6f * s.reach().rise();
  float side = s.side();
  for (uint32_t i = 0; i < stones; ++i, side = -side) {
    const float size = s.mix(6, 3), up = s.chance(0.5f) ? minf(s.mix(0, 4), most) : -s.mix(0, 3);
    const float gap = s.gap(up);
    // What nobody can cross goes straight on, where it is as wide as it was measured to be.
    const float slant = side * s.mix(0.25f, 0.85f), lean = slant * s.unit();
    const float aim = gap < s.reach().gap(up) ? lean : 0;
    const float ahead = sqrtf32(1 - aim * aim);
    s.floor("Stone", size, size, gap * ahead, up, (gap + size) * aim);
    s.via({0, 0, -size / 2});
  }
}

}  // namespace obby::gen
