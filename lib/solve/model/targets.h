// Facts about a query that a search needs: the number of its targets, and its limits.
#pragma once

#include "sim/next_region.h"

namespace obby::solve {

// Returns the number of waypoints and visits.
OBBY_DEVICE uint32_t targetCount(const level::QueryView& query) {
  return query.waypointCount + query.visitCount;
}

// Return true if any segment has a limit on its jumps, or on its time.
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

// Returns true if any limit on the jumps since the start applies.
OBBY_DEVICE bool limitsTotalJumps(const level::QueryView& query) {
  bool limited = query.maxJumps >= 0;
  for (uint32_t i = 0; i < query.waypointCount; ++i) {
    limited = limited || query.waypoints[i].maxJumps >= 0;
  }
  return limited;
}

// Returns true if any limit on jumps applies.
OBBY_DEVICE bool limitsJumps(const level::QueryView& query) {
  return limitsTotalJumps(query) || limitsSegmentJumps(query) || sim::forbidsJumping(query);
}

}  // namespace obby::solve
