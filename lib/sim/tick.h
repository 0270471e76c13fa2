// One tick for one world. Decides the order of phases; each phase is a header of its own.
// Deterministic: equal state, level and action in, equal bits out on every backend
// (docs/determinism.md).
#pragma once

#include "sim/touch.h"

namespace obby::sim {

OBBY_DEVICE void regenerate(World& w, const Params& p) {
  if (w.hurtTicks > 0) --w.hurtTicks;
  if (w.health < p.maxHealth) {
    w.health = minf(p.maxHealth, w.health + p.healthRegeneration * p.maxHealth * p.tickSeconds);
  }
}

// Advances `w` by one tick. Nothing happens to a world whose playthrough has ended. Never
// allocates; overruns set bits in w.flags.
OBBY_DEVICE void tick(World& w, const level::LevelView& level, Action action) {
  if (w.outcome != Outcome::running) return;
  const Params& p = level.params;
  Candidates near;
  gather(w, level, near);
  const Floor floor = senseFloor(w, level, near);
  updateState(w, p, floor, action);
  w.flags = uint8_t((w.flags & ~kFloorSensed) | (floor.sensed ? kFloorSensed : 0));
  turn(w, p, action);
  if (floor.sensed)
    w.yaw = uint16_t(w.yaw + int32_t(floor.turning * p.tickSeconds * kTurnsPerRadian));
  moveBody(w, level, near, floor, drive(w, p, floor, action));
  runVanishing(w, level);
  touchParts(w, level, near);
  regenerate(w, p);
  w.tick += 1;
  if (w.outcome == Outcome::running && w.position.y < p.fallenPartsHeight) {
    w.state = State::dead;
    w.outcome = Outcome::fell;
  }
}

}  // namespace obby::sim
