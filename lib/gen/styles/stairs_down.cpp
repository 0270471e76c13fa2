// Drops onto smaller and smaller steps, some of them by a jump.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"steps", "", 3, 5, 1, 12, "number of steps"},
    {"drop", "studs", 3, 12, 0, 20, "how much lower the next step is"},
    {"size", "studs", 7, 3.5f, 2, 30, "size of a step"},
};
const auto& [kSteps, kDrop, kSize] = kParameters;

void build(Sketch& s) {
  const uint32_t steps = s.mixCount(kSteps);
  for (uint32_t i = 0; i < steps; ++i) {
    const float down = -s.mix(kDrop), size = s.mix(kSize);
    s.floor("Step down", size, size, s.gap(down, 0.72f), down);
  }
}

}  // namespace

constinit const Style kStairsDownStyle{.name = "stairs-down",
                                       .description = "drops onto smaller and smaller steps",
                                       .build = build,
                                       .parameters = kParameters};

}  // namespace obby::gen
