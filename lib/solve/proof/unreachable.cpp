#include "solve/proof/unreachable.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "sim/next_region.h"
#include "sim/simulator.h"
#include "solve/proof/crowding.h"

namespace obby::solve {

namespace {

std::string quoted(schema::Region::Reader region) {
  return region.getName().size() > 0 ? fmt::format(" '{}'", region.getName().cStr())
                                     : std::string();
}

// One of the regions that a playthrough has to be in.
struct Target {
  const level::TargetView* view;
  std::string name;
  int32_t mostJumps;  // on arrival; -1: any
};

std::vector<Target> targetsOf(const level::QueryView& q, schema::Query::Reader record) {
  std::vector<Target> targets;
  for (uint32_t i = 0; i < q.waypointCount; ++i) {
    const std::string name = quoted(record.getWaypoints()[i].getRegion());
    targets.push_back({&q.waypoints[i].target, fmt::format("waypoint {}{}", i + 1, name),
                       q.waypoints[i].maxJumps});
  }
  for (uint32_t i = 0; i < q.visitCount; ++i) {
    const std::string name = quoted(record.getVisits()[i]);
    targets.push_back(
        {&q.visits[i], name.empty() ? fmt::format("visit {}", i + 1) : name.substr(1), -1});
  }
  return targets;
}

// A query that forbids the state looks for it after each tick: a pad, a teleporter or a seat that
// is touched in the first tick of a jump has ended it by then.
bool admitsJumps(const Problem& problem) {
  if (problem.query.maxJumps == 0) return false;  // counts such a jump, too
  if (!sim::forbidsJumping(problem.query)) return true;
  constexpr uint32_t kLeads = level::kPad | level::kTeleport | level::kSeat;
  uint32_t flags = 0;
  for (uint32_t i = 0; i < problem.level.colliderCount; ++i) flags |= problem.level.bounds[i].flags;
  return (flags & kLeads) != 0;
}

int32_t lesser(int32_t a, int32_t b) { return a < 0 ? b : b < 0 ? a : std::min(a, b); }

class Prover {
 public:
  Prover(const Problem& problem, schema::Query::Reader record)
      : problem_(problem),
        q_(problem.query),
        targets_(targetsOf(q_, record)),
        mayJump_(admitsJumps(problem)),
        bound_(problem, mayJump_) {
    goals_.push_back(&q_.goal);
    for (uint32_t i = 0; i < q_.otherGoalCount; ++i) goals_.push_back(&q_.otherGoals[i]);
    goalName_ = goals_.size() > 1 ? "any goal"
                                  : "the goal" + (record.hasGoal() ? quoted(record.getGoal()) : "");
  }

  // What holds where all parts are looked at holds as long as nobody comes where some are not.
  // Without what is missing.
  std::optional<Cut> prove() {
    auto cut = leastCut();
    if (cut && bound_.comesInto(crowdedPlaces(problem_.level))) return std::nullopt;
    return cut;
  }

  // Of what prove() has found last.
  Missing missing() const { return beyond_.empty() ? Missing() : bound_.missing(beyond_); }

 private:
  using Targets = std::vector<const level::TargetView*>;

  std::optional<Cut> leastCut() {
    for (const Target& t : targets_) {
      const int32_t most = lesser(t.mostJumps, q_.maxJumps);
      if (auto cut = check({t.view}, t.name, most)) return cut;
    }
    if (auto cut = check(goals_, goalName_, q_.maxJumps)) return cut;
    return late();
  }

  // Any of the targets will do.
  std::optional<Cut> check(const Targets& targets, const std::string& name, int32_t most) {
    uint32_t jumps = ReachBound::kNever;
    for (const level::TargetView* t : targets) {
      jumps = std::min(jumps, bound_.jumpsTo(*t));
      if (jumps != ReachBound::kNever && (most < 0 || jumps <= uint32_t(most))) return std::nullopt;
    }
    Cut cut = start(name);
    if (jumps == ReachBound::kNever) {
      beyond_ = targets;
    } else {
      cut.jumps = jumps;
      cut.mostJumps = uint32_t(most);
    }
    return cut;
  }

  Cut start(const std::string& name) const {
    Cut cut;
    cut.target = name;
    cut.mayJump = mayJump_;
    for (const uint32_t collider : bound_.reached()) {
      cut.reached.push_back(problem_.level.colliders[collider].part);
    }
    std::sort(cut.reached.begin(), cut.reached.end());
    cut.reached.erase(std::unique(cut.reached.begin(), cut.reached.end()), cut.reached.end());
    return cut;
  }

  // Studs to any of them, straight.
  float wayTo(const Targets& any, const Box& from) const {
    float least = 1e30f;
    for (const level::TargetView* t : any)
      least = std::min(least, gapBetween(from, bound_.boxOf(*t)));
    return least;
  }

  // Along the waypoints in order, and by any one visit.
  float leastDistance() const {
    Box at{problem_.start.position, problem_.start.position};
    const Box from = at;
    float walked = 0;
    for (uint32_t i = 0; i < q_.waypointCount; ++i) {
      walked += wayTo({&q_.waypoints[i].target}, at);
      at = bound_.boxOf(q_.waypoints[i].target);
    }
    float around = 0;
    for (uint32_t i = 0; i < q_.visitCount; ++i) {
      const float behind = wayTo(goals_, bound_.boxOf(q_.visits[i]));
      around = std::max(around, wayTo({&q_.visits[i]}, from) + behind);
    }
    return std::max(walked + wayTo(goals_, at), around);
  }

  std::optional<Cut> late() const {
    if (q_.timeLimitTicks == 0) return std::nullopt;
    const Params& p = problem_.level.params;
    const float most = float(q_.timeLimitTicks) * p.tickSeconds;
    const float seconds = bound_.secondsFor(leastDistance()) - 2 * p.tickSeconds;
    if (!(seconds > most)) return std::nullopt;
    Cut cut = start(goalName_);
    cut.seconds = seconds;
    cut.mostSeconds = most;
    return cut;
  }

  const Problem& problem_;
  const level::QueryView& q_;
  std::vector<Target> targets_;
  const bool mayJump_;
  ReachBound bound_;
  Targets goals_;
  Targets beyond_;  // of these none is reached; empty: they are, but not within a limit
  std::string goalName_;
};

// Is anything so far up or down that rounding shows in the height of a jump?
bool isFarUp(const Problem& problem) {
  constexpr float kFar = 16384;  // studs: of places beyond, the last bit is a 512th of a stud
  const Box all = allPlaces(problem);
  return std::max(-all.lo.y, all.hi.y) > kFar;
}

// May the level's clock begin anew within a trajectory? What it moves is elsewhere at once then,
// and takes players along as if it had moved there.
bool clockBeginsAnew(const Problem& problem) {
  constexpr uint64_t kLast = std::numeric_limits<uint32_t>::max();
  return problem.hasClock && problem.start.tick + sim::kMaxReplayTicks > kLast;
}

bool isBounded(const Problem& problem) {
  return unboundedPart(problem.level) == nullptr && !clockBeginsAnew(problem) && !isFarUp(problem);
}

}  // namespace

std::optional<Cut> cutOf(const Problem& problem, schema::Query::Reader record) {
  if (!isBounded(problem)) return std::nullopt;
  Prover prover(problem, record);
  auto cut = prover.prove();
  if (cut) cut->missing = prover.missing();
  return cut;
}

bool isCut(const Problem& problem, schema::Query::Reader record) {
  return isBounded(problem) && Prover(problem, record).prove();
}

void tryTricks(Cut& cut, Problem problem, schema::Query::Reader record) {
  constexpr uint32_t kMostColliders = 4000;  // with tricks, flights go between nearly all of them
  if (problem.level.colliderCount > kMostColliders) return;
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
