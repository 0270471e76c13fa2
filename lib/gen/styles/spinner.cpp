// Deadly bars that turn over a disc: to be jumped or run round with.
#include "gen/styles/all.h"

namespace obby::gen {

void buildSpinner(Sketch& s) {
  const uint32_t discs = s.mixCount(1, 2);
  for (uint32_t i = 0; i < discs; ++i) {
    const float across = s.mix(18, 14), gap = s.gap(0, 0.6f);
    const float high = s.mix(0.75f, 2), speed = s.mixSpin(0.75f, 2.75f);
    const Vec3 middle{0, 0, gap + across / 2};
    MotionSketch turning;
    turning.spin = speed;
    turning.offset = 4 * s.unit();
    const uint32_t bars = s.chance(s.difficulty() - 0.3f) ? 2 : 1;  // one, or a cross
    for (uint32_t k = 0; k < bars; ++k) {
      const Vec3 size = k == 0 ? Vec3{across - 1, high, 0.75f} : Vec3{0.75f, high, across - 1};
      Sketch::deadly(s.part("Bar", middle + Vec3{0, 0.25f + high / 2, 0}, size)).moving(turning);
    }
    s.noteCarrier(absf(speed) * across / 2);
    s.part("Hub", middle + Vec3{0, 1.25f, 0}, {2.5f, 1.5f, 1.5f})
        .shaped(schema::Shape::CYLINDER)
        .turned(kUpright)
        .colored(colors::kFading);
    s.disc("Disc", across, gap);
    s.expectWait(6.3f / absf(speed));
    s.expectJumps(2);
  }
}

}  // namespace obby::gen
