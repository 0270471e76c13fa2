// A road that points at the goal but ends before it. The real route leaves the road sideways and
// goes round on planks.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"plank", "studs", 12, 9, 6, 30, "length of a plank; increased so that no jump can skip one"},
    {"width", "studs", 6, 3.5f, 2, 8, "width of a plank"},
    {"short", "studs", 0, 4, 0, 20, "how much shorter the dead end is than the planks"},
    {"road", "studs", 6, 3, 2, 8, "width of the dead end"},
};
const auto& [kPlank, kWidth, kShort, kRoad] = kParameters;

void build(Sketch& s) {
  constexpr float kTooWide = 1.3f;
  constexpr float kPad = 8, kSpare = 6;  // studs beyond a jump from the road's end
  const float widest = s.reach().gap(0), plank = s.mix(kPlank), width = s.mix(kWidth);
  // Each plank is needed: the gap without it is too wide to jump.
  const float hop = s.sideGap(0.75f), long_ = maxf(plank, kTooWide * widest - 2 * hop);
  const float step = long_ + hop, side = s.side();
  const uint32_t out = 1 + uint32_t((widest + kSpare) / step), along = out + 1;
  s.floor("Fork", kPad, kPad);
  // The planks go out to the side, along, and back, from the middle of the pad.
  const float row = -kPad / 2, far = kPad / 2 + step * float(out) + width / 2;
  const auto across = [&](uint32_t i, float ahead) {
    const float right = kPad / 2 + hop + long_ / 2 + step * float(i);
    s.part("Plank", {side * right, -0.5f, ahead}, {long_, 1, width}).colored(s.shade());
  };
  const float length = step * float(along) + hop + width;
  for (uint32_t i = 0; i < out; ++i) across(i, row);
  for (uint32_t i = 0; i < along; ++i) {
    const float ahead = row + width / 2 + hop + long_ / 2 + step * float(i);
    if (s.broken("plank")) continue;
    s.part("Plank", {side * far, -0.5f, ahead}, {width, 1, long_}).colored(s.shade());
  }
  for (uint32_t i = 0; i < out; ++i) across(out - 1 - i, row + length);
  const float end = row + length - kPad / 2,
              road = maxf(end - widest - kSpare - s.mix(kShort), 4.0f);
  s.part("Dead end", {0, -0.5f, road / 2}, {s.mix(kRoad), 1, road}).colored(s.shade());
  s.expectJumps(2 * out + along + 2);
  s.expectRoute(2 * far);
  s.via({0, 0, row});
  s.via({side * far, 0, row});
  s.via({side * far, 0, row + length});
  s.via({0, 0, row + length});
  s.advance(end);
  s.floor("Way out", kPad, kPad);
}

}  // namespace

constinit const Style kDecoyStyle{.name = "decoy",
                                  .description = "a dead end, and the route around it",
                                  .build = build,
                                  .parameters = kParameters,
                                  .single = true,
                                  .wide = true};

}  // namespace obby::gen
