#include "solve/search/guidance/beam_rank.h"

#include <algorithm>

#include "solve/model/targets.h"

namespace obby::solve {

BeamRoute::BeamRoute(const Problem& problem)
    : ticksPerStud_(float(problem.level.params.controlRate) /
                    std::max(problem.level.params.walkSpeed, 1.0f)),
      segments_(problem.query.waypointCount + 1, 0.0f) {
  const level::QueryView& query = problem.query;
  const geom::Region* to = &query.goal.region;
  for (uint32_t i = query.waypointCount; i-- > 0; to = &query.waypoints[i].target.region) {
    const geom::Region& from = query.waypoints[i].target.region;
    const float segment = geom::distance(*to, from.pose.position) - length(from.half);
    // With several goals the distance to the first is no lower bound.
    const bool known = i + 1 < query.waypointCount || query.otherGoalCount == 0;
    segments_[i] = segments_[i + 1] + (known ? std::max(segment, 0.0f) : 0.0f);
  }
  for (uint32_t i = 0; i < query.visitCount; ++i) {
    const geom::Region& from = query.visits[i].region;
    float nearest = geom::distance(query.goal.region, from.pose.position);
    for (uint32_t k = 0; k < query.visitCount; ++k) {
      if (k == i) continue;
      nearest = std::min(nearest, geom::distance(query.visits[k].region, from.pose.position));
    }
    hops_.push_back(nearest);
  }
}

}  // namespace obby::solve
