// Pads that throw the player up to a ledge that no jump reaches.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"pads", "", 1, 2, 1, 6, "number of pads"},
    {"height", "studs", 2, 12, 2, 60, "how far the ledge is above the highest jump"},
    {"spare", "studs", 6, 1.5f, 0.5f, 20, "how far above the ledge the pad throws the player"},
    {"width", "studs", 10, 7, 3, 30, "width of floor and ledge"},
    {"size", "studs", 6, 3, 1, 10, "size of the pad"},
    {"edge", "studs", 2, 5, 0, 8, "distance from the floor to the ledge"},
};
const auto& [kPads, kHeight, kSpare, kWidth, kSize, kEdge] = kParameters;

void build(Sketch& s) {
  const uint32_t pads = s.mixCount(kPads);
  for (uint32_t i = 0; i < pads; ++i) {
    const float up = s.highLedge(kHeight), spare = s.mix(kSpare),
                speed = s.reach().speedFor(up + spare);
    const float width = s.mix(kWidth), size = s.mix(kSize), edge = s.mix(kEdge);
    s.floor("Floor", 12, width);
    if (!s.broken("pad")) {
      s.part("Jump pad", {0, 0.15f, -1 - size / 2}, {size, 0.3f, size}).colored(colors::kPad).pad =
          {0, speed, 0};
    }
    s.advance(0, up);
    s.floor("Ledge", 12, width, edge);
    s.expectWait(1.5f);
  }
}

}  // namespace

constinit const Style kJumpPadStyle{.name = "jump-pad",
                                    .description = "pads that throw the player up to a ledge",
                                    .build = build,
                                    .parameters = kParameters};

}  // namespace obby::gen
