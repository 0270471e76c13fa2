// Stones over lava, which lies high enough to catch players who jump short.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"stones", "", 2, 4, 1, 12, "number of stones"},
    {"size", "studs", 6, 3.5f, 2, 12, "size of a stone"},
    {"aside", "studs", 0, 2, 0, 3, "offset of a stone, to either side"},
};
const auto& [kStones, kSize, kAside] = kParameters;

void build(Sketch& s) {
  constexpr float kWide = 16, kDepth = 4, kDeeper = 20;
  const uint32_t stones = s.mixCount(kStones);
  for (uint32_t i = 0; i < stones; ++i) {
    const float size = s.mix(kSize), gap = s.gap();
    // An impossible gap has its lava further down, where it cannot serve as a step.
    const float depth = gap > s.reach().gap(0) ? kDeeper + kDepth : kDepth;
    Sketch::deadly(s.part("Lava", {0, -depth - 0.5f, (gap + size) / 2}, {kWide, 1, gap + size}));
    s.floor("Stone", size, size, gap, 0, s.mixEitherSign(kAside));
  }
}

}  // namespace

constinit const Style kKillFloorStyle{.name = "kill-floor",
                                      .description = "stones over lava",
                                      .build = build,
                                      .parameters = kParameters};

}  // namespace obby::gen
