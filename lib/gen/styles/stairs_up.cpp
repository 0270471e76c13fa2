// Steps to jump up, solid down to the foot like real stairs.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"steps", "", 3, 5, 1, 12, "number of steps"},
    {"width", "studs", 8, 5, 2, 30, "width of the stairs"},
    {"depth", "studs", 6, 4, 2, 30, "depth of a step"},
};
const auto& [kSteps, kWidth, kDepth] = kParameters;

void build(Sketch& s) {
  const uint32_t steps = s.mixCount(kSteps);
  const float width = s.mix(kWidth);
  s.floor("Foot", 6, width);
  float height = 0;
  for (uint32_t i = 0; i < steps; ++i) {
    const float up = s.rise(), deep = s.mix(kDepth);
    height += up;
    s.part("Step", {0, up - height / 2 - 0.5f, deep / 2}, {width, height + 1, deep})
        .colored(s.shade());
    s.advance(deep, up);
  }
}

}  // namespace

constinit const Style kStairsUpStyle{.name = "stairs-up",
                                     .description = "steps to jump up",
                                     .build = build,
                                     .parameters = kParameters};

}  // namespace obby::gen
