// Finds the floor, truss or seat that carries the player. It is for callers between ticks; a tick
// does not use it.
#pragma once

#include "sim/climb.h"
#include "sim/seat.h"

namespace obby::sim {

// Returns true if something can carry the player in this state. A player who jumps, falls or is
// dead is not carried.
OBBY_DEVICE bool mayBeCarried(const World& w) {
  if (w.state == State::climbing || w.state == State::seated) return true;
  const bool onLegs = w.state == State::running || w.state == State::landed;
  return (onLegs || w.state == State::fallingDown) && (w.flags & kFloorSensed) != 0;
}

// Returns the collider that carries the player, as the tick after `w` will find it, or
// level::kNone. `bodies` has level.bodyCount bodies, or is null if there are none.
OBBY_DEVICE uint32_t carrierOf(const World& w, const RigidBody* bodies,
                               const level::LevelView& level) {
  if (!mayBeCarried(w)) return level::kNone;
  if (w.state == State::seated) {
    const int seat = heldSeat(w, level);
    return seat < 0 ? level::kNone : level.clocks[w.clocks[seat].clock].seat;
  }
  World noted = w;  // gather() notes overruns in a world
  Candidates near;
  gather(noted, bodies, level, level.params, near);
  const Player player = playerOf(w);
  const int found = w.state == State::climbing ? findTruss(player, level, near).candidate
                                               : castFloor(player, level, near).nearest;
  return found < 0 ? level::kNone : near.items[found].collider;
}

}  // namespace obby::sim
