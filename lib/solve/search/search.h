// The interface of a running search to its driver, watchers and records. Host only.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "solve/model/trajectory.h"
#include "solve/search/rollouts/attempts.h"
#include "solve/search/rollouts/trail.h"

namespace obby::solve {

// The closest approach of the search, and the trajectory to it.
struct Closest : Approach {
  Node node{0, kNone, 0};
};

struct Statistics {
  uint64_t steps = 0;  // simulated ticks
  uint64_t rounds = 0;
  uint64_t rollouts = 0;
  uint64_t idleRollouts = 0;  // rollouts since the last new cell
  uint8_t overruns = 0;       // sim::Flag bits of any attempt
  Closest closest;
};

class Search {
 public:
  virtual ~Search() = default;

  // Tries `count` trajectories of Problem::known from `first` on, like a round. Must precede
  // round().
  virtual void tryWarmStarts(size_t first, size_t count) = 0;

  // Runs one round.
  virtual void round() = 0;

  virtual const Statistics& statistics() const = 0;
  virtual const Attempts& attempts() const = 0;
  virtual uint32_t cellCount() const = 0;
  // Returns the end of the trajectory to the newest cell.
  virtual Node newest() const = 0;
  // Returns the number of cells that only the rollout that found them passed through.
  virtual uint64_t singletons() const = 0;
  // Returns the positions of the feet in the cells from `first` on.
  virtual std::vector<Vec3> places(uint32_t first) const = 0;
  // Returns the error that made the search give up the machine's device, if any.
  virtual const Status& deviceStatus() const = 0;

  // Returns the ends of the last round's trajectories to the goal, sorted by ticks, then jumps.
  virtual const std::vector<Node>& goals() const = 0;
  virtual Trajectory trajectoryTo(const Node& end) const = 0;
};

}  // namespace obby::solve
