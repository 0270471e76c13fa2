// Thin beams from pad to pad.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"beams", "", 1, 3, 1, 12, "number of beams"},
    {"pad", "studs", 6, 4, 2, 30, "size of the pad behind a beam"},
    {"width", "studs", 3, 0.75f, 0.25f, 10, "width of a beam"},
    {"length", "studs", 10, 22, 2, 60, "length of a beam"},
};
const auto& [kBeams, kPad, kWidth, kLength] = kParameters;

void build(Sketch& s) {
  const uint32_t beams = s.mixCount(kBeams);
  for (uint32_t i = 0; i < beams; ++i) {
    const float pad = s.mix(kPad);
    const float width = s.mix(kWidth), long_ = s.mix(kLength);
    s.floor("Beam", long_, width).colored(colors::kWood);
    s.floor("Pad", pad, pad);
    s.expectWait(0.5f);
  }
}

}  // namespace

constinit const Style kBeamStyle{
    .name = "beam", .description = "thin beams", .build = build, .parameters = kParameters};

}  // namespace obby::gen
