// The player of a world, or of lanes of worlds, in the form that the phases of a tick work on.
// World (world.h) is how it is kept between ticks.
#pragma once

#include "math/angle.h"
#include "sim/world.h"

namespace obby::sim {

template <class F>
struct PlayerT {
  Vec3T<F> position, velocity;
  IntOf<F> yaw;  // [0, 65536)
  IntOf<F> state;
  IntOf<F> floorlessTicks, landedTicks, jumps;
  MaskOf<F> sensed;  // a floor was within reach in the last tick

  OBBY_DEVICE MaskOf<F> is(State s) const { return state == int32_t(s); }
};

using Player = PlayerT<float>;

// One more of what a World counts in 16 bits. Stays at the most, so that no count ever falls.
template <class Int>
OBBY_DEVICE Int oneMore(Int n) {
  return select(n < 0xffff, n + 1, n);
}

// What the player holds during the tick.
template <class F>
struct ControlT {
  IntOf<F> heading;  // [0, 65536)
  MaskOf<F> walk, jump;
};

OBBY_DEVICE Player playerOf(const World& w) {
  return {w.position,       w.velocity,    w.yaw,   int32_t(w.state),
          w.floorlessTicks, w.landedTicks, w.jumps, (w.flags & kFloorSensed) != 0};
}

OBBY_DEVICE void putPlayer(World& w, const Player& p) {
  w.position = p.position;
  w.velocity = p.velocity;
  w.yaw = uint16_t(p.yaw);
  w.state = State(p.state);
  w.floorlessTicks = uint16_t(p.floorlessTicks);
  w.landedTicks = uint8_t(p.landedTicks);
  w.jumps = uint16_t(p.jumps);
  w.flags = uint8_t((w.flags & ~kFloorSensed) | (p.sensed ? kFloorSensed : 0));
}

OBBY_DEVICE ControlT<float> controlOf(Action a) { return {a.heading, a.walk, a.jump}; }

}  // namespace obby::sim
