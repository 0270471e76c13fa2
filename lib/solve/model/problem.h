// What a search is asked: a compiled level and query in plain form, and how much work it may do.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "level/query_view.h"
#include "sim/loose.h"
#include "sim/world.h"

namespace obby::policy {
class Network;
}

namespace obby::solve {

// What to hold, and for how long, from the start on.
using KnownWay = std::vector<sim::ActionRun>;

// Another player, who must reach the goal with the same keys.
struct Companion {
  level::LevelView level;
  level::QueryView query;
  sim::World start;
  std::vector<sim::LooseBody> startLoose;
};

// The level and the query must outlive the search.
struct Problem {
  level::LevelView level;
  level::QueryView query;
  sim::World start;                        // as sim::makeWorld gives it
  std::vector<sim::LooseBody> startLoose;  // as sim::startLoose gives them
  Box bounds;                              // of everything in the level
  bool hasClock = false;  // moving or timed parts: the outcome depends on the level clock
  std::vector<KnownWay> known = {};         // playthroughs of an earlier answer, tried first
  const policy::Network* policy = nullptr;  // for methods that use one; must outlive the search
  std::vector<Companion> companions = {};   // searches that keep states keep those of all of them
};

// The answer depends on seed, maxSteps, solutions, diverse and the problem only, never on the
// number of threads, unless `seconds` or `stop` ends the search.
struct Budget {
  uint64_t seed = 1;
  double seconds = std::numeric_limits<double>::infinity();  // wall clock
  uint64_t maxSteps = std::numeric_limits<uint64_t>::max();  // simulated ticks
  uint32_t solutions = 1;                                    // distinct ones to look for
  bool diverse = false;                                      // distinct by route, not by path
  uint32_t attempts = 24;                                    // failed ones to show
  const std::atomic<bool>* stop = nullptr;                   // set from outside
};

}  // namespace obby::solve
