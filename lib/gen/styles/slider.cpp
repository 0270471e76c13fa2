// Platforms that slide from side to side. Most do not carry players, as tweened parts do not.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"platforms", "", 1, 4, 1, 12, "number of platforms"},
    {"size", "studs", 7, 4, 2, 20, "size of a platform"},
    {"travel", "studs", 3, 8, 0.25f, 12, "how far a platform slides to either side"},
    {"speed", "studs/s", 6, 9, 3, 30,
     "average speed of a platform, without its 0.75 s at each end"},
};
const auto& [kPlatforms, kSize, kTravel, kSpeed] = kParameters;

void build(Sketch& s) {
  const uint32_t platforms = s.mixCount(kPlatforms);
  for (uint32_t i = 0; i < platforms; ++i) {
    const float size = s.mix(kSize), travel = s.mix(kTravel), gap = s.gap(0, 0.65f);
    const float seconds = 1.5f + 2 * travel / s.mix(kSpeed);
    const float ahead = gap + size / 2;
    const bool carries = s.chance(0.3f);
    MotionSketch m =
        s.slide({-travel, -0.5f, ahead}, {travel, -0.5f, ahead}, seconds, 8 * s.unit());
    m.carries = carries;
    s.noteCarrier(3.2f * travel / seconds);
    s.part("Slider", {-travel, -0.5f, ahead}, {size, 1, size}).colored(colors::kMoving).moving(m);
    s.advance(gap + size);
  }
}

}  // namespace

constinit const Style kSliderStyle{.name = "slider",
                                   .description = "platforms that slide from side to side",
                                   .build = build,
                                   .parameters = kParameters};

}  // namespace obby::gen
