#include "suite/effort.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "level/level.h"

namespace obby::bench {
namespace {

constexpr float kJump = 8.6f;    // studs, on the flat
constexpr float kRise = 3;       // studs of distance that one stud of height counts as
constexpr float kNear = 12;      // studs from the straight line: about a jump
constexpr float kMaxParts = 40;  // a larger number means a field of equal parts
constexpr uint32_t kHazard = level::kKill | level::kPad | level::kConveyor | level::kClocked |
                             level::kVanishTimer | level::kMoving | level::kTeleport |
                             level::kDynamic;

// Returns the point nearest to `from` in the region's box.
Vec3 nearest(const geom::Region& region, Vec3 from) {
  const Vec3 local = toLocal(region.pose, from);
  return toWorld(region.pose, max(-region.half, min(local, region.half)));
}

float studsBetween(Vec3 from, Vec3 to) {
  const float rise = std::max(to.y - from.y, 0.0f);
  return std::hypot(to.x - from.x, to.z - from.z) + kRise * rise;
}

// Appends the nearest of the targets. Returns its index.
size_t goToNearest(const std::vector<geom::Region>& targets, std::vector<Vec3>& route) {
  size_t best = 0;
  for (size_t i = 1; i < targets.size(); ++i) {
    if (studsBetween(route.back(), nearest(targets[i], route.back())) <
        studsBetween(route.back(), nearest(targets[best], route.back()))) {
      best = i;
    }
  }
  route.push_back(nearest(targets[best], route.back()));
  return best;
}

std::vector<Vec3> straightRoute(const level::Query& query) {
  const level::QueryView q = query.view();
  std::vector<Vec3> route{query.start().feet};
  for (uint32_t i = 0; i < q.waypointCount; ++i) goToNearest({q.waypoints[i].target.region}, route);
  std::vector<geom::Region> left;
  for (uint32_t i = 0; i < q.visitCount; ++i) left.push_back(q.visits[i].region);
  while (!left.empty()) left.erase(left.begin() + std::ptrdiff_t(goToNearest(left, route)));
  std::vector<geom::Region> goals{q.goal.region};
  for (uint32_t i = 0; i < q.otherGoalCount; ++i) goals.push_back(q.otherGoals[i].region);
  goToNearest(goals, route);
  return route;
}

bool isNear(const Box& box, const std::vector<Vec3>& route) {
  const Vec3 margin{kNear, kNear, kNear};
  for (size_t i = 1; i < route.size(); ++i) {
    const Vec3 lo = min(route[i - 1], route[i]) - margin, hi = max(route[i - 1], route[i]) + margin;
    if (box.lo.x <= hi.x && box.hi.x >= lo.x && box.lo.y <= hi.y && box.hi.y >= lo.y &&
        box.lo.z <= hi.z && box.hi.z >= lo.z) {
      return true;
    }
  }
  return false;
}

float hazards(const level::LevelView& level, const std::vector<Vec3>& route) {
  std::set<uint32_t> parts;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if ((level.bounds[i].flags & kHazard) && isNear(level.bounds[i].box(), route)) {
      parts.insert(level.colliders[i].part);
    }
  }
  return std::min(float(parts.size()), kMaxParts);
}

int limits(const level::QueryView& q) {
  const auto segment = [](const level::SegmentLimits& s) { return (s.jumps >= 0) + (s.ticks > 0); };
  int count = (q.minJumps > 0) + (q.maxJumps >= 0) + (q.timeLimitTicks > 0) + (q.maxDamage >= 0) +
              (q.forbidden != 0) + (q.touchedCount > 0) + segment(q.last);
  for (uint32_t i = 0; i < q.waypointCount; ++i) {
    const level::WaypointView& w = q.waypoints[i];
    count += (w.maxJumps >= 0) + (w.ticks > 0) + segment(w.segment);
  }
  return count;
}

}  // namespace

Result<double> effortOf(schema::Level::Reader levelRecord, schema::Query::Reader queryRecord) {
  OBBY_ASSIGN(const level::Level level, level::Level::compile(levelRecord));
  OBBY_ASSIGN(const level::Query query, level::Query::compile(queryRecord, level));
  const level::QueryView q = query.view();
  const std::vector<Vec3> route = straightRoute(query);
  float studs = 0;
  for (size_t i = 1; i < route.size(); ++i) studs += studsBetween(route[i - 1], route[i]);
  return studs / kJump + 0.5f * hazards(level.view(), route) +
         2.0f * float(q.waypointCount + q.visitCount) + 2.0f * float(limits(q)) +
         float(q.avoidCount);
}

}  // namespace obby::bench
