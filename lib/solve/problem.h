// What a search is asked: a compiled level and query in plain form, and how much work it may do.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "level/level_view.h"
#include "sim/loose.h"
#include "sim/world.h"

namespace obby::solve {

// The level and the query must outlive the search.
struct Problem {
  level::LevelView level;
  level::QueryView query;
  sim::World start;                        // as sim::makeWorld gives it
  std::vector<sim::LooseBody> startLoose;  // as sim::makeLoose gives them
  Box bounds;                              // of everything in the level
  bool hasClock = false;  // moving or timed parts: the outcome depends on the level clock
};

// The answer depends on seed, maxSteps, solutions and the problem only, never on the number of
// threads, unless `seconds` or `stop` ends the search.
struct Budget {
  uint64_t seed = 1;
  double seconds = std::numeric_limits<double>::infinity();  // wall clock
  uint64_t maxSteps = std::numeric_limits<uint64_t>::max();  // simulated ticks
  uint32_t solutions = 1;                                    // distinct ones to look for
  uint32_t attempts = 24;                                    // failed ones to show
  const std::atomic<bool>* stop = nullptr;                   // set from outside
};

// The region to reach next, with `reached` waypoints behind.
OBBY_DEVICE const geom::Region& targetRegion(const level::QueryView& query, uint32_t reached) {
  return reached < query.waypointCount ? query.waypoints[reached].region : query.goal;
}

// Does any limit on jumps apply?
OBBY_DEVICE bool limitsJumps(const level::QueryView& query) {
  bool limited = query.maxJumps >= 0;
  for (uint32_t i = 0; i < query.waypointCount; ++i) {
    limited = limited || query.waypoints[i].maxJumps >= 0;
  }
  return limited;
}

// Jumps that may still be made before some limit ahead is broken; a large number where there is
// none. Waypoints behind do not count any more.
OBBY_DEVICE uint32_t jumpsLeft(const level::QueryView& query, const sim::World& world) {
  uint32_t limit = query.maxJumps < 0 ? 0xffffu : uint32_t(query.maxJumps);
  for (uint32_t i = world.waypoints; i < query.waypointCount; ++i) {
    const int32_t most = query.waypoints[i].maxJumps;
    if (most >= 0 && uint32_t(most) < limit) limit = uint32_t(most);
  }
  return limit > world.jumps ? limit - world.jumps : 0;
}

}  // namespace obby::solve
