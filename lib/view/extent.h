// What of the world a drawing of a query must show.
#pragma once

#include <array>
#include <string>

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

// The horizontal axis of the world, or its opposite, along which the course runs: the longer side
// of `extent`, from the query's start towards its goal (of several the first). `query` may be null.
Vec3 alongOf(const Box& extent, const QueryEntry* query);

// For people: three digits, or all of those before the point.
std::string lengthText(float studs);

}  // namespace obby::view
