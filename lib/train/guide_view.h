// How much of a way is left from anywhere, as rewards ask for it.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "math/lanes.h"
#include "math/vec.h"

namespace obby::train {

// A stud beside the line counts as so many along it: there may be nothing to walk on. Where the way
// turns back, its other lane must not look near.
constexpr float kOff = 3;

// Plain spans, for device code.
struct GuideView {
  const Vec3* places = nullptr;     // (count), at least two
  const float* behind = nullptr;    // (count), studs from each place to the end
  const uint32_t* stops = nullptr;  // (stopCount), places at the query's waypoints, ascending
  uint32_t count = 0, stopCount = 0;

  OBBY_DEVICE float studs() const { return behind[0]; }  // of the whole way

  // Studs to the end: thrice those to the line, then along it. The least over all of the line, so
  // that short cuts count, once they come near to it again; but for what begins with less than
  // `from` studs left: where a way winds up a tower, the next round is overhead, not near. And but
  // for what is behind the next waypoint: `waypoints` were passed.
  OBBY_DEVICE float left(Vec3 position, float from, uint32_t waypoints) const {
    const uint32_t last = waypoints < stopCount ? stops[waypoints] : count - 1;
    float least = 1e30f;
    for (uint32_t i = 0; i + 1 < count; ++i) {
      if (i > 0 && (i >= last || behind[i] < from)) break;
      const Vec3 along = places[i + 1] - places[i], to = position - places[i];
      const float squared = dot(along, along);
      const float share = squared > 0 ? clampf(dot(to, along) / squared, 0.0f, 1.0f) : 0;
      const float off = length(to - along * share);
      least = minf(least, kOff * off + behind[i + 1] + (behind[i] - behind[i + 1]) * (1 - share));
    }
    return least;
  }
};

template <class Table>
OBBY_DEVICE void forTables(GuideView& g, Table&& table) {
  table(g.places, g.count);
  table(g.behind, g.count);
  table(g.stops, g.stopCount);
}

}  // namespace obby::train
