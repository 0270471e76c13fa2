#include "solve/proof/unreachable.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "sim/next_region.h"
#include "sim/simulator.h"

namespace obby::solve {

namespace {

using Targets = std::vector<const level::TargetView*>;

// A trajectory must enter at least one of these targets.
struct Demand {
  Targets any;
  std::string name;
  int32_t maxJumps;  // max jumps on arrival; -1: any number
};

std::string quoted(schema::Region::Reader region) {
  return region.getName().size() > 0 ? fmt::format(" '{}'", region.getName().cStr())
                                     : std::string();
}

int32_t lesser(int32_t a, int32_t b) { return a < 0 ? b : b < 0 ? a : std::min(a, b); }

// Returns the waypoints in order, the visits, and the goal.
std::vector<Demand> demandsOf(const level::QueryView& q, schema::Query::Reader record) {
  std::vector<Demand> demands;
  for (uint32_t i = 0; i < q.waypointCount; ++i) {
    const std::string name = quoted(record.getWaypoints()[i].getRegion());
    demands.push_back({{&q.waypoints[i].target},
                       fmt::format("waypoint {}{}", i + 1, name),
                       lesser(q.waypoints[i].maxJumps, q.maxJumps)});
  }
  for (uint32_t i = 0; i < q.visitCount; ++i) {
    const std::string name = quoted(record.getVisits()[i]);
    demands.push_back({{&q.visits[i]},
                       name.empty() ? fmt::format("visit {}", i + 1) : name.substr(1),
                       q.maxJumps});
  }
  Targets goals{&q.goal};
  for (uint32_t i = 0; i < q.otherGoalCount; ++i) goals.push_back(&q.otherGoals[i]);
  const std::string name = record.hasGoal() ? quoted(record.getGoal()) : "";
  demands.push_back({goals, goals.size() > 1 ? "any goal" : "the goal" + name, q.maxJumps});
  return demands;
}

// Returns true if players may jump. A query that forbids jumping checks the state after each tick.
// A pad, teleporter or seat that is touched in the first tick of a jump has ended the jump by then.
bool admitsJumps(const Problem& problem) {
  if (problem.query.maxJumps == 0) return false;  // maxJumps counts every jump
  if (!sim::forbidsJumping(problem.query)) return true;
  const auto leads = [](const level::Bounds& b) {
    return (b.flags & (level::kPad | level::kTeleport | level::kSeat)) != 0;
  };
  const level::LevelView& level = problem.level;
  return std::any_of(level.bounds, level.bounds + level.colliderCount, leads);
}

// Returns the straight distance along the waypoints to the nearest goal, in studs.
float minDistance(const Problem& problem, const Targets& goals, const ReachBound& bound) {
  Box at{problem.start.position, problem.start.position};
  float studs = 0, last = 1e30f;
  for (uint32_t i = 0; i < problem.query.waypointCount; ++i) {
    const Box to = bound.boxOf(problem.query.waypoints[i].target);
    studs += gapBetween(at, to);
    at = to;
  }
  for (const level::TargetView* t : goals) last = std::min(last, gapBetween(at, bound.boxOf(*t)));
  return studs + last;
}

std::vector<uint32_t> partsOf(const level::LevelView& level, const std::vector<uint32_t>& ids) {
  std::set<uint32_t> parts;
  for (const uint32_t id : ids) parts.insert(level.colliders[id].part);
  return {parts.begin(), parts.end()};
}

bool isBounded(const Problem& problem) {
  // Farther away the last bit is 1/512 of a stud, so rounding affects the height of a jump.
  constexpr float kFar = 16384;  // studs
  const Box all = allPlaces(problem);
  if (std::max(-all.lo.y, all.hi.y) > kFar) return false;
  // When the level's clock wraps around, the parts that it moves change place at once and take
  // players along.
  constexpr uint64_t kLast = std::numeric_limits<uint32_t>::max();
  if (problem.hasClock && problem.start.tick + sim::kMaxReplayTicks > kLast) return false;
  return unboundedPart(problem.level) == nullptr;
}

// Returns the cut of the first demand that cannot be met within its max jumps, or else the cut of
// the time limit.
std::optional<Cut> prove(const Problem& problem, schema::Query::Reader record, bool withMissing) {
  if (!isBounded(problem)) return std::nullopt;
  Cut cut;
  cut.mayJump = admitsJumps(problem);
  const ReachBound bound(problem, cut.mayJump);
  cut.reached = partsOf(problem.level, bound.reached());
  const std::vector<Demand> demands = demandsOf(problem.query, record);
  for (const Demand& d : demands) {
    cut.target = d.name;
    uint32_t jumps = ReachBound::kNever;
    for (const level::TargetView* t : d.any) jumps = std::min(jumps, bound.jumpsTo(*t));
    if (jumps == ReachBound::kNever) {
      if (withMissing) cut.missing = bound.missing(d.any);
      return cut;
    }
    if (d.maxJumps < 0 || jumps <= uint32_t(d.maxJumps)) continue;
    cut.jumps = jumps;
    cut.maxJumps = uint32_t(d.maxJumps);
    return cut;
  }
  const float tick = problem.level.params.tickSeconds;
  cut.maxSeconds = float(problem.query.timeLimitTicks) * tick;
  cut.seconds = bound.secondsFor(minDistance(problem, demands.back().any, bound)) - 2 * tick;
  const bool late = problem.query.timeLimitTicks != 0 && cut.seconds > cut.maxSeconds;
  return late ? std::optional(cut) : std::nullopt;
}

}  // namespace

std::optional<Cut> cutOf(const Problem& problem, schema::Query::Reader record) {
  return prove(problem, record, true);
}

bool isCut(const Problem& problem, schema::Query::Reader record) {
  return prove(problem, record, false).has_value();
}

void tryTricks(Cut& cut, Problem problem, schema::Query::Reader record) {
  constexpr uint32_t kMaxColliders = 10'000;  // with tricks, flights connect nearly all colliders
  if (problem.level.colliderCount > kMaxColliders) return;
  uint16_t& tricks = problem.level.params.tricks;
  const uint16_t allowed = tricks;
  tricks = kAllTricks;
  cut.withTricks = allowed == kAllTricks || isCut(problem, record);
  for (uint16_t trick = 1; !cut.withTricks && trick <= kAllTricks; trick = uint16_t(2 * trick)) {
    tricks = uint16_t(allowed | trick);
    if (tricks != allowed && !isCut(problem, record)) cut.mayHelp |= trick;
  }
}

}  // namespace obby::solve
