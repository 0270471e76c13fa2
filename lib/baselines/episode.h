// One episode of a method that never restores a state: played from the start, tick by tick, with
// the search's records of it. Host only.
#pragma once

#include <unordered_set>
#include <vector>

#include "base/random.h"
#include "baselines/names.h"
#include "policy/moves.h"
#include "sim/rigid_body.h"
#include "solve/model/problem.h"
#include "solve/search/archive/archive_node.h"
#include "solve/search/rollouts/macro_random.h"
#include "solve/search/rollouts/trail.h"

namespace obby::baselines {

// The first time that the player stood in a cell.
struct Passed {
  uint64_t key;   // key of the cell
  Vec3 place;     // feet
  uint32_t tick;  // ticks since the start
};

// A state of a standing player that the archive lacked, or had reached at a later tick.
struct Find {
  uint64_t key;
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  float potential;
  uint32_t ticks;
};

struct Episode {
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  uint32_t ticks = 0;
  ActionRuns actions;                  // all actions so far
  std::unordered_set<uint64_t> stood;  // keys of the cells that the player stood in
  std::vector<Passed> passed;          // the same cells in order
  uint32_t newCells = 0;               // cells that the archive lacked
  std::vector<Find> finds;
  uint64_t key = 0;       // current cell
  uint32_t cell = kNone;  // current cell in the archive, if any
  bool repeats = false;   // replays known actions, so nothing is recorded
  Approach closest;
  uint32_t closestTicks = 0;
};

// Returns the move nearest to `action` for an observation that looks toward `ahead`.
inline int nearestMove(const sim::Action& action, Turns ahead, bool mayJump) {
  constexpr int kStep = 65536 / policy::kHeadings;
  const int direction = int(Turns(action.heading - ahead + kStep / 2)) / kStep;
  const int jump = action.jump && mayJump ? 1 : 0;
  return (action.walk ? direction : policy::kHeadings) * 2 + jump;
}

// Random actions, each held for a whole number of decisions.
class RandomKeys {
 public:
  sim::Action next(Random& random) {
    if (left_ == 0) {
      const RandomMacro macro = drawRandomMacro(random);
      action_ = macro.action;
      left_ = (macro.ticks + policy::kDecisionTicks - 1) / policy::kDecisionTicks;
    }
    --left_;
    return action_;
  }
  void letGo() { left_ = 0; }

 private:
  sim::Action action_{};
  uint32_t left_ = 0;  // decisions
};

}  // namespace obby::baselines
