// A query record to regions and limits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/level.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

constexpr uint32_t kMaxWaypoints = 255;  // World::waypoints is a byte

Result<StartPose> startPose(schema::Query::Reader record, const Level& level) {
  const auto start = record.getStart();
  if (start.hasRegion()) {
    OBBY_ASSIGN(const geom::Region box, region(start.getRegion(), "start.region"));
    OBBY_ASSIGN(const float yaw, angle(start.getYaw(), "start.yaw"));
    // Feet at the centre of the floor: the lowest face for an upright box, the lowest point below
    // the centre else.
    const Vec3 up{box.pose.rotation.x.y, box.pose.rotation.y.y, box.pose.rotation.z.y};
    const float drop = absf(up.y) > 0.999f ? box.half.y : dot(abs(up), box.half);
    return StartPose{box.pose.position - Vec3{0, drop, 0}, yaw, start.getTick()};
  }
  const int32_t spawn = start.getSpawn() < 0 ? 0 : start.getSpawn();
  if (size_t(spawn) >= level.spawns().size()) {
    return level.spawns().empty()
               ? pathError("start", "the level has no spawn, and the query names no start region")
               : pathError("start.spawn", fmt::format("expected 0 to {}, got {}",
                                                      level.spawns().size() - 1, spawn));
  }
  StartPose pose = level.spawns()[size_t(spawn)];
  pose.tick = start.getTick();
  return pose;
}

Result<uint32_t> timeLimit(schema::Query::Reader record, const Params& params) {
  const float limit = record.getTimeLimit();
  if (!std::isfinite(limit) || limit < 0)
    return pathError("timeLimit", "expected seconds, 0 for none");
  if (limit == 0) return 0u;
  // Beyond the largest clock there is no difference any more.
  const double exact = std::floor(double(limit) * params.controlRate + 1e-4);
  const uint32_t ticks = uint32_t(std::min(exact, 4294967295.0));
  if (ticks == 0) return pathError("timeLimit", "shorter than one tick");
  return ticks;
}

}  // namespace

Result<Query> Query::compile(schema::Query::Reader record, const Level& level) {
  Query q;
  q.id_ = record.getId();
  OBBY_ASSIGN(q.start_, startPose(record, level));
  if (!record.hasGoal()) return pathError("goal", "a query needs a goal region");
  OBBY_ASSIGN(q.goal_, region(record.getGoal(), "goal"));
  if (record.getWaypoints().size() > kMaxWaypoints)
    return pathError("waypoints", "expected at most 255");
  for (const auto waypoint : record.getWaypoints()) {
    const std::string path = fmt::format("waypoints[{}]", q.waypoints_.size());
    if (!waypoint.hasRegion()) return pathError(path + ".region", "a waypoint needs a region");
    OBBY_ASSIGN(const geom::Region box, region(waypoint.getRegion(), path + ".region"));
    q.waypoints_.push_back({box, waypoint.getMaxJumps()});
  }
  for (const auto avoid : record.getAvoid()) {
    OBBY_ASSIGN(const geom::Region box, region(avoid, fmt::format("avoid[{}]", q.avoid_.size())));
    q.avoid_.push_back(box);
  }
  q.maxJumps_ = record.getMaxJumps();
  OBBY_ASSIGN(q.timeLimitTicks_, timeLimit(record, level.view().params));
  return q;
}

QueryView Query::view() const {
  return {goal_,
          waypoints_.data(),
          avoid_.data(),
          uint32_t(waypoints_.size()),
          uint32_t(avoid_.size()),
          maxJumps_,
          timeLimitTicks_,
          start_.tick};
}

}  // namespace obby::level
