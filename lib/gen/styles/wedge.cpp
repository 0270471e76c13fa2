// Ramps: a wedge up to a terrace beyond a jump, and another one down.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"width", "studs", 10, 4, 2, 30, "width of ramps and floors"},
    {"height", "studs", 2, 8, 2, 40, "how far the terrace is above the highest jump"},
    {"steepness", "", 0.5f, 2, 0.25f, 2, "height of a ramp divided by its length"},
    {"terrace", "studs", 14, 8, 4, 40, "length of the terrace"},
    {"drop", "studs", 4, 10, 1, 15, "height of the ramp down, if there is one"},
};
const auto& [kWidth, kHeight, kSteep, kTerrace, kDrop] = kParameters;

void build(Sketch& s) {
  constexpr float kSlide = 5;  // studs/s that a player gains on a slope
  const float width = s.mix(kWidth), up = s.highLedge(kHeight), steep = s.mix(kSteep);
  s.floor("Foot", 6, width);
  if (s.broken("ramp")) {
    constexpr float kTooHigh = 3;
    s.wall("Cliff", 0, 2, width, up + kTooHigh, 4);
    s.advance(4, up + kTooHigh);
  } else {
    // A wedge's vertical face is at its back. Turned by half a turn, the wedge rises ahead.
    const float run = up / steep;
    s.part("Ramp", {0, up / 2, run / 2}, {width, up, run})
        .shaped(schema::Shape::WEDGE)
        .turned(kAbout)
        .colored(s.shade());
    s.advance(run, up);
    s.noteCarrier(kSlide);
  }
  s.floor("Terrace", s.mix(kTerrace), width);
  if (s.chance(0.5f)) {
    const float down = s.mix(kDrop), run = down / steep;
    s.part("Ramp down", {0, -down / 2, run / 2}, {width, down, run})
        .shaped(schema::Shape::WEDGE)
        .colored(s.shade());
    s.advance(run, -down);
    s.floor("Floor", 8, width);
  }
}

}  // namespace

constinit const Style kWedgeStyle{
    .name = "wedge", .description = "ramps up and down", .build = build, .parameters = kParameters};

}  // namespace obby::gen
