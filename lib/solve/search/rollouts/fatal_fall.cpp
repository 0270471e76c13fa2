#include "solve/search/rollouts/fatal_fall.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr float kMargin = 2;  // studs; more than the fall before a late jump

float lowestOf(const geom::Region& region) { return boundsOf(region.pose, region.half).lo.y; }

float lowestRegion(const level::QueryView& q) {
  float lowest = lowestOf(q.goal.region);
  for (uint32_t i = 0; i < q.otherGoalCount; ++i)
    lowest = std::min(lowest, lowestOf(q.otherGoals[i].region));
  for (uint32_t i = 0; i < q.waypointCount; ++i)
    lowest = std::min(lowest, lowestOf(q.waypoints[i].target.region));
  for (uint32_t i = 0; i < q.visitCount; ++i)
    lowest = std::min(lowest, lowestOf(q.visits[i].region));
  for (uint32_t i = 0; i < q.avoidCount; ++i)
    lowest = std::min(lowest, lowestOf(q.avoid[i].region));
  return lowest;
}

}  // namespace

float fatalHeight(const Problem& problem) {
  if (problem.level.bodyCount > 0) return -1e30f;
  float lowest = std::min(problem.start.position.y, lowestRegion(problem.query));
  for (uint32_t i = 0; i < problem.level.colliderCount; ++i) {
    lowest = std::min(lowest, problem.level.bounds[i].box().lo.y);
  }
  return lowest - problem.level.params.bodyTop - kMargin;
}

}  // namespace obby::solve
