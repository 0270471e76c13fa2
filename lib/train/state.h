// Everything that decides what is learned next, apart from settings and levels, as plain data: what
// a checkpoint (checkpoint.h) keeps.
#pragma once

#include <vector>

#include "base/random.h"
#include "sim/loose.h"
#include "sim/world.h"
#include "train/mlp.h"
#include "train/normaliser.h"

namespace obby::train {

// One world of a crowd.
struct Player {
  sim::World world;
  Turns ahead = 0;     // of what it saw last; not kept, for it looks again before it moves
  float least = 0;     // studs of the way left, the least in this playthrough
  uint32_t ticks = 0;  // of this playthrough
  bool fromStart = true;
};

// Worlds on a level.
struct PlaceState {
  uint64_t taken = 0;      // levels so far, the one it has included
  float hardest = 0;       // difficulty that the level was asked for with
  uint64_t levelHash = 0;  // of the level: that which is made anew must be the same
  uint32_t played = 0;     // playthroughs of the level
  std::vector<Player> players;
  std::vector<sim::LooseBody> loose;  // (players, looseCount)
  std::vector<sim::World> reached;    // by somebody, to begin from
};

// Playthroughs that began at the start of their level, since the last look.
struct Tally {
  uint64_t played = 0, solved = 0;
};

struct CrowdState {
  Random random{0, 0};  // of its playthroughs
  Random draws{0, 0};   // of its moves
  Tally tally;
  std::vector<PlaceState> places;
};

struct LearnerState {
  Weights<float> weights, momentum, squares;  // the last two: Adam's means of gradients
  uint64_t steps = 0;                         // of Adam
  float valueMean = 0, valueDeviation = 1;  // of the value head: a reward is mean + deviation x it
  Sums returns{1};
  Random random{0, 0};
};

struct TrainerState {
  uint64_t iterations = 0, decisions = 0;
  double solved = 0;  // share of playthroughs, smoothed
  float hardest = 0;  // difficulty of the levels that come next, at most
  Sums seen{policy::kInputs};
  LearnerState learner;
  std::vector<CrowdState> crowds;
};

}  // namespace obby::train
