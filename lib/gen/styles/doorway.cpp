// High walls, each with a gap that the player must find.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"walls", "", 1, 3, 1, 12, "number of walls"},
    {"hole", "studs", 6, 3, 3, 12, "width of the gap in a wall"},
};
const auto& [kWalls, kHole] = kParameters;

void build(Sketch& s) {
  constexpr float kRoundabout = 30, kHigh = 14, kDeep = 12;
  const uint32_t walls = s.mixCount(kWalls);
  const float width = 18;
  const float height = maxf(kHigh, s.reach().rise() + 5);
  for (uint32_t i = 0; i < walls; ++i) {
    const float hole = s.mix(kHole), spare = width - hole - 2;
    const float left = 1 + spare * s.unit();
    if (s.straight() && s.broken("door")) {
      s.wall("Wall", 0, kDeep - 3, width + 2 * s.roundabout(kRoundabout), height, 1);
    } else {
      const float right = width - hole - left;
      s.wall("Wall", (left - width) / 2, kDeep - 3, left, height, 1);
      s.wall("Wall", (width - right) / 2, kDeep - 3, right, height, 1);
    }
    s.via({left + (hole - width) / 2, 0, kDeep - 3});
    s.floor("Floor", kDeep, width);
    s.expectRoute(width / 2);
  }
}

}  // namespace

constinit const Style kDoorwayStyle{.name = "doorway",
                                    .description = "walls with a gap to find",
                                    .build = build,
                                    .parameters = kParameters};

}  // namespace obby::gen
