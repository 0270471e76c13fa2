// A search at work, as the loop that drives it, its watchers and its records see it. Host only.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "solve/model/playthrough.h"
#include "solve/search/rollouts/attempts.h"
#include "solve/search/rollouts/trail.h"

namespace obby::solve {

// How far the search has come, and the way there.
struct Closest : Approach {
  Node way{0, kNone, 0};
};

struct Statistics {
  uint64_t steps = 0;  // simulated ticks
  uint64_t rounds = 0;
  uint64_t rollouts = 0;
  uint64_t idleRollouts = 0;  // since the last that found a new cell
  uint8_t overruns = 0;       // sim::Flag bits of any attempt
  Closest closest;
};

class Search {
 public:
  virtual ~Search() = default;

  // Tries `count` ways of Problem::known from `first` on; to be called before round(), and like it.
  virtual void tryKnown(size_t first, size_t count) = 0;

  // One round.
  virtual void round() = 0;

  virtual const Statistics& statistics() const = 0;
  virtual const Attempts& attempts() const = 0;
  virtual uint32_t cellCount() const = 0;
  // The way to the newest cell.
  virtual Node newest() const = 0;
  // Cells that only their finder passed through.
  virtual uint64_t singletons() const = 0;
  // Feet in the cells from `first` on.
  virtual std::vector<Vec3> places(uint32_t first) const = 0;
  // Why the machine's device was given up, if it was.
  virtual const Status& deviceStatus() const = 0;

  // Ways to the goal of the last round, fewest ticks, then jumps, first.
  virtual const std::vector<Node>& goals() const = 0;
  virtual Playthrough playthrough(const Node& end) const = 0;
};

}  // namespace obby::solve
