// Sitting: a touched seat holds the player until jump is pressed. The seat's clock identifies it
// and is held at 0 meanwhile. Then the clock runs, and the seat accepts no player until the clock
// is over.
#pragma once

#include "sim/body.h"

namespace obby::sim {

// Returns the running clock of the seat that the player is on, the last one started, or -1.
OBBY_DEVICE int heldSeat(const World& w, const level::LevelView& level) {
  for (int i = w.clockCount - 1; i >= 0; --i) {
    if (level.clocks[w.clocks[i].clock].seat != level::kNone) return i;
  }
  return -1;
}

// Returns the position of a seated player's feet, below the root.
OBBY_DEVICE Vec3 feetOnSeat(const Pose& seat, const Params& p) {
  return toWorld(seat, Vec3{0, p.seatHeight, 0}) - Vec3{0, p.hipHeight + p.rootHeight * 0.5f, 0};
}

// Seats the player if possible. Returns true if the player is seated now.
OBBY_DEVICE bool sitDown(World& w, const level::LevelView& level, uint32_t clock,
                         const Pose& seat) {
  if (w.state == State::seated || findClock(w, clock) >= 0) return false;
  startClock(w, level, clock);
  if (findClock(w, clock) < 0) return false;
  w.state = State::seated;
  w.position = feetOnSeat(seat, level.params);
  w.velocity = {};
  w.yaw = headingOf(-seat.rotation.z.x, -seat.rotation.z.z);
  w.floorlessSteps = 0;
  return true;
}

// Advances a seated player by a tick; the seat may move. Runs after the motion of dynamic bodies.
// `bodies` is null if the level has none. `p` includes the player's boosts.
OBBY_DEVICE void sit(World& w, const RigidBody* bodies, const level::LevelView& level,
                     const Params& p, bool jump) {
  const int i = heldSeat(w, level);
  const uint32_t held = i < 0 ? level::kNone : level.clocks[w.clocks[i].clock].seat;
  if (held == level::kNone || isGone(level.colliders[held], bodies)) {
    w.state = State::freefall;
    return;
  }
  const Pose pose = poseOf(level.colliders[held], w, bodies, level, 1);
  const Vec3 feet = feetOnSeat(pose, p), velocity = (feet - w.position) * float(p.controlRate);
  // A seat that moves faster than the level's max speed was repositioned, as when a motion starts
  // over. Its displacement is then not a speed. Dynamic seats are never repositioned.
  const bool put =
      level.colliders[held].mover != level::kNone && !(bounded(velocity, level) == velocity);
  w.velocity = put ? Vec3{} : velocity;
  w.position = feet;
  w.yaw = headingOf(-pose.rotation.z.x, -pose.rotation.z.z);
  w.clocks[i].ticks = 0;
  if (!jump) return;
  w.state = State::jumping;
  w.landedSteps = 0;  // no held jump
  w.velocity.y += p.jumpSpeed;
  w.jumps = uint16_t(countedOn(int32_t(w.jumps), 1));
  w.floorlessSteps = p.coyoteSteps;  // one jump per take-off
}

}  // namespace obby::sim
