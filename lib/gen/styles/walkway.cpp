// Long walkways with round corners. Hard ones are as narrow as beams.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"segments", "", 2, 4, 1, 12, "number of straight stretches"},
    {"width", "studs", 8, 2.5f, 1, 12, "width of the walkway"},
    {"length", "studs", 12, 26, 8, 60, "length of a stretch"},
};
const auto& [kSegments, kWidth, kLength] = kParameters;

void build(Sketch& s) {
  const uint32_t segments = s.mixCount(kSegments);
  const float width = s.mix(kWidth), corner = width + 2;
  for (uint32_t i = 0; i < segments; ++i) {
    s.floor("Walkway", s.mix(kLength), width);
    if (i + 1 == segments) break;
    // The disc lies above the ends of the lanes, so that coplanar faces do not flicker.
    constexpr float kLip = 0.1f;
    s.disc("Corner", corner, -width / 2, kLip);
    s.via({0, 0, -corner / 2});
    s.bend(corner);
    s.advance(-width / 2, -kLip);
  }
}

}  // namespace

constinit const Style kWalkwayStyle{
    .name = "walkway",
    .description = "long walkways with turns, narrower at higher difficulty",
    .build = build,
    .parameters = kParameters};

}  // namespace obby::gen
