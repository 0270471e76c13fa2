// The way that a playthrough takes, as the parts that carry the player one after another: floors
// stood on, trusses climbed, seats.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/simulator.h"
#include "solve/model/playthrough.h"
#include "solve/model/problem.h"

namespace obby::solve {

// A part counts as carrying from this many ticks in a row: who skids over a corner, or walks along
// a seam with a toe beyond it, is not carried. A player who lands stays for longer, whatever the
// keys.
constexpr uint32_t kLeastStay = 3;

// A playthrough, tick by tick.
struct Course {
  sim::Replay replay;                // (ticks + 1) states, the start first
  std::vector<sim::Action> actions;  // (ticks): actions[t] leads from state t to state t + 1
  std::vector<int32_t> carriers;     // (ticks + 1) parts; -1: none carries

  uint32_t ticks() const { return uint32_t(actions.size()); }
  const sim::World& at(uint32_t tick) const { return replay.worlds[tick]; }
};

// Plays it once more, under the query's rules.
Course courseOf(const Problem& problem, const Playthrough& playthrough);

// The parts in order, none twice in a row. A player who starts on a part is carried from the start.
std::vector<int32_t> routeOf(const Course& course);

// The same for telling routes apart. Without trivial detours: who comes back to the part before,
// having reached no waypoint and no visit since leaving it, has not left it. 0 1 0 2 and 0 1 3 1 0
// 2 become 0 2; a round trip 0 1 3 0 stays. And with the part that a player who ends in the air
// comes down on within kLandingTicks without keys, if any: whether the goal is reached just before
// or after landing makes no other route.
std::vector<int32_t> directRouteOf(const Problem& problem, const Course& course);

constexpr uint32_t kLandingTicks = 120;

// From coming to be carried by one part to coming to be carried by the next. The state at its start
// is course.at(start), with course.replay.looseAt(start), before course.actions[start].
struct Segment {
  uint32_t start = 0;  // tick of the course
  uint32_t ticks = 0;  // >= 1
  int32_t from = -1;   // part; -1: none yet, at the start of the playthrough
  int32_t to = -1;     // part; -1: the playthrough ends
  uint32_t jumps = 0;  // made in it

  uint32_t end() const { return start + ticks; }
};

// All of the course, in order, without gaps.
std::vector<Segment> segmentsOf(const Course& course);

}  // namespace obby::solve
