// A segment of a solution as a player has it in mind: the recorded path and keys of it, and what
// counts as having done it.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/model/problem.h"
#include "solve/model/route.h"

namespace obby::solve {

struct Leg {
  // `later`: the segments from this one on, of which it is the first.
  Leg(const Problem& problem, const Course& course, std::span<const Segment> later);

  const Problem& problem;
  const Course& course;
  Segment segment;
  // Ticks of the segment after which nothing more of the course is repeated: the end of the stay on
  // `to`.
  uint32_t last;
  std::vector<int32_t> jumps;  // ticks of the segment in which its jumps are made
  bool setsOff = false;        // the player begins to walk in it
  std::vector<int32_t> ends;   // parts that end it: `to` and those behind it on the route
  uint32_t timeout;            // ticks after which a trial has failed

  bool toGoal() const { return segment.to < 0; }
  // `tick` ticks after the start of the segment; the last state for any later tick.
  const sim::World& at(int32_t tick) const;
  // Between two states of it.
  sim::Action actionAt(int32_t tick) const;

  // Has a player, alive, come to be carried where the segment ends, with the waypoints and visits
  // that the solution had by then?
  bool arrivesIn(const sim::World& world, const sim::LooseBody* loose) const;
};

}  // namespace obby::solve
