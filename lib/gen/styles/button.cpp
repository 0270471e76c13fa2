// Buttons that open a door or make a bridge appear for a while.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"open", "seconds", 12, 3, 2, 60, "how long the door stays open"},
    {"aside", "studs", 3, 8, 0, 8, "offset of the door button, to either side"},
    {"there", "seconds", 12, 5, 2, 60, "how long the bridge stays"},
    {"beyond", "studs", 6, 10, 6, 30, "how much longer than a jump the bridge is"},
    {"width", "studs", 6, 2, 1, 12, "width of the bridge"},
    {"bankAside", "studs", 0, 4, 0, 4, "offset of the bridge button, to either side"},
};
const auto& [kOpen, kAside, kThere, kBeyond, kWidth, kBankAside] = kParameters;

PartSketch& button(Sketch& s, float right, float forward, float seconds) {
  PartSketch& p = s.part("Button", {right, 0.25f, forward}, {3, 0.5f, 3}).colored(colors::kButton);
  p.button = ButtonSketch{seconds};
  return p;
}

void buildDoor(Sketch& s) {
  constexpr float kRoundabout = 20, kDoor = 6, kRun = 12;
  const float width = 20, seconds = s.mix(kOpen), high = maxf(14.0f, s.reach().rise() + 5);
  const bool shut = s.straight() && s.broken("button");
  // In a solvable level the wall is no wider than necessary, or it would block other obstacles.
  const float overhang = shut ? s.roundabout(kRoundabout) : kRoundabout;
  const float side = (width - kDoor) / 2 + overhang, middle = (kDoor + side) / 2;
  const float aside = s.mixEitherSign(kAside);
  s.wall("Wall", -middle, kRun, side, high, 1);
  s.wall("Wall", middle, kRun, side, high, 1);
  PartSketch& door = s.part("Door", {0, high / 2, kRun}, {kDoor, high, 1}).colored(colors::kFading);
  if (!shut) {
    door.signal = s.signal("door");
    VanishSketch away{schema::VanishTrigger::SIGNAL, 0, 0, 0, false};
    door.vanishing(away);
    const std::string name = door.signal;
    button(s, aside, 4, seconds).signal = name;
  }
  s.via({aside, 0, 4});
  s.via({0, 0, kRun});
  s.floor("Hall", kRun + 8, width);
}

void buildBridge(Sketch& s) {
  const float seconds = s.mix(kThere), gap = s.reach().gap(0) + s.mix(kBeyond);
  const float width = s.mix(kWidth), aside = s.mixEitherSign(kBankAside);
  const bool there = !s.broken("bridge");
  s.floor("Near bank", 10, 12);
  if (there) {
    PartSketch& bridge =
        s.part("Bridge", {0, -0.5f, gap / 2}, {width, 1, gap}).colored(colors::kFading);
    VanishSketch away{schema::VanishTrigger::SIGNAL, 0, 0, 0, true};
    bridge.vanishing(away).signal = s.signal("bridge");
    const std::string name = bridge.signal;
    button(s, aside, -7, seconds).signal = name;
    s.via({aside, 0, -7});
  }
  s.floor("Far bank", 8, 10, gap);
}

void build(Sketch& s) {
  if (s.chance(0.5f)) {
    buildDoor(s);
  } else {
    buildBridge(s);
  }
  s.expectWait(2);
}

}  // namespace

constinit const Style kButtonStyle{
    .name = "button",
    .description = "buttons that open a door or bring a bridge for a while",
    .build = build,
    .parameters = kParameters};

}  // namespace obby::gen
