// What of the world a drawing of a query must show.
#pragma once

#include <array>

#include "view/report.h"

namespace obby::view {

using Corners = std::array<Vec3, 8>;

Corners cornersOf(schema::Part::Reader part);
Corners cornersOf(schema::Region::Reader region);
Box boxOf(const Corners& corners);

enum class RegionKind { avoid, visit, waypoint, goal };

// Calls visit(region, kind) for the query's regions, what is to be avoided first.
template <class Visit>
void forRegions(schema::Query::Reader query, Visit&& visit) {
  for (const auto region : query.getAvoid()) visit(region, RegionKind::avoid);
  for (const auto region : query.getVisits()) visit(region, RegionKind::visit);
  for (const auto w : query.getWaypoints()) visit(w.getRegion(), RegionKind::waypoint);
  for (const auto region : query.getGoals()) visit(region, RegionKind::goal);
  if (query.hasGoal()) visit(query.getGoal(), RegionKind::goal);
}

// Regions and trajectories with some surroundings, or else the whole level.
Box extentOf(const LevelEntry& level, const QueryEntry& query);

}  // namespace obby::view
