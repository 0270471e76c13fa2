// What the rounding of places gives to players far from the origin: each substep adds a way to a
// place, and leaves out or adds up to half of the place's last bit. At 20,000 studs a walk of 16
// studs/s is one of 16.05.
#pragma once

#include <algorithm>
#include <limits>

#include "solve/query/problem.h"

namespace obby::solve {

// Studs/s sideways, at most.
inline float roundedSpeed(const Problem& problem) {
  constexpr float kHalves = 5;  // of a last bit: fast falls past parts cut a substep into as many
  const Vec3 start = problem.start.position;
  const Box all = join(problem.bounds, Box{start, start});
  const float studs = std::max({-all.lo.x, all.hi.x, -all.lo.z, all.hi.z});
  const float last = studs * std::numeric_limits<float>::epsilon();
  const Params& p = problem.level.params;
  // Along both axes.
  return 1.42f * 0.5f * kHalves * last * float(p.substeps) * float(p.controlRate);
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
  const float start = absf(problem.start.position.y);
  return std::max({-problem.bounds.lo.y, problem.bounds.hi.y, start}) > kFar;
}

}  // namespace obby::solve
