// A run over tiles that disappear soon after they are touched.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"tiles", "", 3, 6, 1, 20, "number of tiles"},
    {"size", "studs", 6, 4, 2, 20, "size of a tile"},
    {"delay", "seconds", 1.5f, 0.5f, 0.25f, 10, "time from touching a tile until it disappears"},
    {"aside", "studs", 0, 1.5f, 0, 3, "offset of a tile, to either side"},
};
const auto& [kTiles, kSize, kDelay, kAside] = kParameters;

void build(Sketch& s) {
  const uint32_t tiles = s.mixCount(kTiles);
  for (uint32_t i = 0; i < tiles; ++i) {
    const float size = s.mix(kSize), delay = s.mix(kDelay);
    const float aside = s.mixEitherSign(kAside), gap = s.gap(0, 0.55f);
    s.floor("Fading tile", size, size, gap, 0, aside)
        .colored(colors::kFading)
        .vanishing({schema::VanishTrigger::TOUCH, delay, 3, 0, false});
  }
}

}  // namespace

constinit const Style kVanishStyle{.name = "vanish",
                                   .description = "a run over tiles that disappear when touched",
                                   .build = build,
                                   .parameters = kParameters};

}  // namespace obby::gen
