// Belts that run against, across or along the route.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"belts", "", 1, 3, 1, 12, "number of belts"},
    {"length", "studs", 10, 20, 4, 60, "length of a belt"},
    {"width", "studs", 10, 5, 2, 30, "width of a belt"},
    {"against", "", 0.25f, 0.75f, 0, 0.75f,
     "speed of belts against the player, as a share of the walking speed"},
    {"along", "", 0.25f, 0.5f, 0, 1,
     "speed of belts along and across the route, as a share of the walking speed"},
    {"floor", "studs", 9, 6, 2, 30, "width of the floor behind a belt"},
};
const auto& [kBelts, kLength, kWidth, kAgainst, kAlong, kFloor] = kParameters;

void build(Sketch& s) {
  const uint32_t belts = s.mixCount(kBelts);
  for (uint32_t i = 0; i < belts; ++i) {
    const float long_ = s.mix(kLength), width = s.mix(kWidth), walk = s.reach().params().walkSpeed;
    const uint32_t kind = s.below(3);
    const float share = kind == 0 ? s.mix(kAgainst) : s.mix(kAlong);
    const float speed = minf(walk, 40.0f) * share;
    const Vec3 heading = kind == 0   ? Vec3{0, 0, -1}
                         : kind == 1 ? Vec3{s.side(), 0, 0}
                                     : Vec3{0, 0, 1};
    const Vec3 velocity = s.direction(heading * speed);
    s.noteCarrier(speed);
    s.floor("Belt", long_, width).colored(colors::kBelt).conveyor = velocity;
    s.floor("Floor", 6, s.mix(kFloor));
    s.expectWait(kind == 0 ? long_ / maxf(walk - speed, 1.0f) : 1.0f);
  }
}

}  // namespace

constinit const Style kConveyorStyle{
    .name = "conveyor",
    .description = "belts that run against, across and along the route",
    .build = build,
    .parameters = kParameters};

}  // namespace obby::gen
