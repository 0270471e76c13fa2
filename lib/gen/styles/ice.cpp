// Slippery lanes with a corner to slide round or a gap to jump at speed.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"lanes", "", 1, 3, 1, 12, "number of lanes"},
    {"width", "studs", 10, 5, 2, 30, "width of a lane"},
    {"friction", "", 0.09f, 0.09f - 0.07f, 0, 2, "friction of the ice"},
    {"length", "studs", 10, 18, 4, 60, "length of a lane"},
};
const auto& [kLanes, kWidth, kFriction, kLength] = kParameters;

// The engine's max friction weight. With it the player's own friction hardly counts.
constexpr float kIceWeight = 100;

void makeIce(PartSketch& part, float friction) {
  part.colored(colors::kIce);
  part.friction = friction;
  part.frictionWeight = kIceWeight;
}

void build(Sketch& s) {
  const uint32_t lanes = s.mixCount(kLanes);
  for (uint32_t i = 0; i < lanes; ++i) {
    const float width = s.mix(kWidth), friction = s.steady(kFriction);
    const float gap = i == 0 ? 0 : s.gap(0, 0.5f), long_ = s.mix(kLength);
    makeIce(s.floor("Ice", long_, width, gap), friction);
    const float corner = width + 2;
    makeIce(s.disc("Ice corner", corner, -width / 4, 0.1f), friction);
    s.via({0, 0, -corner / 2});
    s.bend(corner);
    s.advance(0, -0.1f);
    s.expectWait(1);
  }
  s.floor("Strip", 8, 6);
}

}  // namespace

constinit const Style kIceStyle{.name = "ice",
                                .description = "slippery lanes and corners",
                                .build = build,
                                .parameters = kParameters};

}  // namespace obby::gen
