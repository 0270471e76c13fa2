// The rules of a query, applied after each tick: waypoints in order, the goal, avoid regions,
// limits.
#pragma once

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::sim {

// Jumps allowed now: in total, and on arrival at the waypoint that is next.
OBBY_DEVICE bool breaksJumpLimit(const World& w, const level::QueryView& q) {
  if (q.maxJumps >= 0 && int32_t(w.jumps) > q.maxJumps) return true;
  if (w.waypoints >= q.waypointCount) return false;
  const int32_t limit = q.waypoints[w.waypoints].maxJumps;
  return limit >= 0 && int32_t(w.jumps) > limit;
}

// Ends the playthrough or notes progress. A world that died in this tick stays dead.
OBBY_DEVICE void applyRules(World& w, const level::LevelView& level, const level::QueryView& q) {
  if (w.outcome != Outcome::running) return;
  const Vec3 feet = w.position, head = w.position + Vec3{0, level.params.bodyTop, 0};
  for (uint32_t i = 0; i < q.avoidCount; ++i) {
    if (geom::meets(q.avoid[i], feet, head)) {
      w.outcome = Outcome::avoided;
      return;
    }
  }
  if (breaksJumpLimit(w, q)) {
    w.outcome = Outcome::jumps;
    return;
  }
  while (w.waypoints < q.waypointCount &&
         geom::meets(q.waypoints[w.waypoints].region, feet, head)) {
    ++w.waypoints;
    if (!breaksJumpLimit(w, q)) continue;
    w.outcome = Outcome::jumps;
    return;
  }
  if (w.waypoints == q.waypointCount && geom::meets(q.goal, feet, head)) {
    w.outcome = Outcome::goal;
    return;
  }
  if (q.timeLimitTicks != 0 && w.tick - q.startTick >= q.timeLimitTicks)
    w.outcome = Outcome::timeout;
}

}  // namespace obby::sim
