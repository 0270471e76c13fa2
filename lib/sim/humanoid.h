// The character's state machine and its control: jumping, landing, coyote time, turning, and the
// wanted velocity. It runs once per tick, as the engine's runs once per frame.
#pragma once

#include "sim/floor.h"

namespace obby::sim {

// Targets of the physics in this tick's substeps.
template <class F>
struct DriveT {
  Vec3T<F> velocity;        // wanted, horizontal, studs/s
  F limit = 0;              // max horizontal acceleration, studs/s^2
  Vec3T<F> slide;           // acceleration down a floor that is too steep
  MaskOf<F> hover = false;  // the legs hold the body above the floor
  MaskOf<F> hangs = false;  // the body hangs above the floor and slows to a stop (a trick)
  F freeSteps = 0;          // steps without gravity at the start of the tick
  float gravity = 0;        // gravity of the player, studs/s^2
};

using Drive = DriveT<float>;

// Returns the speed up and down a truss, studs/s.
OBBY_DEVICE float climbSpeedOf(const Params& p) { return p.climbSpeed * p.walkSpeed; }

// Angle that the body must turn for a held jump, radians (measured at a turn rate of 1.15 rad/s).
constexpr float kHeldJumpTurn = 0.137f;

// Returns the signed angle from the facing to the heading, turns / 65536.
template <class F>
OBBY_DEVICE F turnLeft(const PlayerT<F>& w, const ControlT<F>& control) {
  return toFloat(((control.heading - w.yaw) << 16) >> 16);
}

// Wall hops and corner flips: in the air the player can face any heading at once, as with the
// camera locked behind the body. The floor rays then start inside the wall, before the body is
// pushed out. A seam or a corner of the wall thus counts as a floor. Runs before the floor is
// sensed.
template <class F>
OBBY_DEVICE void faceAtOnce(PlayerT<F>& w, const Params& p, const ControlT<F>& control) {
  if (!(p.tricks & kWallHop)) return;
  w.yaw = select(w.is(State::freefall) & control.walk, control.heading, w.yaw);
}

// Held jumps: a jump that begins while the body turns continues without gravity while a floor is
// sensed. landedSteps, which has no other use in this state, marks it. `jumping` is true if the
// jump began in an earlier tick, `jumps` if it begins in this one.
template <class F>
OBBY_DEVICE void holdJump(PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                          const ControlT<F>& control, MaskOf<F> jumping, MaskOf<F> jumps) {
  using Int = IntOf<F>;
  const MaskOf<F> turns =
      control.walk & (absf(turnLeft(w, control)) >= kHeldJumpTurn * kTurnsPerRadian);
  const MaskOf<F> goesOn = jumping & (w.landedSteps > 0) & floor.sensed & (w.velocity.y > 0.0f);
  const MaskOf<F> held = (jumps & turns) | goesOn;
  w.landedSteps = select(jumps | jumping, select(held, Int(1), Int(0)), w.landedSteps);
  w.state = select(goesOn, Int(int32_t(State::jumping)), w.state);
  w.freeSteps = select(held, F(float(p.substeps)), w.freeSteps);
}

// A torso that rests on an edge supports the body even if no floor ray finds the edge. For
// kHangSteps the player may pull itself up. After that the legs hang in the air and the player
// cannot move, neither along the edge nor against a belt (a guess: no recording shows it).
// landedSteps, which has no other use in this state, counts the steps.
constexpr int32_t kHangSteps = 24;     // steps of 1/240 s
constexpr float kHangFriction = 0.3f;  // plastic on plastic

template <class F>
OBBY_DEVICE void countHanging(PlayerT<F>& w, const Params& p, const FloorT<F>& floor) {
  using Int = IntOf<F>;
  const MaskOf<F> falls = w.is(State::freefall);
  const MaskOf<F> hangs = falls & (!floor.sensed) & (w.velocity.y == 0.0f);
  const Int more = w.landedSteps + int32_t(p.substeps);
  const Int counted = select(w.landedSteps < kHangSteps, more, w.landedSteps);
  w.landedSteps = select(falls, select(hangs, counted, Int(0)), w.landedSteps);
}

template <class F>
OBBY_DEVICE MaskOf<F> isCaught(const PlayerT<F>& w) {
  return w.is(State::freefall) & (w.landedSteps >= kHangSteps);
}

template <class F>
OBBY_DEVICE void updateState(PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                             const ControlT<F>& control) {
  using Int = IntOf<F>;
  using Mask = MaskOf<F>;
  const auto to = [](State s) { return Int(int32_t(s)); };
  w.floorlessSteps = select(floor.sensed, Int(0), countedOn(w.floorlessSteps, p.substeps));
  const Mask running = w.is(State::running), landed = w.is(State::landed);
  const Mask falling = w.is(State::freefall), jumping = w.is(State::jumping);
  // The legs lift the body to the floor's height, but throw it no higher.
  if (!(p.tricks & kLegThrow)) {
    const Mask thrown = (landed | running) & w.lifted & ((!floor.sensed) | (floor.gap > 0.0f));
    const F risesWith = maxf(floor.velocity.y, F(0.0f));
    w.velocity.y = select(thrown, minf(w.velocity.y, risesWith), w.velocity.y);
  }
  w.leftTruss = w.leftTruss & (w.velocity.y > climbSpeedOf(p));
  const Mask floorLost = w.floorlessSteps >= int32_t(p.graceSteps);

  const Int left = w.landedSteps - int32_t(p.substeps);
  w.landedSteps = select(landed, select(left > 0, left, Int(0)), w.landedSteps);
  Int next = w.state;
  next = select(landed & (w.landedSteps == 0), to(State::running), next);
  next = select((landed | running) & floorLost, to(State::freefall), next);
  // A rising player never lands, which prevents double jumps.
  const Mask lands = falling & floor.sensed & (w.velocity.y <= floor.velocity.y);
  next = select(lands, to(p.landedSteps > 0 ? State::landed : State::running), next);
  // The tick of the landing is counted.
  const Int after = Int(int32_t(p.landedSteps) - int32_t(p.substeps));
  w.landedSteps = select(lands, select(after > 0, after, Int(0)), w.landedSteps);
  next = select(jumping, to(State::freefall), next);
  const Mask jumps = running & control.jump & (w.floorlessSteps < int32_t(p.coyoteSteps));
  w.state = select(jumps, to(State::jumping), next);
  w.freeSteps = select(jumps, F(1.0f), F(0.0f));
  w.velocity.y = select(jumps, p.jumpSpeed + floor.velocity.y, w.velocity.y);
  w.jumps = select(jumps, countedOn(w.jumps, 1), w.jumps);
  if (p.tricks & kHeldJump) holdJump(w, p, floor, control, jumping, jumps);
  // Ends the coyote time at the jump, so that a take-off allows only one jump.
  w.floorlessSteps = select(jumps, Int(int32_t(p.coyoteSteps)), w.floorlessSteps);
  countHanging(w, p, floor);
  w.sensed = floor.sensed;
}

// Turns toward the heading, in proportion to the angle left and at most at turnSpeed. A carrying
// floor turns the player, too.
template <class F>
OBBY_DEVICE void turn(PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                      const ControlT<F>& control) {
  const F error = turnLeft(w, control);
  // The turn speed is limited only in the air.
  const F max =
      select(w.is(State::freefall), F(p.turnSpeed * p.tickSeconds * kTurnsPerRadian), F(65536.0f));
  const F step = clampf<F>(error * minf(p.turnGain * p.tickSeconds, 1.0f), -max, max);
  // The last quarter degree is turned at once, so that the facing settles.
  const IntOf<F> toward =
      select(absf(error) < 46.0f, control.heading, (w.yaw + toInt(step)) & 0xffff);
  w.yaw = select(control.walk & !w.is(State::jumping), toward, w.yaw);
  const IntOf<F> carried = toInt(floor.turning * p.tickSeconds * kTurnsPerRadian);
  w.yaw = select(floor.sensed, (w.yaw + carried) & 0xffff, w.yaw);
}

template <class F>
OBBY_DEVICE DriveT<F> drive(const PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                            const ControlT<F>& control) {
  using Mask = MaskOf<F>;
  const Vec3T<F> none{}, own{w.velocity.x, 0, w.velocity.z};
  const Mask standing = (w.is(State::running) | w.is(State::landed)) & floor.sensed;
  const Mask jumping = w.is(State::jumping);
  const Mask steep = standing & (floor.normal.y < p.slopeNormalY);
  // On a slope, the speed along the slope is the walk speed.
  const Vec3T<F> along = directionOf(sinCosOf<F>(control.heading));
  const F rise = (along.x * floor.normal.x + along.z * floor.normal.z) / floor.normal.y;
  const F level = select(standing, 1.0f / sqrtf32(1.0f + rise * rise), F(1.0f));
  DriveT<F> d;
  d.gravity = p.gravity;
  d.hover = standing;
  if (p.tricks & kHangingLanding) {
    d.hangs = w.is(State::landed) & floor.sensed & control.walk;
  }
  d.freeSteps = w.freeSteps;
  d.velocity = select(control.walk, along * (p.walkSpeed * level), none);
  d.velocity += select(standing, Vec3T<F>{floor.velocity.x, 0, floor.velocity.z}, none);
  // On a floor that is too steep the player slides. While jumping, move input is ignored, unless
  // the engine is known to obey it.
  const Mask ignored = jumping & (F(p.jumpAccel) <= 0.0f);
  d.velocity = select(steep | ignored, own, d.velocity);
  d.limit = select(standing, p.traction * floor.grip, F(p.airAccel));
  d.limit = select(steep, F(0.0f), select(jumping, F(p.jumpAccel), d.limit));
  const Mask caught = isCaught(w);
  d.velocity = select(caught, none, d.velocity);
  d.limit = select(caught, F(kHangFriction * p.gravity), d.limit);
  d.slide = select(
      steep, Vec3T<F>{floor.normal.x, 0, floor.normal.z} * (p.gravity * floor.normal.y), none);
  return d;
}

}  // namespace obby::sim
