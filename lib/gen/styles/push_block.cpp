// A wall that is too high to climb, and a block to push to it.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"width", "studs", 16, 22, 12, 40, "width of the yard"},
    {"over", "studs", 1.25f, 2, 1.25f, 3, "how far the wall is above the highest jump"},
    {"away", "studs", 3, 7, 3, 15,
     "how much the distance from the block to the wall exceeds a jump"},
};
const auto& [kWidth, kOver, kAway] = kParameters;

void build(Sketch& s) {
  constexpr float kYard = 34, kBlock = 4, kTerrace = 12;
  constexpr float kBehind = 12;  // clearance behind the block for a player, studs
  constexpr float kTooHigh = 9;  // studs added to an impossible wall, beyond a jump from the block
  const bool fixed = s.broken("block");
  const float width = s.mix(kWidth), over = s.mix(kOver);
  const float high = s.reach().rise() + over + (fixed ? kTooHigh : 0);
  // The block starts so far away that a jump from it does not reach the wall.
  const float away = kBlock / 2 + s.reach().gap(s.reach().rise() + over - kBlock) + s.mix(kAway);
  const float yard = maxf(kYard, away + kBehind);
  const float aside = s.mixEitherSign(0, width / 2 - 5);
  PartSketch& block = s.part("Block", {aside, kBlock / 2, yard - away}, {kBlock, kBlock, kBlock})
                          .colored(colors::kWood);
  block.anchored = fixed;
  block.density = 0.3f;
  s.via({aside, 0, yard - away - kBlock});
  s.via({aside, 0, yard - kBlock});
  s.via({aside, high, yard});
  s.floor("Yard", yard, width);
  s.part("Wall", {0, high / 2 - 0.5f, kTerrace / 2}, {width, high + 1, kTerrace})
      .colored(colors::kWall);
  s.advance(kTerrace, high);
  s.expectWait(6);
  s.expectJumps(2);
}

}  // namespace

constinit const Style kPushBlockStyle{
    .name = "push-block",
    .description = "a block to push to a wall too high to jump over",
    .build = build,
    .parameters = kParameters,
    .single = true};

}  // namespace obby::gen
