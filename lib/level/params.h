// The physics parameters as the simulator reads them. Units, ranges, defaults and sources are in
// struct PhysicsParams of schema/obby.capnp. The names here are the same;
// tests/level/params_test.cpp compares the two.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby {

// X(type, name)
// clang-format off
#define OBBY_FIRST_PARAMS(X) \
  X(float, gravity) X(float, walkSpeed) X(float, jumpSpeed) X(float, maxSlope) \
  X(float, maxHealth) X(float, healthRegeneration) X(float, fallenPartsHeight) \
  X(uint16_t, controlRate) X(uint16_t, substeps) X(float, hipHeight) X(float, rootHeight) \
  X(float, bodyWidth) X(float, bodyDepth) X(float, bodyTop) X(float, headBottom) \
  X(float, armSpan) X(float, touchMargin) X(float, traction) X(float, airAccel) \
  X(float, moveGain) X(float, turnGain) X(float, turnSpeed) X(float, hoverStiffness) \
  X(float, hoverDamping) X(float, hoverLimit) X(float, floorRaySpread) X(float, floorRayStart) \
  X(float, floorReachBase) X(float, floorKeep) X(float, floorAcquire) X(float, fastFall) \
  X(float, landedTime) X(float, coyoteTime) X(float, offFloorGrace) X(float, playerFrictionWeight) \
  X(float, climbSpeed) X(float, climbReach) X(float, contactSkin) X(float, maxFallSpeed) \
  X(float, oneWaySlack) X(float, squeezeDepth) X(float, squeezeTime) X(float, seatHeight) \
  X(float, seatCooldown) \
  X(float, climbLowest) X(float, climbWill) X(float, playerMass) X(float, pushForce) X(float, sleepSpeed) X(float, sleepTime) \
  X(float, playerFriction) X(float, jumpAccel)
// A later parameter counts in a level's digest only if it is not 0, so that old digests stay valid.
#define OBBY_LATER_PARAMS(X) X(uint16_t, airJumps)
#define OBBY_PHYSICS_PARAMS(X) OBBY_FIRST_PARAMS(X) OBBY_LATER_PARAMS(X)
// clang-format on

// Bits of Params::tricks, in the order of the schema's Trick (docs/physics.md, tricks).
enum Trick : uint16_t {
  kHeldJump = 1,
  kHangingLanding = 2,
  kWallHop = 4,
  kLadderFlick = 8,
  kLegThrow = 16,
  kAllTricks = 31
};

struct Params {
#define OBBY_PARAM_FIELD(type, name) type name;
  OBBY_PHYSICS_PARAMS(OBBY_PARAM_FIELD)
#undef OBBY_PARAM_FIELD

  // Derived once per level by level/compile_params.cpp.
  float tickSeconds;     // 1 / controlRate
  float substepSeconds;  // tickSeconds / substeps
  float slopeNormalY;    // cos(maxSlope); players slide down floors whose normal has a smaller Y
  float plainGrip;       // friction of the player on a part with default friction
  uint16_t landedSteps;  // times above, rounded to whole physics steps; at most 255
  uint16_t coyoteSteps;  // this and the step counts below are at least 1
  uint16_t graceSteps;
  uint16_t squeezeTicks;
  uint16_t sleepTicks;

  // These are set by the query or the trajectory, never by the level.
  uint16_t tricks;         // bits of the tricks that the player may use
  uint16_t directionStep;  // turns / 65536 between two headings that the player can walk in, a
                           // power of two; 0 for any heading
  uint16_t directionFrom;  // one of the headings that the player can walk in
};

// Returns a duration in ticks, rounded to the nearest and at most 2^24. Returns 0 for a negative
// duration or NaN.
OBBY_DEVICE uint32_t ticksFromSeconds(const Params& p, float seconds) {
  const float t = seconds * float(p.controlRate) + 0.5f;
  return t >= 1 ? (t < 16777216.0f ? uint32_t(t) : 16777216u) : 0u;
}

// Returns the friction of the player on a floor with this friction and weight.
OBBY_DEVICE float pairFriction(const Params& p, float friction, float weight) {
  const float sum = weight + p.playerFrictionWeight;
  if (!(sum > 0)) return 0.5f * (friction + p.playerFriction);
  return (friction * weight + p.playerFriction * p.playerFrictionWeight) / sum;
}

// Returns the rise of the feet after a launch at `speed` studs/s, in studs. `gravity` must be above
// 0. The first step of a launch is without gravity.
OBBY_DEVICE float riseOfLaunch(const Params& p, float gravity, float speed) {
  return 0.5f * speed * (speed / gravity + p.substepSeconds);
}

// Limits of levels: gravity in studs/s^2, and the factors of a boost. Larger numbers are mistakes,
// and would make the grid's lists long.
constexpr float kMaxGravity = 2000, kMaxBoostFactor = 100;

// Value of Params::airJumps for an unlimited number.
constexpr uint16_t kAnyAirJumps = 100;

// Returns the max reach of the floor rays in any state, as a multiple of hipHeight.
OBBY_DEVICE float farthestFloor(const Params& p) {
  return p.floorKeep > p.floorAcquire ? p.floorKeep : p.floorAcquire;
}

}  // namespace obby
