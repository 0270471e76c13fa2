// The length left on a route from any position, for rewards.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "math/lanes.h"
#include "math/vec.h"

namespace obby::train {

// Weight of the distance to the line. It is high because there may be no floor next to the line. It
// also keeps the opposite lane of a route that turns back from counting as near.
constexpr float kOff = 3;

// Plain spans, for device code.
struct GuideView {
  const Vec3* places = nullptr;     // (count), at least two
  const float* behind = nullptr;    // (count), studs from each place to the end
  const uint32_t* stops = nullptr;  // (stopCount), places at the query's waypoints, ascending
  uint32_t count = 0, stopCount = 0;

  OBBY_DEVICE float studs() const { return behind[0]; }  // length of the whole route

  // Returns the studs to the end: kOff times the distance to the line, then along it, minimised
  // over the line, so that short cuts count. It skips segments that start with less than `from`
  // studs left: where a route spirals up a tower, the next turn is overhead but not near. It also
  // skips segments after the next waypoint; `waypoints` is the number already passed.
  OBBY_DEVICE float left(Vec3 position, float from, uint32_t waypoints) const {
    const uint32_t last = waypoints < stopCount ? stops[waypoints] : count - 1;
    float min = 1e30f;
    for (uint32_t i = 0; i + 1 < count; ++i) {
      if (i > 0 && (i >= last || behind[i] < from)) break;
      const Vec3 along = places[i + 1] - places[i], to = position - places[i];
      const float squared = dot(along, along);
      const float share = squared > 0 ? clampf(dot(to, along) / squared, 0.0f, 1.0f) : 0;
      const float off = length(to - along * share);
      min = minf(min, kOff * off + behind[i + 1] + (behind[i] - behind[i + 1]) * (1 - share));
    }
    return min;
  }
};

template <class Table>
OBBY_DEVICE void forTables(GuideView& g, Table&& table) {
  table(g.places, g.count);
  table(g.behind, g.count);
  table(g.stops, g.stopCount);
}

}  // namespace obby::train
