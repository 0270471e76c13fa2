// How far legs, rays and limbs of a player reach, at most: what the bound on reach has to know of a
// body. Every number in the player's favour.
#pragma once

#include <algorithm>

#include "sim/floor.h"

namespace obby::solve {

constexpr float kSlack = 0.25f;  // studs: skin, ticks, rounding

// How far above a floor the legs keep it.
inline float floorReach(const Params& p) {
  const float reach = p.floorReachBase * p.rootHeight + farthestFloor(p) * p.hipHeight;
  return std::max(reach - sim::rayHeight(p), 0.0f);
}

// How far above the floor the legs can leave the feet, or throw them: the hover spring let go at
// its deepest, and the reach in which it keeps a floor.
inline float springRise(const Params& p) {
  float gap = -(sim::rayHeight(p) + kSlack), speed = 0, most = floorReach(p);
  for (int i = 0; i < 2 * p.controlRate * p.substeps; ++i) {
    const float a =
        std::clamp(-p.hoverStiffness * gap - p.hoverDamping * speed, -p.gravity, p.hoverLimit);
    gap += speed * p.substepSeconds + a * (0.5f * p.substepSeconds * p.substepSeconds);
    speed += a * p.substepSeconds;
    const float up = std::max(speed, 0.0f);
    most = std::max(most, gap + up * up / (2 * p.gravity));
  }
  return most + kSlack;
}

// Sideways from the player's axis to the farthest corner of the body, and to the farthest ray.
inline float bodySide(const Params& p) {
  return std::max(0.5f, p.floorRaySpread) * length(Vec3{p.bodyWidth, 0, p.bodyDepth});
}

// Sideways from the axis to a corner of the limbs, and how far beyond them counts as touched.
inline float limbSide(const Params& p) { return 0.5f * length(Vec3{p.armSpan, 0, p.bodyDepth}); }
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
