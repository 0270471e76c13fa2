// What a search needs to know of a query as such: how much there is of it, and what it limits.
#pragma once

#include "sim/next_region.h"

namespace obby::solve {

// How many waypoints and visits there are.
OBBY_DEVICE uint32_t targetCount(const level::QueryView& query) {
  return query.waypointCount + query.visitCount;
}

// Does any limit on the jumps of a segment apply? On the time in one?
OBBY_DEVICE bool limitsSegmentJumps(const level::QueryView& query) {
  bool limited = query.last.jumps >= 0;
  for (uint32_t i = 0; i < query.waypointCount; ++i) {
    limited = limited || query.waypoints[i].segment.jumps >= 0;
  }
  return limited;
}
OBBY_DEVICE bool limitsSegmentTime(const level::QueryView& query) {
  bool limited = query.last.ticks != 0;
  for (uint32_t i = 0; i < query.waypointCount; ++i) {
    limited = limited || query.waypoints[i].segment.ticks != 0;
  }
  return limited;
}

// Does any limit on the jumps since the start apply?
OBBY_DEVICE bool limitsTotalJumps(const level::QueryView& query) {
  bool limited = query.maxJumps >= 0;
  for (uint32_t i = 0; i < query.waypointCount; ++i) {
    limited = limited || query.waypoints[i].maxJumps >= 0;
  }
  return limited;
}

// Does any limit on jumps apply?
OBBY_DEVICE bool limitsJumps(const level::QueryView& query) {
  return limitsTotalJumps(query) || limitsSegmentJumps(query) || sim::forbidsJumping(query);
}

}  // namespace obby::solve
