#include "solve/model/route.h"

#include <algorithm>

#include "sim/carrier.h"
#include "solve/model/targets.h"

namespace obby::solve {

namespace {

int32_t carrierAt(const Problem& problem, const sim::Replay& replay, size_t tick) {
  const uint32_t collider =
      sim::carrierOf(replay.worlds[tick], replay.bodiesAtTick(tick).data(), problem.level);
  return collider == level::kNone ? -1 : int32_t(problem.level.colliders[collider].part);
}

// Removes parts that carry the player for fewer than kMinStay ticks.
void dropTouches(std::vector<int32_t>& carriers) {
  for (size_t from = 0; from < carriers.size();) {
    size_t to = from;
    while (to < carriers.size() && carriers[to] == carriers[from]) ++to;
    if (to - from < kMinStay) {
      std::fill(carriers.begin() + std::ptrdiff_t(from), carriers.begin() + std::ptrdiff_t(to), -1);
    }
    from = to;
  }
}

struct Stay {
  int32_t part;
  uint32_t reached;  // waypoints and visits reached when the player left the part
};

// Notes that `part` carries the player for a tick; -1: no part does. A return to the previous part
// without progress removes the detour.
void noteStay(std::vector<Stay>& stays, int32_t part, uint32_t reached) {
  if (part < 0) return;
  const size_t n = stays.size();
  const bool back = n > 1 && stays[n - 2].part == part && stays[n - 2].reached == reached;
  if (back) stays.pop_back();
  if (back || (n > 0 && stays.back().part == part)) {
    stays.back().reached = reached;
  } else {
    stays.push_back({part, reached});
  }
}

// Returns the part that carries the player at the end, or the next one that does within
// kLandingTicks; -1 if none does.
int32_t landingPart(const Problem& problem, const Course& course) {
  sim::World world = course.replay.worlds.back();
  const auto left = course.replay.bodiesAtTick(course.ticks());
  std::vector<sim::RigidBody> bodies(left.begin(), left.end());
  world.outcome = sim::Outcome::running;  // the goal had ended the simulation
  for (uint32_t t = 0; t <= kLandingTicks; ++t) {
    const uint32_t collider = sim::carrierOf(world, bodies.data(), problem.level);
    if (collider != level::kNone) return int32_t(problem.level.colliders[collider].part);
    sim::advance(world, bodies.data(), problem.level, nullptr, {});
    if (world.outcome != sim::Outcome::running) return -1;
  }
  return -1;
}

}  // namespace

Course courseOf(const Problem& problem, const Trajectory& trajectory) {
  const sim::World& start = problem.start;
  sim::Plan plan{{start.position, radiansFromTurns(start.yaw), start.tick},
                 start.yaw,
                 trajectory.actions,
                 problem.level.params.tricks};
  Course course;
  course.replay = sim::replay(problem.level, &problem.query, plan);
  const size_t ticks = course.replay.worlds.size() - 1;
  for (const sim::ActionRun& run : trajectory.actions) {
    const size_t more = std::min(size_t(run.ticks), ticks - course.actions.size());
    course.actions.insert(course.actions.end(), more, run.action);
  }
  for (size_t t = 0; t <= ticks; ++t) {
    course.carriers.push_back(carrierAt(problem, course.replay, t));
  }
  // The simulator senses the floor under the start only in the first tick.
  if (ticks > 0 && course.carriers[0] < 0) course.carriers[0] = course.carriers[1];
  dropTouches(course.carriers);
  return course;
}

std::vector<int32_t> routeOf(const Course& course) {
  std::vector<int32_t> route;
  for (const int32_t part : course.carriers) {
    if (part >= 0 && (route.empty() || route.back() != part)) route.push_back(part);
  }
  return route;
}

std::vector<int32_t> directRouteOf(const Problem& problem, const Course& course) {
  std::vector<Stay> stays;
  for (uint32_t t = 0; t <= course.ticks(); ++t) {
    noteStay(stays, course.carriers[t], targetsReached(course.at(t)));
  }
  noteStay(stays, landingPart(problem, course), targetsReached(course.replay.worlds.back()));
  std::vector<int32_t> route;
  for (const Stay& stay : stays) route.push_back(stay.part);
  return route;
}

std::vector<Segment> segmentsOf(const Course& course) {
  std::vector<Segment> segments;
  Segment s{0, 0, course.carriers[0], -1, 0};
  const auto close = [&](uint32_t tick, int32_t to) {
    s.ticks = tick - s.start;
    s.to = to;
    s.jumps = uint16_t(course.at(tick).jumps - course.at(s.start).jumps);
    if (s.ticks > 0) segments.push_back(s);
    s = {tick, 0, to, -1, 0};
  };
  for (uint32_t t = 1; t <= course.ticks(); ++t) {
    const int32_t part = course.carriers[t];
    if (part >= 0 && part != s.from) close(t, part);
  }
  close(course.ticks(), -1);
  return segments;
}

}  // namespace obby::solve
