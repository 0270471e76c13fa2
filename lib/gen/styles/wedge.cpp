// Ramps: up a wedge to a terrace beyond a jump, and down another.
#include "gen/styles/all.h"

namespace obby::gen {

void buildWedge(Sketch& s) {
  constexpr float kSlide = 5;  // studs/s that a player gains on a slope
  const float width = s.mix(10, 4), up = s.highLedge(2, 8), steep = s.mix(0.5f, 2);
  s.floor("Foot", 6, width);
  if (s.broken("ramp")) {
    constexpr float kTooHigh = 3;
    s.wall("Cliff", 0, 2, width, up + kTooHigh, 4);
    s.advance(4, up + kTooHigh);
  } else {
    // Its vertical face is at its back: turned about, it rises ahead.
    const float run = up / steep;
    s.part("Ramp", {0, up / 2, run / 2}, {width, up, run})
        .shaped(schema::Shape::WEDGE)
        .turned(kAbout)
        .colored(s.shade());
    s.advance(run, up);
    s.noteCarrier(kSlide);
  }
  s.floor("Terrace", s.mix(14, 8), width);
  if (s.chance(0.5f)) {
    const float down = s.mix(4, 10), run = down / steep;
    s.part("Ramp down", {0, -down / 2, run / 2}, {width, down, run})
        .shaped(schema::Shape::WEDGE)
        .colored(s.shade());
    s.advance(run, -down);
    s.floor("Floor", 8, width);
  }
}

}  // namespace obby::gen
