// Belts that run against, across or along the way.
#include "gen/styles/all.h"

namespace obby::gen {

void buildConveyor(Sketch& s) {
  const uint32_t belts = s.mixCount(1, 3);
  for (uint32_t i = 0; i < belts; ++i) {
    const float long_ = s.mix(10, 20), width = s.mix(10, 5), walk = s.reach().params().walkSpeed;
    const uint32_t kind = s.below(3);
    const float share = kind == 0 ? s.mix(0.25f, 0.75f) : s.mix(0.25f, 0.5f);
    const float speed = minf(walk, 40.0f) * share;
    const Vec3 way = kind == 0 ? Vec3{0, 0, -1} : kind == 1 ? Vec3{s.side(), 0, 0} : Vec3{0, 0, 1};
    const Vec3 velocity = s.direction(way * speed);
    s.noteCarrier(speed);
    s.floor("Belt", long_, width).colored(colors::kBelt).conveyor = velocity;
    s.floor("Floor", 6, s.mix(9, 6));
    s.expectWait(kind == 0 ? long_ / maxf(walk - speed, 1.0f) : 1.0f);
  }
}

}  // namespace obby::gen
