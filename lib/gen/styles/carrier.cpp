// A physics-driven platform that carries the player through doors across a long gap.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"doors", "", 1, 3, 1, 6, "number of doors"},
    {"size", "studs", 8, 5, 3, 16, "size of the carrier; doors are 2 studs wider"},
    {"apart", "studs", 12, 16, 8, 30,
     "distance from door to door; increased so that no jump can cross it"},
    {"speed", "studs/s", 6, 10, 2, 30, "speed of the carrier"},
    {"gap", "studs", 0.5f, 2, 0.25f, 6, "length of the jumps onto and off the carrier"},
    {"width", "studs", 10, 6, 2, 30, "width of the dock"},
};
const auto& [kDoors, kSize, kApart, kSpeed, kGap, kWidth] = kParameters;

void build(Sketch& s) {
  constexpr float kFast = 1.6f;  // max speed relative to the nominal speed
  const uint32_t doors = s.mixCount(kDoors);
  const float size = s.mix(kSize), apart = s.mix(kApart), speed = s.mix(kSpeed);
  // The gap is too wide to jump, even off a platform at its max speed.
  const float jumped = kProof * s.reach().gap(0) + kFast * speed * s.reach().flight();
  const float between = maxf(apart, jumped / float(doors + 1)),
              distance = between * float(doors + 1);
  const float seconds = distance / speed, gap = s.mix(kGap);
  const float hole = size + 2, side = 10;
  const float high = maxf(12, s.reach().rise() + 3);  // the lintel's top is too high to step on
  const float first = gap + size / 2;
  s.noteCarrier(kFast * speed);
  if (!s.broken("carrier")) {
    MotionSketch m = s.slide({0, -0.5f, first}, {0, -0.5f, first + distance}, seconds, 0);
    m.carries = true;
    m.smooth = false;
    s.part("Carrier", {0, -0.5f, first}, {size, 1, size}).colored(colors::kMoving).moving(m);
    s.expectWait(2 * seconds);
  }
  for (uint32_t i = 1; i <= doors; ++i) {
    const float ahead = first + between * float(i), middle = (hole + side) / 2;
    s.wall("Gate left", -middle, ahead, side, high, 1, -3);
    s.wall("Gate right", middle, ahead, side, high, 1, -3);
    s.part("Lintel", {0, high - 3 + 1, ahead}, {hole + 2 * side, 2, 1}).colored(colors::kWall);
  }
  s.advance(gap + size + distance);
  s.floor("Dock", 6, s.mix(kWidth), gap);
}

}  // namespace

constinit const Style kCarrierStyle{
    .name = "carrier",
    .description = "a platform that carries the player through doors",
    .build = build,
    .parameters = kParameters};

}  // namespace obby::gen
