// The region of the world that a drawing of a query shows.
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

// Calls visit(region, kind) for the query's regions, those to avoid first.
template <class Visit>
void forRegions(schema::Query::Reader query, Visit&& visit) {
  for (const auto region : query.getAvoid()) visit(region, RegionKind::avoid);
  for (const auto region : query.getVisits()) visit(region, RegionKind::visit);
  for (const auto w : query.getWaypoints()) visit(w.getRegion(), RegionKind::waypoint);
  for (const auto region : query.getGoals()) visit(region, RegionKind::goal);
  if (query.hasGoal()) visit(query.getGoal(), RegionKind::goal);
}

// Returns the bounds of regions and trajectories with a margin, or of the level if there are none.
Box extentOf(const LevelEntry& level, const QueryEntry& query);

// Returns the bounds of the level without a ground that is much larger than everything else.
Box courseOf(const LevelEntry& level);

// Returns the horizontal axis along the longer side of `extent`, with the sign that points from the
// query's start to its first goal. `query` may be null.
Vec3 alongOf(const Box& extent, const QueryEntry* query);

// Formats a length with three digits, or with all digits before the point.
std::string lengthText(float studs);

}  // namespace obby::view
