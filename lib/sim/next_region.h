// Finds the region that a player must reach next in a query, and the jumps that are left for it.
#pragma once

#include "sim/rules.h"

namespace obby::sim {

// Returns the number of waypoints and visits reached so far.
OBBY_DEVICE uint32_t targetsReached(const World& world) {
  return world.waypoints + bitCount(world.visited);
}

// Keeps the nearest of the regions that may be the next to reach.
struct NextRegion {
  const geom::Region* region = nullptr;
  float distance = 1e30f;  // studs

  OBBY_DEVICE void consider(const geom::Region& r, Vec3 from) {
    const float d = geom::distance(r, from);
    if (region != nullptr && !(d < distance)) return;
    region = &r;
    distance = d;
  }
};

// Returns the nearest region that can be reached next: the next waypoint or a visit that is left,
// or a goal if there are none.
OBBY_DEVICE NextRegion nextRegion(const level::QueryView& query, const World& world) {
  NextRegion next;
  if (world.waypoints < query.waypointCount) {
    next.consider(query.waypoints[world.waypoints].target.region, world.position);
  }
  for (uint32_t i = 0; i < query.visitCount; ++i) {
    if (!(world.visited >> i & 1)) next.consider(query.visits[i].region, world.position);
  }
  if (next.region != nullptr) return next;
  next.consider(query.goal.region, world.position);
  for (uint32_t i = 0; i < query.otherGoalCount; ++i) {
    next.consider(query.otherGoals[i].region, world.position);
  }
  return next;
}

// Returns true if the query forbids the state Jumping.
OBBY_DEVICE bool forbidsJumping(const level::QueryView& query) {
  return (query.forbidden >> uint32_t(State::jumping) & 1) != 0;
}

// Returns the jumps left before a limit ahead is broken, or a large number without limits.
// Waypoints already reached do not count any more.
OBBY_DEVICE uint32_t jumpsLeft(const level::QueryView& query, const World& world) {
  if (forbidsJumping(query)) return 0;
  uint32_t limit = query.maxJumps < 0 ? 0xffffffffu : uint32_t(query.maxJumps);
  const int32_t segment = segmentOf(world, query).jumps;
  if (segment >= 0 && world.segmentJumps + uint32_t(segment) < limit) {
    limit = world.segmentJumps + uint32_t(segment);
  }
  for (uint32_t i = world.waypoints; i < query.waypointCount; ++i) {
    const int32_t max = query.waypoints[i].maxJumps;
    if (max >= 0 && uint32_t(max) < limit) limit = uint32_t(max);
  }
  return limit > world.jumps ? limit - world.jumps : 0;
}

}  // namespace obby::sim
