// Stones with gaps between them, slightly up or down. They get smaller and further apart with
// difficulty.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"stones", "", 2, 4, 1, 12, "number of stones"},
    {"up", "studs", 0, 2, 0, 4, "how much higher or lower the next stone is"},
    {"size", "studs", 7, 4, 2, 30, "size of a stone"},
    {"aside", "studs", 0, 1.5f, 0, 3, "offset of a stone, to either side"},
};
const auto& [kStones, kUp, kSize, kAside] = kParameters;

void build(Sketch& s) {
  const uint32_t stones = s.mixCount(kStones);
  for (uint32_t i = 0; i < stones; ++i) {
    const float up = s.mixEitherSign(kUp), size = s.mix(kSize);
    const float aside = s.mixEitherSign(kAside);
    s.floor("Stone", size, size, s.gap(up), up, aside);
  }
}

}  // namespace

constinit const Style kGapsStyle{.name = "gaps",
                                 .description = "stones with gaps between them",
                                 .build = build,
                                 .parameters = kParameters};

}  // namespace obby::gen
