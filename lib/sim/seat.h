// Sitting: a touched seat holds the player until jump is pressed. Which seat it is tells its clock,
// which is held at 0 meanwhile; then it runs, and until it is over the seat does not take again.
#pragma once

#include "sim/body.h"

namespace obby::sim {

// The running clock of the seat that the player is on: the last to be started; -1: none.
OBBY_DEVICE int heldSeat(const World& w, const level::LevelView& level) {
  for (int i = w.clockCount - 1; i >= 0; --i) {
    if (level.clocks[w.clocks[i].clock].seat != level::kNone) return i;
  }
  return -1;
}

// Where the feet of one who sits are, below the root.
OBBY_DEVICE Vec3 feetOnSeat(const Pose& seat, const Params& p) {
  return toWorld(seat, Vec3{0, p.seatHeight, 0}) - Vec3{0, p.hipHeight + p.rootHeight * 0.5f, 0};
}

// True: the player sits there now.
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

// A tick on a seat, which may move; comes after the loose bodies' motion. `loose`: null where the
// level has none; `p`: with the player's boosts.
OBBY_DEVICE void sit(World& w, const LooseBody* loose, const level::LevelView& level,
                     const Params& p, bool jump) {
  const int i = heldSeat(w, level);
  const uint32_t held = i < 0 ? level::kNone : level.clocks[w.clocks[i].clock].seat;
  if (held == level::kNone || isGone(level.colliders[held], loose)) {
    w.state = State::freefall;
    return;
  }
  const Pose pose = poseOf(level.colliders[held], w, loose, level, 1);
  const Vec3 feet = feetOnSeat(pose, p), velocity = (feet - w.position) * float(p.controlRate);
  // What goes farther in a tick than anything moves, as at the end of a motion that begins anew,
  // was put there: that is no speed. Loose seats are never put anywhere.
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
  w.floorlessSteps = p.coyoteSteps;  // one jump a take-off
}

}  // namespace obby::sim
