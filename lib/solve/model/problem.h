// The input of a search: a compiled level and query in plain form, and a budget.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "level/query_view.h"
#include "sim/rigid_body.h"
#include "sim/world.h"

namespace obby::policy {
class Network;
}

namespace obby::solve {

// Actions to hold from the start on, run-length coded.
using ActionRuns = std::vector<sim::ActionRun>;

// Another player, who must reach the goal with the same keys. A search stores the companions'
// states with each state.
struct Companion {
  level::LevelView level;
  level::QueryView query;
  sim::World start;
  std::vector<sim::RigidBody> startBodies;
};

// The level and the query must outlive the search.
struct Problem {
  level::LevelView level;
  level::QueryView query;
  sim::World start;                         // from sim::makeWorld()
  std::vector<sim::RigidBody> startBodies;  // from sim::startBodies()
  Box bounds;                               // bounds of the whole level
  bool hasClock = false;  // moving or timed parts: the outcome depends on the level clock
  std::vector<ActionRuns> known = {};       // trajectories of an earlier answer, tried first
  const policy::Network* policy = nullptr;  // for methods that use one; must outlive the search
  std::vector<Companion> companions = {};   // other players who press the same keys
};

// The answer depends only on the problem, seed, maxSteps, solutions and diverse, unless `seconds`
// or `stop` ends the search. It never depends on the number of threads.
struct Budget {
  uint64_t seed = 1;
  double seconds = std::numeric_limits<double>::infinity();  // wall clock
  uint64_t maxSteps = std::numeric_limits<uint64_t>::max();  // simulated ticks
  uint32_t solutions = 1;                                    // number of distinct solutions to find
  bool diverse = false;                                      // distinct by route, not by path
  uint32_t attempts = 24;                   // number of failed trajectories to show
  const std::atomic<bool>* stop = nullptr;  // set from outside to interrupt
};

}  // namespace obby::solve
