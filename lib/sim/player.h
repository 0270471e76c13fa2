// The player of a world, or of lanes of worlds, in the form that the phases of a tick use. World
// (world.h) is its form between ticks.
#pragma once

#include "level/params.h"
#include "math/angle.h"
#include "sim/world.h"

namespace obby::sim {

template <class F>
struct PlayerT {
  Vec3T<F> position, velocity;
  IntOf<F> yaw;  // [0, 65536)
  IntOf<F> state;
  IntOf<F> floorlessSteps, landedSteps, jumps;
  MaskOf<F> sensed;     // a floor was within reach in the last tick
  MaskOf<F> lifted;     // at the end of the last tick the legs alone made the body rise
  MaskOf<F> leftTruss;  // rises from a jump off a truss
  F freeSteps = 0;      // steps without gravity at the start of this tick

  OBBY_DEVICE MaskOf<F> is(State s) const { return state == int32_t(s); }
};

using Player = PlayerT<float>;

// Adds to a count that a World keeps in 16 bits. The count saturates, so it never wraps around.
template <class Int>
OBBY_DEVICE Int countedOn(Int n, int32_t more) {
  return select(n < 0xffff - more, n + more, Int(0xffff));
}

// The keys that the player holds during the tick.
template <class F>
struct ControlT {
  IntOf<F> heading;  // [0, 65536)
  MaskOf<F> walk, jump;
};

OBBY_DEVICE Player playerOf(const World& w) {
  return {w.position,
          w.velocity,
          w.yaw,
          int32_t(w.state),
          w.floorlessSteps,
          w.landedSteps,
          w.jumps,
          (w.flags & kFloorSensed) != 0,
          (w.flags & kLegsLift) != 0,
          (w.flags & kLeftTruss) != 0};
}

OBBY_DEVICE void putPlayer(World& w, const Player& p) {
  w.position = p.position;
  w.velocity = p.velocity;
  w.yaw = uint16_t(p.yaw);
  w.state = State(p.state);
  w.floorlessSteps = uint16_t(p.floorlessSteps);
  w.landedSteps = uint8_t(p.landedSteps);
  w.jumps = uint16_t(p.jumps);
  w.flags = uint8_t((w.flags & ~kPlayerFlags) | (p.sensed ? kFloorSensed : 0) |
                    (p.lifted ? kLegsLift : 0) | (p.leftTruss ? kLeftTruss : 0));
}

// Returns the nearest heading that the player can walk in.
template <class Int>
OBBY_DEVICE Int walkableHeading(Int wanted, const Params& p) {
  const int32_t between = p.directionStep > 0 ? p.directionStep - 1 : 0, from = p.directionFrom;
  return (((wanted - from + (between + 1) / 2) & (0xffff & ~between)) + from) & 0xffff;
}

OBBY_DEVICE ControlT<float> controlOf(Action a, const Params& p) {
  return {walkableHeading<int32_t>(a.heading, p), a.walk, a.jump};
}

}  // namespace obby::sim
