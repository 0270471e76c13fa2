// Everything that decides what is learned next, apart from settings and levels, as plain data: what
// a checkpoint (checkpoint.h) keeps.
#pragma once

#include <utility>
#include <vector>

#include "nn/learner.h"
#include "train/play.h"
#include "train/value_scale.h"

namespace obby::train {

// Worlds on a level. Without players it waits: its source did not give the level, for it was told
// to stop or had an error, and learning ended with that iteration.
struct PlaceState {
  uint64_t taken = 0;      // levels so far, the one it has included
  float hardest = 0;       // difficulty that the level was asked for with
  float nextHardest = 0;   // difficulty that the next one will be asked for with
  uint64_t levelHash = 0;  // of the level: that which is made anew must be the same
  PlaceCounts counts;
  std::vector<Player> players;
  std::vector<sim::LooseBody> loose;  // (players, looseCount)
  std::vector<Reached> reached;       // (counts.reached), to begin from

  bool waits() const { return players.empty(); }
};

// Playthroughs that began at the start of their level, since the last look.
struct Tally {
  uint64_t played = 0, solved = 0;

  // Takes those of a place.
  void add(PlaceCounts& counts) {
    played += std::exchange(counts.fromStart, 0);
    solved += std::exchange(counts.solved, 0);
  }
};

struct EnvGroupState {
  std::vector<PlaceState> places;
};

struct LearnerState : nn::LearnerState {
  ValueScale values;
};

struct TrainerState {
  uint64_t iterations = 0, decisions = 0;
  double solved = 0;  // share of playthroughs, smoothed
  float hardest = 0;  // difficulty of the levels that come next, at most
  Sums seen{policy::kInputs};
  LearnerState learner;
  std::vector<EnvGroupState> envGroups;
};

}  // namespace obby::train
