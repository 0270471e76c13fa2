#include "solve/search/guidance/potential.h"

#include <algorithm>

#include "solve/model/targets.h"

namespace obby::solve {

namespace {

// Returns the spans of a query with a fixed order of regions: from each region to the next.
std::vector<float> spansInOrder(const level::QueryView& q, Vec3 from) {
  std::vector<float> spans;
  float size = 0;  // half diagonal of the region before, which may be left on its far side
  for (uint32_t segment = 0; segment <= q.waypointCount; ++segment) {
    const geom::Region& to =
        segment < q.waypointCount ? q.waypoints[segment].target.region : q.goal.region;
    spans.push_back(1.5f * std::max(1.0f, geom::distance(to, from) + size));
    from = to.pose.position;
    size = length(to.half);
  }
  return spans;
}

// Returns the spans of a query with a choice: from any start of a segment to the farthest region.
std::vector<float> spansInAnyOrder(const level::QueryView& q, Vec3 start) {
  std::vector<const geom::Region*> all{&q.goal.region};
  for (uint32_t i = 0; i < q.otherGoalCount; ++i) all.push_back(&q.otherGoals[i].region);
  for (uint32_t i = 0; i < q.waypointCount; ++i) all.push_back(&q.waypoints[i].target.region);
  for (uint32_t i = 0; i < q.visitCount; ++i) all.push_back(&q.visits[i].region);
  float longest = 1;
  for (const geom::Region* to : all) {
    longest = std::max(longest, geom::distance(*to, start));
    for (const geom::Region* from : all) {
      longest = std::max(longest, geom::distance(*to, from->pose.position) + length(from->half));
    }
  }
  return std::vector<float>(targetCount(q) + 1, 1.5f * longest);
}

}  // namespace

Potential::Potential(const Problem& problem) : query_(problem.query) {
  const bool choice = query_.visitCount > 0 || query_.otherGoalCount > 0;
  spans_ = choice ? spansInAnyOrder(query_, problem.start.position)
                  : spansInOrder(query_, problem.start.position);
}

}  // namespace obby::solve
