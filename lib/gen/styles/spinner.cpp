// Deadly bars that sweep over a disc. Players jump over them or run round with them.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"discs", "", 1, 2, 1, 6, "number of discs"},
    {"diameter", "studs", 18, 14, 8, 40, "diameter of a disc"},
    {"height", "studs", 0.75f, 2, 0.25f, 4, "height of a bar"},
    {"speed", "rad/s", 0.75f, 2.75f, 0.5f, 6, "speed of a bar, in either direction"},
};
const auto& [kDiscs, kDiameter, kHeight, kSpeed] = kParameters;

void build(Sketch& s) {
  const uint32_t discs = s.mixCount(kDiscs);
  for (uint32_t i = 0; i < discs; ++i) {
    const float across = s.mix(kDiameter), gap = s.gap(0, 0.6f);
    const float high = s.mix(kHeight), speed = s.mixSpin(kSpeed);
    const Vec3 middle{0, 0, gap + across / 2};
    MotionSketch turning;
    turning.spin = speed;
    turning.offset = 4 * s.unit();
    const uint32_t bars =
        s.chance(s.difficulty() - 0.3f) ? 2 : 1;  // a single bar, or two that form a cross
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

}  // namespace

constinit const Style kSpinnerStyle{.name = "spinner",
                                    .description = "deadly bars that sweep over a disc",
                                    .build = build,
                                    .parameters = kParameters};

}  // namespace obby::gen
