// What the rounding of places gives to players far from the origin: each substep adds a way to a
// place, and leaves out or adds up to half of the place's last bit. At 20,000 studs a walk of 16
// studs/s is one of 16.05.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/proof/felt_floor.h"
#include "solve/query/problem.h"

namespace obby::solve {

// The level, the start, and where teleporters lead.
inline Box allPlaces(const Problem& problem) {
  const Vec3 start = problem.start.position;
  const level::LevelView& level = problem.level;
  Box all = join(problem.bounds, Box{start, start});
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (!(level.bounds[i].flags & level::kTeleport)) continue;
    const Vec3 to = level.roles[level.colliders[i].role].teleportTo;
    all = join(all, Box{to, to});
  }
  return all;
}

// Into how many pieces a substep is cut where the fastest fall past parts, or walk among them
// (sim::contactSubsteps), at most; no fewer than by the default physics.
inline float mostPieces(const level::LevelView& level) {
  const Params& p = level.params;
  const float fastest = std::max(p.maxFallSpeed, level.maxSideSpeed);
  const float pieces = std::ceil(cutsInFall(p, fastest, p.headBottom));
  return std::clamp(pieces, 5.0f, float(sim::kMostSplits));
}

// Studs/s sideways, at most.
inline float roundedSpeed(const Problem& problem) {
  const Box all = allPlaces(problem);
  const float studs = std::max({-all.lo.x, all.hi.x, -all.lo.z, all.hi.z});
  const float last = studs * std::numeric_limits<float>::epsilon();
  const Params& p = problem.level.params;
  // Half a last bit for each piece, along both axes.
  const float halves = mostPieces(problem.level) * float(p.substeps) * float(p.controlRate);
  return 1.42f * 0.5f * last * halves;
}

// The same where it counts in a flight, which is granted two ticks more than it takes.
inline float roundedInFlight(const Problem& problem) {
  constexpr float kLittle = 0.2f;  // studs/s: half a stud in seconds
  const float speed = roundedSpeed(problem);
  return speed > kLittle ? speed : 0.0f;
}

// Is anything so far up or down that jumps are higher, or falls longer, by what is rounded?
inline bool isFarUp(const Problem& problem) {
  constexpr float kFar = 16384;  // studs: of places beyond, the last bit is a 512th of a stud
  const Box all = allPlaces(problem);
  return std::max(-all.lo.y, all.hi.y) > kFar;
}

}  // namespace obby::solve
