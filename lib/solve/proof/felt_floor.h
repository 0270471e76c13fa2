// How far below the feet the legs feel a floor, and how substeps are cut up for who falls fast.
#pragma once

#include <algorithm>

#include "sim/body.h"
#include "sim/floor.h"

namespace obby::solve {

// Studs, by somebody at rest; less than 0: above the feet only.
inline float feltAtRest(const Params& p) {
  return p.floorReachBase * p.rootHeight + farthestFloor(p) * p.hipHeight - sim::rayHeight(p);
}

// Studs, by somebody who falls at `fall` studs/s (sim::makeRays).
inline float feltInFall(const Params& p, float fall) {
  return std::max(feltAtRest(p), fall * p.tickSeconds) + std::max(fall - p.fastFall, 0.0f) * 0.01f;
}

// How many times as far as is safe a substep leads a body that falls so fast, studs/s, and collides
// from `bottom` above its feet up: above 1 it is cut up where that can meet parts.
inline float cutsInFall(const Params& p, float fall, float bottom) {
  sim::Motion m{};
  m.velocity.y = -fall;
  m.bottom = bottom;
  return sim::substepTravel(m, p) / sim::safeTravel(m, p);
}

}  // namespace obby::solve
