// The character's state machine and its will: jumping, landing, coyote time, turning, the velocity
// it wants. Runs once a tick, as the engine's runs once a frame.
#pragma once

#include "sim/floor.h"

namespace obby::sim {

// What the physics of this tick's substeps work toward.
struct Drive {
  Vec3 velocity;       // wanted, horizontal, studs/s
  float limit = 0;     // of horizontal acceleration, studs/s^2
  Vec3 slide;          // acceleration down a floor that is too steep
  bool hover = false;  // the legs hold the body above the floor
};

OBBY_DEVICE void startJump(World& w, const Params& p, const Floor& floor) {
  w.state = State::jumping;
  w.velocity.y = p.jumpSpeed + floor.velocity.y;
  w.jumps = uint16_t(w.jumps + 1);
  w.floorlessTicks = p.coyoteTicks;  // one jump a take-off
}

OBBY_DEVICE void updateState(World& w, const Params& p, const Floor& floor, Action action) {
  w.floorlessTicks =
      floor.sensed ? uint16_t(0) : uint16_t(w.floorlessTicks + (w.floorlessTicks < 0xffff));
  switch (w.state) {
    case State::landed:
      if (w.landedTicks > 0) --w.landedTicks;
      if (w.floorlessTicks >= p.graceTicks) {
        w.state = State::freefall;
      } else if (w.landedTicks == 0) {
        w.state = State::running;
      }
      break;
    case State::freefall:
      // Never while rising: this is what prevents double jumps.
      if (floor.sensed && w.velocity.y <= floor.velocity.y) {
        w.state = State::landed;
        w.landedTicks = uint8_t(p.landedTicks < 255 ? p.landedTicks : 255);
      }
      break;
    case State::jumping:
      // Until the floor is out of reach, or a ceiling has stopped the rise.
      if (!floor.sensed || w.velocity.y <= 0) w.state = State::freefall;
      break;
    case State::running:
      if (action.jump && w.floorlessTicks < p.coyoteTicks) {
        startJump(w, p, floor);
      } else if (w.floorlessTicks >= p.graceTicks) {
        w.state = State::freefall;
      }
      break;
    case State::dead: break;
  }
}

// Turns toward the heading: proportional to the angle left, bounded by turnSpeed.
OBBY_DEVICE void turn(World& w, const Params& p, Action action) {
  if (!action.walk || w.state == State::jumping) return;
  const float error = float(int16_t(uint16_t(action.heading - w.yaw)));
  const float most = p.turnSpeed * p.tickSeconds * kTurnsPerRadian;
  const float step = clampf(error * minf(p.turnGain * p.tickSeconds, 1.0f), -most, most);
  // The last quarter degree at once, so that the facing settles.
  w.yaw = absf(error) < 46.0f ? action.heading : uint16_t(w.yaw + int32_t(step));
}

OBBY_DEVICE Drive drive(const World& w, const Params& p, const Floor& floor, Action action) {
  Drive d;
  const bool standing = (w.state == State::running || w.state == State::landed) && floor.sensed;
  d.hover = standing;
  if (w.state == State::jumping) {  // move input is ignored: the body keeps its velocity
    d.velocity = {w.velocity.x, 0, w.velocity.z};
    return d;
  }
  d.limit = standing ? p.groundAccel : p.airAccel;
  if (action.walk) d.velocity = directionOf(sinCos(action.heading)) * p.walkSpeed;
  if (!standing) return d;
  d.velocity += Vec3{floor.velocity.x, 0, floor.velocity.z};
  if (floor.friction < p.iceFriction) d.limit *= floor.friction / p.iceFriction;
  if (floor.normal.y < p.slopeNormalY) {
    d.velocity = {w.velocity.x, 0, w.velocity.z};
    d.limit = 0;
    d.slide = Vec3{floor.normal.x, 0, floor.normal.z} * (p.gravity * floor.normal.y);
  }
  return d;
}

}  // namespace obby::sim
