// Stones to either side, up and down. Each jump goes in another direction than the last.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"stones", "", 3, 6, 1, 12, "number of stones"},
    {"size", "studs", 6, 3, 2, 20, "size of a stone"},
    {"up", "studs", 0, 4, 0, 6, "how much higher the next stone is, in an upward jump"},
    {"down", "studs", 0, 3, 0, 12, "how much lower the next stone is, in a downward jump"},
    {"slant", "", 0.25f, 0.85f, 0, 0.85f, "max share of a jump that goes sideways"},
};
const auto& [kStones, kSize, kUp, kDown, kSlant] = kParameters;

void build(Sketch& s) {
  const uint32_t stones = s.mixCount(kStones);
  const float max = 0.6f * s.reach().rise();
  float side = s.side();
  for (uint32_t i = 0; i < stones; ++i, side = -side) {
    const float size = s.mix(kSize), up = s.chance(0.5f) ? minf(s.mix(kUp), max) : -s.mix(kDown);
    const float gap = s.gap(up);
    // An impossible gap goes straight ahead, where its width is exact.
    const float slant = side * s.mix(kSlant), lean = slant * s.unit();
    const float aim = gap < s.reach().gap(up) ? lean : 0;
    const float ahead = sqrtf32(1 - aim * aim);
    s.floor("Stone", size, size, gap * ahead, up, (gap + size) * aim);
    s.via({0, 0, -size / 2});
  }
}

}  // namespace

constinit const Style kZigzagStyle{.name = "zigzag",
                                   .description = "stones to either side, up and down",
                                   .build = build,
                                   .parameters = kParameters};

}  // namespace obby::gen
