// A platform that physics moves carries the player over a long gap, through doors.
#include "gen/styles/all.h"

namespace obby::gen {

void buildCarrier(Sketch& s) {
  constexpr float kFast = 1.6f;  // of its speed, at most
  const uint32_t doors = s.mixCount(1, 3);
  const float size = s.mix(8, 5), apart = s.mix(12, 16), speed = s.mix(6, 10);
  // Nobody jumps over what it carries over, not even off something as fast.
  const float jumped = kProof * s.reach().gap(0) + kFast * speed * s.reach().flight();
  const float between = maxf(apart, jumped / float(doors + 1)), way = between * float(doors + 1);
  const float seconds = way / speed, gap = s.mix(0.5f, 2);
  const float hole = size + 2, side = 10;
  const float high = maxf(12, s.reach().rise() + 3);  // the lintel's top is no step on the way
  const float first = gap + size / 2;
  s.noteCarrier(kFast * speed);
  if (!s.broken("carrier")) {
    MotionSketch m = s.slide({0, -0.5f, first}, {0, -0.5f, first + way}, seconds, 0);
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
  s.advance(gap + size + way);
  s.floor("Dock", 6, s.mix(10, 6), gap);
}

}  // namespace obby::gen
