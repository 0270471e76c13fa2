// What carries the player: the floor that is stood on, the truss that is climbed, the seat. Asked
// of a state between two ticks; no tick needs it.
#pragma once

#include "sim/climb.h"
#include "sim/seat.h"

namespace obby::sim {

// Can anything carry in this state? False for all who jump, fall or are dead.
OBBY_DEVICE bool mayBeCarried(const World& w) {
  if (w.state == State::climbing || w.state == State::seated) return true;
  const bool onLegs = w.state == State::running || w.state == State::landed;
  return (onLegs || w.state == State::fallingDown) && (w.flags & kFloorSensed) != 0;
}

// The collider that carries, as the tick after `w` will find it; level::kNone: none does. `loose`:
// (level.looseCount), null where that is 0.
OBBY_DEVICE uint32_t carrierOf(const World& w, const LooseBody* loose,
                               const level::LevelView& level) {
  if (!mayBeCarried(w)) return level::kNone;
  if (w.state == State::seated) {
    const int seat = heldSeat(w, level);
    return seat < 0 ? level::kNone : level.clocks[w.clocks[seat].clock].seat;
  }
  World noted = w;  // overruns are noted in a world
  Candidates near;
  gather(noted, loose, level, level.params, near);
  const Player player = playerOf(w);
  const int found = w.state == State::climbing ? findTruss(player, level, near).candidate
                                               : castFloor(player, level, near).nearest;
  return found < 0 ? level::kNone : near.items[found].collider;
}

}  // namespace obby::sim
