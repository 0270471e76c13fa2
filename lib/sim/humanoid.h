// The character's state machine and its will: jumping, landing, coyote time, turning, the velocity
// it wants. Runs once a tick, as the engine's runs once a frame.
#pragma once

#include "sim/floor.h"

namespace obby::sim {

// What the physics of this tick's substeps work toward.
template <class F>
struct DriveT {
  Vec3T<F> velocity;        // wanted, horizontal, studs/s
  F limit = 0;              // of horizontal acceleration, studs/s^2
  Vec3T<F> slide;           // acceleration down a floor that is too steep
  MaskOf<F> hover = false;  // the legs hold the body above the floor
};

using Drive = DriveT<float>;

template <class F>
OBBY_DEVICE void updateState(PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                             const ControlT<F>& control) {
  using Int = IntOf<F>;
  using Mask = MaskOf<F>;
  const auto to = [](State s) { return Int(int32_t(s)); };
  w.floorlessTicks = select(floor.sensed, Int(0), oneMore(w.floorlessTicks));
  const Mask running = w.is(State::running), landed = w.is(State::landed);
  const Mask falling = w.is(State::freefall), jumping = w.is(State::jumping);
  const Mask floorLost = w.floorlessTicks >= int32_t(p.graceTicks);

  w.landedTicks = select(landed & (w.landedTicks > 0), w.landedTicks - 1, w.landedTicks);
  Int next = w.state;
  next = select(landed & (w.landedTicks == 0), to(State::running), next);
  next = select((landed | running) & floorLost, to(State::freefall), next);
  // Never while rising: this is what prevents double jumps.
  const Mask lands = falling & floor.sensed & (w.velocity.y <= floor.velocity.y);
  next = select(lands, to(p.landedTicks > 0 ? State::landed : State::running), next);
  w.landedTicks =
      select(lands, Int(p.landedTicks < 255 ? int32_t(p.landedTicks) : 255), w.landedTicks);
  // Until the floor is out of reach, or a ceiling has stopped the rise.
  next = select(jumping & ((w.velocity.y <= 0.0f) | !floor.sensed), to(State::freefall), next);
  const Mask jumps = running & control.jump & (w.floorlessTicks < int32_t(p.coyoteTicks));
  w.state = select(jumps, to(State::jumping), next);
  w.velocity.y = select(jumps, p.jumpSpeed + floor.velocity.y, w.velocity.y);
  w.jumps = select(jumps, oneMore(w.jumps), w.jumps);
  // One jump a take-off.
  w.floorlessTicks = select(jumps, Int(int32_t(p.coyoteTicks)), w.floorlessTicks);
  w.sensed = floor.sensed;
}

// Turns toward the heading: proportional to the angle left, bounded by turnSpeed. A carrying floor
// turns the player too.
template <class F>
OBBY_DEVICE void turn(PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                      const ControlT<F>& control) {
  const F error = toFloat(((control.heading - w.yaw) << 16) >> 16);
  const F most = p.turnSpeed * p.tickSeconds * kTurnsPerRadian;
  const F step = clampf<F>(error * minf(p.turnGain * p.tickSeconds, 1.0f), -most, most);
  // The last quarter degree at once, so that the facing settles.
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
  DriveT<F> d;
  d.hover = standing;
  d.velocity = select(control.walk, directionOf(sinCosOf<F>(control.heading)) * p.walkSpeed, none);
  d.velocity += select(standing, Vec3T<F>{floor.velocity.x, 0, floor.velocity.z}, none);
  // Where it is too steep the player slides; while jumping, move input is ignored, unless the
  // engine is known to heed it.
  const Mask ignored = jumping & (F(p.jumpAccel) <= 0.0f);
  d.velocity = select(steep | ignored, own, d.velocity);
  d.limit = select(standing, F(p.groundAccel), F(p.airAccel));
  d.limit = select(standing & (floor.friction < p.iceFriction),
                   d.limit * (floor.friction / p.iceFriction), d.limit);
  d.limit = select(steep, F(0.0f), select(jumping, F(p.jumpAccel), d.limit));
  d.slide = select(
      steep, Vec3T<F>{floor.normal.x, 0, floor.normal.z} * (p.gravity * floor.normal.y), none);
  return d;
}

}  // namespace obby::sim
