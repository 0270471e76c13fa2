// Falling down: who has tripped keeps the momentum, has no legs to hover on and no keys, and slides
// until the trip's clock lets go. Like the engine's state of that name, in which limbs collide and
// nothing but friction slows the body; the body stays upright here (docs/parts.md, roles).
#pragma once

#include "sim/body.h"

namespace obby::sim {

// Enters and leaves the FallingDown state, before the tick's phases. A seat holds whom it holds.
OBBY_DEVICE void updateFallingDown(World& w, bool helpless) {
  if (helpless && w.state != State::seated) {
    w.state = State::fallingDown;
  } else if (!helpless && w.state == State::fallingDown) {
    w.state = State::freefall;  // gets up where a floor is: lands at once
  }
}

// Lowest point of the colliding body above the feet.
OBBY_DEVICE float bodyBottom(State state, const Params& p) {
  return state == State::fallingDown ? 0 : state == State::jumping ? p.headBottom : p.hipHeight;
}

// Friction with the floor that the body lies on, and nothing in the air.
OBBY_DEVICE Drive slideDown(const Player& w, const Params& p, const Floor& floor) {
  Drive d;
  d.gravity = p.gravity;
  const bool lies = floor.sensed && floor.gap <= p.touchMargin;
  d.velocity = lies ? floor.velocity : w.velocity;
  d.velocity.y = 0;
  d.limit = lies ? floor.grip * p.gravity : 0.0f;
  return d;
}

}  // namespace obby::sim
