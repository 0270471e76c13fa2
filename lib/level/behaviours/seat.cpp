// Holds a player who touches the part.
#include "level/behaviours/behaviour.h"

namespace obby::level {

Status compileSeat(PartContext& c) {
  Clock clock;  // held at 0 while a player sits; afterwards runs until the seat is free again
  clock.length = ticksFromSeconds(c.params, c.params.seatCooldown) + 2;
  clock.restarts = true;
  clock.seat = c.collider;
  c.roles.seatClock = c.clocks.add(clock);
  c.flags |= kSeat;
  return {};
}

}  // namespace obby::level
