// The route of a trajectory: the parts that carry the player one after another, for example floors,
// trusses and seats.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/simulator.h"
#include "solve/model/problem.h"
#include "solve/model/trajectory.h"

namespace obby::solve {

// Min ticks in a row for a part to count as carrying the player. A player who skids over a corner,
// or walks along a seam with a toe beyond it, is not carried. A player who lands stays longer than
// this, whatever the keys.
constexpr uint32_t kMinStay = 3;

// A trajectory, tick by tick.
struct Course {
  sim::Replay replay;                // (ticks + 1) states, the start first
  std::vector<sim::Action> actions;  // (ticks): actions[t] leads from state t to state t + 1
  std::vector<int32_t> carriers;     // (ticks + 1) parts; -1: no part carries

  uint32_t ticks() const { return uint32_t(actions.size()); }
  const sim::World& at(uint32_t tick) const { return replay.worlds[tick]; }
};

// Replays the trajectory under the query's rules.
Course courseOf(const Problem& problem, const Trajectory& trajectory);

// Returns the parts in order, without repeats. A player who starts on a part is carried from the
// start.
std::vector<int32_t> routeOf(const Course& course);

// Returns the route by which solutions are told apart. It drops trivial detours: a player who
// returns to the previous part without reaching a waypoint or visit has not left it. Thus 0 1 0 2
// and 0 1 3 1 0 2 become 0 2, but a round trip 0 1 3 0 stays. If the player ends in the air, the
// route includes the part on which a fall of kLandingTicks without keys ends. So the route is the
// same whether the goal is reached just before or just after landing.
std::vector<int32_t> directRouteOf(const Problem& problem, const Course& course);

constexpr uint32_t kLandingTicks = 120;

// A segment lasts from the tick at which one part starts to carry the player until the next part
// does. The state at its start is course.at(start) with course.replay.bodiesAtTick(start), before
// course.actions[start].
struct Segment {
  uint32_t start = 0;  // tick of the course
  uint32_t ticks = 0;  // >= 1
  int32_t from = -1;   // part; -1: none yet, at the start of the trajectory
  int32_t to = -1;     // part; -1: the trajectory ends
  uint32_t jumps = 0;  // jumps made in the segment

  uint32_t end() const { return start + ticks; }
};

// Splits the whole course into segments, in order and without gaps.
std::vector<Segment> segmentsOf(const Course& course);

}  // namespace obby::solve
