// Compiles a query record to regions and limits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/level.h"
#include "level/player.h"
#include "level/query_targets.h"
#include "level/record_values.h"
#include "level/tricks.h"

namespace obby::level {
namespace {

constexpr uint32_t kMaxWaypoints = 255;  // World::waypoints is a byte

Result<StartPose> startPose(schema::Query::Reader record, const Level& level) {
  const auto start = record.getStart();
  if (start.hasRegion()) {
    OBBY_RETURN_IF_ERROR(checkLookedUp(start.getRegion(), "start.region"));
    OBBY_ASSIGN(const geom::Region box, region(start.getRegion(), "start.region"));
    OBBY_ASSIGN(const float yaw, angle(start.getYaw(), "start.yaw"));
    // The feet are at the centre of the lowest face of an upright box. In a tilted box they are
    // below its centre, at the height of its lowest point.
    const Vec3 up{box.pose.rotation.x.y, box.pose.rotation.y.y, box.pose.rotation.z.y};
    const float drop = absf(up.y) > 0.999f ? box.half.y : dot(abs(up), box.half);
    const Vec3 feet = box.pose.position - Vec3{0, drop, 0};
    if (feet.y < -kMaxCoordinate) {
      return pathError("start.region",
                       "expected a floor above -1000000 studs, found " + shown(feet.y));
    }
    return StartPose{feet, yaw, start.getTick()};
  }
  const int32_t spawn = start.getSpawn() == -1 ? 0 : start.getSpawn();
  if (level.spawns().empty()) {
    return pathError("start", "the level has no spawn, and the query has no start region",
                     "add a spawn to the level, or \"start\":{\"region\":...} to the query");
  }
  if (spawn < 0 || size_t(spawn) >= level.spawns().size()) {
    const size_t last = level.spawns().size() - 1;
    return pathError("start.spawn",
                     fmt::format("expected {}, found {}",
                                 last == 0 ? std::string("0, the only spawn")
                                           : fmt::format("a spawn from 0 to {}", last),
                                 spawn));
  }
  StartPose pose = level.spawns()[size_t(spawn)];
  pose.tick = start.getTick();
  return pose;
}

// Converts seconds to ticks. 0 means no limit.
Result<uint32_t> ticksWithin(float limit, const Params& params, const std::string& path) {
  if (!std::isfinite(limit) || limit < 0) {
    return pathError(path, "expected 0 or more seconds (0: no limit), found " + shown(limit));
  }
  if (limit == 0) return 0u;
  // A whole number of ticks must survive the rounding of the record's float. Limits beyond the
  // largest clock are all the same.
  const double exact = double(limit) * params.controlRate;
  const double whole = std::floor(exact + 1e-4 + exact * 0x1p-23);
  const uint32_t ticks = uint32_t(std::min(whole, 4294967295.0));
  if (ticks == 0) return pathError(path, "the limit is shorter than one tick");
  return ticks;
}

// Checks a limit of jumps. -1 means any number.
Result<int32_t> jumpsWithin(int32_t jumps, const std::string& path) {
  if (jumps < -1) {
    return pathError(path, fmt::format("expected 0 or more jumps (-1: any), found {}", jumps));
  }
  return jumps;
}

Result<SegmentLimits> segmentLimits(int32_t jumps, float seconds, const Params& params,
                                    const std::string& path) {
  SegmentLimits limits;
  OBBY_ASSIGN(limits.jumps, jumpsWithin(jumps, path + "segmentJumps"));
  OBBY_ASSIGN(limits.ticks, ticksWithin(seconds, params, path + "segmentTime"));
  return limits;
}

Result<WaypointView> compileWaypoint(schema::Waypoint::Reader record, schema::Arrive arrive,
                                     const Params& params, QueryTargets& targets,
                                     const std::string& path) {
  if (!record.hasRegion())
    return pathError(path + ".region", "the waypoint has no region", "add a box or a part");
  WaypointView waypoint;
  OBBY_ASSIGN(waypoint.target, targets.compile(record.getRegion(), path + ".region", arrive));
  OBBY_ASSIGN(waypoint.maxJumps, jumpsWithin(record.getMaxJumps(), path + ".maxJumps"));
  OBBY_ASSIGN(waypoint.ticks, ticksWithin(record.getTimeLimit(), params, path + ".timeLimit"));
  OBBY_ASSIGN(waypoint.segment,
              segmentLimits(record.getSegmentJumps(), record.getSegmentTime(), params, path + "."));
  return waypoint;
}

// Returns a bit for each state that ends the trajectory.
Result<uint32_t> forbiddenStates(schema::Query::Reader record) {
  using State = schema::PlayerState;
  uint32_t bits = 0, i = 0;
  for (const State state : record.getForbid()) {
    if (state != State::JUMPING && state != State::CLIMBING && state != State::SEATED &&
        state != State::FALLING_DOWN) {
      return pathError(fmt::format("forbid[{}]", i),
                       "every trajectory has this state, so it cannot be forbidden",
                       "forbid only jumping, climbing, seated or fallingDown");
    }
    bits |= 1u << uint32_t(state);
    ++i;
  }
  return bits;
}

// Compiles the limits of the whole trajectory and of its last segment.
Result<QueryView> compileLimits(schema::Query::Reader record, const Params& params) {
  QueryView q;
  OBBY_ASSIGN(q.maxJumps, jumpsWithin(record.getMaxJumps(), "maxJumps"));
  q.minJumps = std::max(record.getMinJumps(), 0);
  if (q.maxJumps >= 0 && q.minJumps > q.maxJumps) {
    return pathError("minJumps", fmt::format("expected minJumps <= maxJumps, found {} and {}",
                                             q.minJumps, q.maxJumps));
  }
  constexpr int32_t kMaxJumps = 65535;  // World::jumps
  if (q.minJumps > kMaxJumps) {
    return pathError("minJumps", fmt::format("expected at most 65535, found {}", q.minJumps));
  }
  OBBY_ASSIGN(q.timeLimitTicks, ticksWithin(record.getTimeLimit(), params, "timeLimit"));
  OBBY_ASSIGN(q.last, segmentLimits(record.getSegmentJumps(), record.getSegmentTime(), params, ""));
  q.maxDamage = record.getMaxDamage();
  if (!(std::isfinite(q.maxDamage) && (q.maxDamage >= 0 || q.maxDamage == -1))) {
    return pathError("maxDamage",
                     "expected 0 or more health (-1: any), found " + shown(q.maxDamage));
  }
  OBBY_ASSIGN(q.forbidden, forbiddenStates(record));
  OBBY_ASSIGN(q.tricks, tricksOf(record.getTricks(), "tricks"));
  constexpr uint16_t kEighth = 65536 / 8;
  q.directionStep = record.getDirections() == schema::Directions::KEYBOARD ? kEighth : 0;
  return q;
}

}  // namespace

Result<Query> Query::compile(schema::Query::Reader record, const Level& level) {
  const Params& params = level.view().params;
  Query q;
  q.id_ = record.getId();
  if (auto players = playersOf(record); !players) return std::move(players).error();
  OBBY_ASSIGN(q.start_, startPose(record, level));
  if (!record.hasGoal() && record.getGoals().size() == 0) {
    return pathError("goal", "the query has no goal", "add a box or a part");
  }
  QueryTargets targets(level.view(), level.partCount(), q.touched_);
  const schema::Arrive arrive = record.getArrive();
  if (record.hasGoal()) {
    OBBY_ASSIGN(const TargetView goal, targets.compile(record.getGoal(), "goal", arrive));
    q.goals_.push_back(goal);
  }
  OBBY_ASSIGN(const auto others, targets.compile(record.getGoals(), "goals", arrive));
  q.goals_.insert(q.goals_.end(), others.begin(), others.end());
  if (record.getWaypoints().size() > kMaxWaypoints) {
    return pathError("waypoints", fmt::format("expected at most {} waypoints, found {}",
                                              kMaxWaypoints, record.getWaypoints().size()));
  }
  for (const auto waypoint : record.getWaypoints()) {
    const std::string path = fmt::format("waypoints[{}]", q.waypoints_.size());
    OBBY_ASSIGN(const WaypointView view, compileWaypoint(waypoint, arrive, params, targets, path));
    q.waypoints_.push_back(view);
  }
  if (record.getVisits().size() > kMaxVisits) {
    return pathError(
        "visits",
        fmt::format("expected at most {} visits, found {}", kMaxVisits, record.getVisits().size()),
        "a #tag counts once for each part with that tag");
  }
  OBBY_ASSIGN(q.visits_, targets.compile(record.getVisits(), "visits", arrive));
  OBBY_ASSIGN(q.avoid_, targets.compile(record.getAvoid(), "avoid", schema::Arrive::TOUCH));
  OBBY_ASSIGN(q.limits_, compileLimits(record, params));
  return q;
}

QueryView Query::view() const {
  QueryView q = limits_;
  q.goal = goals_.front();
  q.otherGoals = goals_.data() + 1;
  q.otherGoalCount = uint32_t(goals_.size()) - 1;
  q.waypoints = waypoints_.data();
  q.waypointCount = uint32_t(waypoints_.size());
  q.visits = visits_.data();
  q.visitCount = uint32_t(visits_.size());
  q.avoid = avoid_.data();
  q.avoidCount = uint32_t(avoid_.size());
  q.touched = touched_.data();
  q.touchedCount = uint32_t(touched_.size());
  q.startTick = start_.tick;
  return q;
}

}  // namespace obby::level
