// The rules of a query, applied after each tick: waypoints in order, visits in any order, goals,
// targets to avoid, limits.
#pragma once

#include "sim/targets.h"

namespace obby::sim {

// The parts of the state before the tick that the rules need.
struct Before {
  Vec3 feet;
  uint8_t flags;
};

OBBY_DEVICE Before beforeOf(const World& w) { return {w.position, w.flags}; }

// A world after a tick, as the rules see it.
struct Judged {
  World& w;
  const Before& before;
  const RigidBody* bodies;
  const level::LevelView& level;
  const level::QueryView& q;

  OBBY_DEVICE bool reaches(const level::TargetView& target) const {
    return sim::reaches(w, bodies, level, q, target);
  }

  // Returns true if the player was in a region during the tick. A teleport passes through nothing,
  // and parts are touched at the end of a tick, as in the engine.
  OBBY_DEVICE bool passes(const level::TargetView& target) const {
    const bool teleported = (w.flags & ~before.flags & kArrived) != 0;
    if (target.touchCount != 0 || teleported) return false;
    const Vec3 up{0, level.params.bodyTop, 0};
    return geom::meetsAlong(target.region, before.feet, before.feet + up, w.position - before.feet);
  }
};

// Returns the limits of the segment that the player is in.
OBBY_DEVICE const level::SegmentLimits& segmentOf(const World& w, const level::QueryView& q) {
  return w.waypoints < q.waypointCount ? q.waypoints[w.waypoints].segment : q.last;
}

// ticksPlayed() returns the ticks since the start, segmentTicks() the ticks since the last
// waypoint.
OBBY_DEVICE uint32_t ticksPlayed(const World& w, const level::QueryView& q) {
  return w.tick - q.startTick;
}
OBBY_DEVICE uint32_t segmentTicks(const World& w, const level::QueryView& q) {
  return w.waypoints == 0 ? ticksPlayed(w, q) : w.tick - w.segmentTick;
}

// Returns true if a jump limit is exceeded: in total, for the next waypoint, or in this segment.
OBBY_DEVICE bool breaksJumpLimit(const World& w, const level::QueryView& q) {
  if (q.maxJumps >= 0 && int32_t(w.jumps) > q.maxJumps) return true;
  const int32_t max = segmentOf(w, q).jumps;
  if (max >= 0 && int32_t(w.jumps) - int32_t(w.segmentJumps) > max) return true;
  if (w.waypoints >= q.waypointCount) return false;
  const int32_t limit = q.waypoints[w.waypoints].maxJumps;
  return limit >= 0 && int32_t(w.jumps) > limit;
}

// Returns true if a time limit has passed: of the query, of this segment, or for the next waypoint.
// Arrival on the last tick counts.
OBBY_DEVICE bool isLate(const World& w, const level::QueryView& q) {
  const uint32_t played = ticksPlayed(w, q), max = segmentOf(w, q).ticks;
  if (q.timeLimitTicks != 0 && played >= q.timeLimitTicks) return true;
  if (max != 0 && segmentTicks(w, q) >= max) return true;
  if (w.waypoints >= q.waypointCount) return false;
  const uint32_t limit = q.waypoints[w.waypoints].ticks;
  return limit != 0 && played >= limit;
}

// Returns the violated rule, or `running` if there is none. Targets must be reached at the end of a
// tick. Targets to avoid are also tested within the tick, since a player could otherwise step over
// a thin region.
OBBY_DEVICE Outcome violation(const Judged& j) {
  for (uint32_t i = 0; i < j.q.avoidCount; ++i) {
    if (!j.reaches(j.q.avoid[i]) && !j.passes(j.q.avoid[i])) continue;
    j.w.part = i;
    return Outcome::avoided;
  }
  if (j.q.forbidden >> uint32_t(j.w.state) & 1) return Outcome::forbidden;
  if (j.q.maxDamage >= 0 && j.w.damage > j.q.maxDamage) return Outcome::hurt;
  return breaksJumpLimit(j.w, j.q) ? Outcome::jumps : Outcome::running;
}

// Records waypoints and visits. Returns false if the next jump limit is already broken.
OBBY_DEVICE bool noteProgress(const Judged& j) {
  World& w = j.w;
  while (w.waypoints < j.q.waypointCount && j.reaches(j.q.waypoints[w.waypoints].target)) {
    ++w.waypoints;
    w.segmentTick = w.tick;
    w.segmentJumps = w.jumps;
    if (breaksJumpLimit(w, j.q)) return false;
  }
  for (uint32_t i = 0; i < j.q.visitCount; ++i) {
    if (!(w.visited >> i & 1) && j.reaches(j.q.visits[i])) w.visited |= 1u << i;
  }
  return true;
}

OBBY_DEVICE uint32_t allVisits(const level::QueryView& q) {
  return q.visitCount == 0 ? 0 : ~0u >> (level::kMaxVisits - q.visitCount);
}

OBBY_DEVICE bool atGoal(const Judged& j) {
  const level::QueryView& q = j.q;
  if (j.w.waypoints < q.waypointCount || j.w.visited != allVisits(q)) return false;
  if (int32_t(j.w.jumps) < q.minJumps) return false;
  bool reached = j.reaches(q.goal);
  for (uint32_t i = 0; i < q.otherGoalCount && !reached; ++i) reached = j.reaches(q.otherGoals[i]);
  return reached;
}

// Ends the trajectory or records progress. A world that died in this tick stays dead. `before` is
// its state before the tick. `bodies` has level.bodyCount bodies, or is null if there are none.
OBBY_DEVICE void applyRules(World& w, const Before& before, const RigidBody* bodies,
                            const level::LevelView& level, const level::QueryView& q) {
  if (w.outcome != Outcome::running) return;
  const Judged j{w, before, bodies, level, q};
  w.outcome = violation(j);
  if (w.outcome != Outcome::running) return;
  if (!noteProgress(j)) {
    w.outcome = Outcome::jumps;
  } else if (atGoal(j)) {
    w.outcome = Outcome::goal;
  } else if (isLate(w, q)) {
    w.outcome = Outcome::timeout;
  }
}

}  // namespace obby::sim
