#include "solve/report/difficulty/last_segments.h"

#include <algorithm>

#include "sim/carrier.h"

namespace obby::solve {

namespace {

constexpr float kStandsBelow = 1;  // studs/s; a slower player stands

std::vector<int32_t> jumpsOf(const Course& course, const Segment& segment) {
  std::vector<int32_t> jumps;
  for (uint32_t t = segment.start; t < segment.end(); ++t) {
    if (course.at(t + 1).jumps != course.at(t).jumps) jumps.push_back(int32_t(t - segment.start));
  }
  return jumps;
}

bool setsOffIn(const Course& course, const Segment& segment) {
  const Vec3 v = course.at(segment.start).velocity;
  bool walks = v.x * v.x + v.z * v.z > kStandsBelow * kStandsBelow;
  for (uint32_t t = segment.start; t < segment.end(); ++t) {
    if (course.actions[t].walk && !walks) return true;
    walks = course.actions[t].walk;
  }
  return false;
}

uint32_t endOfStay(const Course& course, const Segment& segment) {
  uint32_t t = segment.end();
  while (t < course.ticks() && course.carriers[t + 1] == segment.to) ++t;
  return t - segment.start;
}

}  // namespace

LastSegments::LastSegments(const Problem& p, const Course& c, std::span<const Segment> later)
    : problem(p),
      course(c),
      segment(later.front()),
      last(toGoal() ? segment.ticks : endOfStay(c, segment)),
      jumps(jumpsOf(c, segment)),
      setsOff(setsOffIn(c, segment)),
      timeout(segment.ticks + segment.ticks / 2 + p.level.params.controlRate) {
  for (const Segment& s : later) {
    if (s.to >= 0 && s.to != segment.from) ends.push_back(s.to);
  }
}

const sim::World& LastSegments::at(int32_t tick) const {
  return course.at(segment.start + uint32_t(std::clamp(tick, 0, int32_t(last))));
}

sim::Action LastSegments::actionAt(int32_t tick) const {
  if (tick < 0) return {};
  if (tick < int32_t(last)) return course.actions[segment.start + uint32_t(tick)];
  // A player off the recorded path may have a little farther to go to the goal.
  return toGoal() ? course.actions[segment.end() - 1] : sim::Action{};
}

bool LastSegments::arrivesIn(const sim::World& world, const sim::RigidBody* bodies) const {
  if (toGoal() || !sim::mayBeCarried(world)) return false;
  const sim::World& then = course.at(segment.end());
  if (world.waypoints < then.waypoints || (then.visited & ~world.visited) != 0) return false;
  const uint32_t collider = sim::carrierOf(world, bodies, problem.level);
  if (collider == level::kNone) return false;
  const auto part = int32_t(problem.level.colliders[collider].part);
  return std::find(ends.begin(), ends.end(), part) != ends.end();
}

}  // namespace obby::solve
