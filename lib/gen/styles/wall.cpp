// Walls on a floor, which players jump over.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"walls", "", 1, 2, 1, 12, "number of walls"},
    {"width", "studs", 12, 8, 3, 30, "width of floor and walls"},
    {"thickness", "studs", 2, 1, 0.5f, 6, "thickness of a wall"},
};
const auto& [kWalls, kWidth, kThickness] = kParameters;

// Returns the studs by which a wall extends beyond the floor on each side. A player who walks round
// the wall falls too low to return.
float beyondFloor(const Params& p) {
  constexpr float kMax = 30;  // upper bound for low gravity
  return minf(0.5f * p.walkSpeed * sqrtf32(2 * (p.hipHeight + 1) / p.gravity) + 0.5f, kMax);
}

void build(Sketch& s) {
  constexpr float kRoundabout = 30;  // min studs by which an impassable wall is wider on each side
  constexpr float kSure = 0.9f;      // share of the highest jump
  const uint32_t walls = s.mixCount(kWalls);
  const float width = s.mix(kWidth), before = 9, thick = s.mix(kThickness);
  const float behind = 9;
  for (uint32_t i = 0; i < walls; ++i) {
    const float rise = s.straight() ? s.rise() : s.easyRise();
    // The wall is too high to walk over, unless no jump clears that height.
    const float min = minf(s.reach().params().hipHeight + 1, kSure * s.reach().rise());
    const float height = maxf(rise, min);
    const bool high = height > s.reach().rise();
    const float more = high ? s.roundabout(kRoundabout) : beyondFloor(s.reach().params());
    s.wall("Wall", 0, before, width + 2 * more, height, thick);
    s.floor("Floor", before + behind, width);
  }
}

}  // namespace

constinit const Style kWallStyle{
    .name = "wall", .description = "walls to jump over", .build = build, .parameters = kParameters};

}  // namespace obby::gen
