// Falling down: a player who has tripped keeps the momentum, does not hover, has no control, and
// slides until the trip's clock is over. In the engine's state of this name, limbs collide and only
// friction slows the body. Here the body stays upright (docs/parts.md, roles).
#pragma once

#include "sim/body.h"

namespace obby::sim {

// Enters and leaves the FallingDown state, before the tick's phases. A seated player stays seated.
OBBY_DEVICE void updateFallingDown(World& w, bool helpless) {
  if (helpless && w.state != State::seated) {
    w.state = State::fallingDown;
  } else if (!helpless && w.state == State::fallingDown) {
    w.state = State::freefall;  // on a floor, the player lands at once
  }
}

// Returns the lowest point of the colliding body above the feet.
OBBY_DEVICE float bodyBottom(State state, const Params& p) {
  return state == State::fallingDown ? 0 : state == State::jumping ? p.headBottom : p.hipHeight;
}

// Returns the drive of a body that lies down: friction with the floor, and nothing in the air.
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
