// Low walls of lava across a floor, which players jump over.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"walls", "", 1, 4, 1, 12, "number of walls"},
    {"width", "studs", 12, 6, 2, 30, "width of floor and walls"},
    {"run", "studs", 14, 9, 6, 40, "distance from wall to wall"},
};
const auto& [kWalls, kWidth, kRun] = kParameters;

void build(Sketch& s) {
  const uint32_t walls = s.mixCount(kWalls);
  const float width = s.mix(kWidth), apex = s.reach().apex();
  for (uint32_t i = 0; i < walls; ++i) {
    const float height = clampf(apex * (0.15f + 0.55f * s.difficulty()), 0.5f, apex);
    const float run = s.mix(kRun);
    Sketch::deadly(s.wall("Kill wall", 0, run - 5, width, height, 1));
    s.floor("Floor", run, width);
    s.expectJumps(1);
  }
}

}  // namespace

constinit const Style kKillWallStyle{.name = "kill-wall",
                                     .description = "low lava walls to jump over",
                                     .build = build,
                                     .parameters = kParameters};

}  // namespace obby::gen
