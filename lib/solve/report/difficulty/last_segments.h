// The segment of a solution that the noisy player repeats: its recorded path and keys, and the
// conditions of success.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/model/problem.h"
#include "solve/model/route.h"

namespace obby::solve {

struct LastSegments {
  // `later`: the segments from this one on; this one is the first.
  LastSegments(const Problem& problem, const Course& course, std::span<const Segment> later);

  const Problem& problem;
  const Course& course;
  Segment segment;
  // Ticks from the start of the segment to the end of the stay on `to`. Later ticks of the course
  // are not repeated.
  uint32_t last;
  std::vector<int32_t> jumps;  // ticks of the segment at which its jumps are made
  bool setsOff = false;        // the player begins to walk in the segment
  std::vector<int32_t> ends;   // parts that end the segment: `to` and later parts of the route
  uint32_t timeout;            // ticks after which a trial fails

  bool toGoal() const { return segment.to < 0; }
  // Returns the state `tick` ticks after the start of the segment, or the last state for later
  // ticks.
  const sim::World& at(int32_t tick) const;
  // Returns the action that leads from the state at `tick` to the next one.
  sim::Action actionAt(int32_t tick) const;

  // Returns true if a living player is carried by one of `ends`, with the waypoints and visits that
  // the solution had by then.
  bool arrivesIn(const sim::World& world, const sim::RigidBody* bodies) const;
};

}  // namespace obby::solve
