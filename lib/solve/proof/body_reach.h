// How far legs, rays and limbs of a player reach, at most: what the bound on reach has to know of a
// body. Every number in the player's favour.
#pragma once

#include <algorithm>

#include "sim/body.h"
#include "solve/proof/braked_fall.h"
#include "solve/proof/felt_floor.h"

namespace obby::solve {

constexpr float kSlack = 0.25f;  // studs: skin, ticks, rounding

// Studs in a part that push no body anywhere.
inline float flushDepth(const Params& p) {
  return std::min(0.1f, 0.25f * std::min(p.bodyWidth, p.bodyDepth));
}

// How far above a floor the legs keep it.
inline float floorReach(const Params& p) {
  const float kept = std::max(feltAtRest(p), 0.0f);
  // Who falls fast feels a floor from far above it. Being Landed lasts until they are down; without
  // it they may jump up there, as who is Running still, for so long after the last floor.
  const float graced = p.gravity * (float(p.graceSteps) * p.substepSeconds + p.tickSeconds);
  const float fall = landedTicksOf(p) >= 2 ? std::min(graced, p.maxFallSpeed) : p.maxFallSpeed;
  const float felt = std::max(fall - p.fastFall, 0.0f) * 0.01f + fall * p.tickSeconds;
  return landedTicksOf(p) >= 2 ? std::max(kept, felt) : kept + felt;
}

// How far above a floor a jump can begin, or a fall anew.
inline float takeOffReach(const Params& p) {
  return std::max(floorReach(p), BrakedFall(p).highest());
}

// The hover spring let go at its deepest: gives seen(gap, up) the height of the feet above the
// floor, and their speed upward, after each substep.
template <class Seen>
void riseOnSpring(const Params& p, Seen&& seen) {
  float gap = -(sim::rayHeight(p) + kSlack), speed = 0;
  for (int i = 0; i < 2 * p.controlRate * p.substeps; ++i) {
    const float a =
        std::clamp(-p.hoverStiffness * gap - p.hoverDamping * speed, -p.gravity, p.hoverLimit);
    gap += speed * p.substepSeconds + a * (0.5f * p.substepSeconds * p.substepSeconds);
    speed += a * p.substepSeconds;
    seen(gap, std::max(speed, 0.0f));
  }
}

// How far above the floor the legs can leave the feet, or throw them: the hover spring let go at
// its deepest, and the reach in which they jump.
inline float springRise(const Params& p) {
  float most = takeOffReach(p);
  riseOnSpring(
      p, [&](float gap, float up) { most = std::max(most, gap + up * up / (2 * p.gravity)); });
  return most + kSlack;
}

// A floor that goes up at `floorSpeed` leads somebody as far in the tick that loses it, and leaves
// them `speed`: the speed upward, squared, with which they come as high from where it began.
inline float tossSquared(const Params& p, float speed, float floorSpeed) {
  return speed * speed + 2 * p.gravity * floorSpeed * p.tickSeconds;
}

// The same off a floor that goes up, studs/s: the speed upward with which somebody comes as high
// from `rise`, the springRise(), above it.
inline float springThrow(const Params& p, float rise, float floorSpeed) {
  const float inAir = BrakedFall(p).turnedUp(floorSpeed);
  float most = std::max(tossSquared(p, floorSpeed, floorSpeed), inAir - 2 * p.gravity * rise);
  riseOnSpring(p, [&](float gap, float up) {
    const float thrown = up + floorSpeed;
    most = std::max(most, thrown * thrown - 2 * p.gravity * (rise - gap));
  });
  return sqrtf32(most);
}

// Likewise off one that somebody climbs on onto, past the top of a truss, as fast as both.
inline float climbThrow(const Params& p, float climb, float floorSpeed) {
  return sqrtf32(tossSquared(p, climb + floorSpeed, floorSpeed));
}

// Do the legs throw back up who lands on them fast? Theirs is no bound then.
inline bool legsBounce(const Params& p) {
  const bool strong = p.hoverDamping * p.hoverDamping >= 2 * p.hoverStiffness;
  return !strong || p.hoverDamping * p.substepSeconds >= 1;
}

// Studs/s by which keys make somebody faster than they aim at, where substeps are long.
inline float keyOvershoot(const Params& p) {
  return std::max(100 * p.traction * (p.substepSeconds - 1 / p.moveGain), 0.0f);
}

// Sideways from the player's axis to the farthest corner of the body, and to the farthest ray.
inline float bodySide(const Params& p) {
  return std::max(0.5f, p.floorRaySpread) * length(Vec3{p.bodyWidth, 0, p.bodyDepth});
}

// Somebody between two parts that are farther apart touches but one of them, at any facing.
inline float bodyAcross(const Params& p) {
  return length(Vec3{p.bodyWidth, 0, p.bodyDepth}) + kSlack;
}

// Sideways from the axis to a corner of the limbs, and how far beyond them counts as touched.
inline float limbSide(const Params& p) {
  return 0.5f * length(Vec3{std::max(p.armSpan, p.bodyWidth), 0, p.bodyDepth});
}
inline float touchSlack(const Params& p) { return std::max(kSlack, 1.5f * p.touchMargin); }

// How far the feet can be from a part that carries them, across the axes that it turns about: what
// turns makes them faster than its own points. `flags`: of the part.
inline float feetAway(const Params& p, uint32_t flags) {
  if (!(flags & level::kCarries)) return 0;
  const bool truss = (flags & level::kTruss) != 0;
  const float beside = bodySide(p) + (truss ? p.climbReach : 0.0f);
  if (flags & level::kUpright) return beside;
  const float above = std::max({sim::rayHeight(p), floorReach(p), truss ? p.headBottom : 0.0f});
  return length(Vec3{beside, above, 0});
}

}  // namespace obby::solve
