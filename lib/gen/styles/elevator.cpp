// Platforms that rise to a ledge beyond a jump.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"lifts", "", 1, 2, 1, 6, "number of lifts"},
    {"size", "studs", 8, 4.5f, 3, 20, "size of a lift"},
    {"speed", "studs/s", 4, 8, 2, 30, "average speed of a lift"},
    {"height", "studs", 2, 10, 2, 40, "how far the ledge is above the highest jump"},
    {"edge", "studs", 1, 3, 0, 5, "distance from the lift to the ledge"},
    {"width", "studs", 10, 6, 2, 30, "width of the ledge"},
};
const auto& [kLifts, kSize, kSpeed, kHeight, kEdge, kWidth] = kParameters;

void build(Sketch& s) {
  const uint32_t lifts = s.mixCount(kLifts);
  for (uint32_t i = 0; i < lifts; ++i) {
    const float size = s.mix(kSize), gap = s.gap(0, 0.4f), speed = s.mix(kSpeed);
    const float up = s.highLedge(kHeight), seconds = maxf(up / speed, 1.0f);
    const float ahead = gap + size / 2;
    s.noteCarrier(2 * speed);
    if (s.broken("lift")) {
      s.part("Platform", {0, -0.5f, ahead}, {size, 1, size}).colored(s.shade());
    } else {
      s.part("Lift", {0, -0.5f, ahead}, {size, 1, size})
          .colored(colors::kMoving)
          .moving(s.slide({0, -0.5f, ahead}, {0, up - 0.5f, ahead}, seconds, 0));
      s.expectWait(2 * seconds);
    }
    s.via({0, 0, ahead});
    s.via({0, up, ahead});
    s.advance(gap + size, up);
    const float edge = s.mix(kEdge);
    s.floor("Ledge", 8, s.mix(kWidth), edge);
    s.wall("Cliff", 0, -4, 6, up + 4, 6, -up - 4.5f);
  }
}

}  // namespace

constinit const Style kElevatorStyle{
    .name = "elevator",
    .description = "platforms that rise to a ledge too high to jump to",
    .build = build,
    .parameters = kParameters};

}  // namespace obby::gen
