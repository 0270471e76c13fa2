// The complete state of training, apart from settings and levels, as plain data. A checkpoint
// (checkpoint.h) keeps it.
#pragma once

#include <utility>
#include <vector>

#include "nn/learner.h"
#include "train/normaliser.h"
#include "train/play.h"

namespace obby::train {

// The worlds on a level. A place without players waits: its source was told to stop or had an
// error, and training ended with that iteration.
struct PlaceState {
  uint64_t taken = 0;      // levels so far, including the current one
  float hardest = 0;       // difficulty requested for the level
  float nextHardest = 0;   // difficulty to request for the next level
  uint64_t levelHash = 0;  // checked after a resume
  PlaceCounts counts;
  std::vector<Player> players;
  std::vector<sim::RigidBody> bodies;  // (players, bodyCount)
  std::vector<Reached> reached;        // (counts.reached), restart states

  bool waits() const { return players.empty(); }
};

// Episodes from the start of their level, since the last tally.
struct Tally {
  uint64_t played = 0, solved = 0;

  // Moves the counts of a place into this tally.
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
  double solved = 0;  // share of episodes, smoothed
  float hardest = 0;  // max difficulty of the next levels
  Sums seen{policy::kInputs};
  LearnerState learner;
  std::vector<EnvGroupState> envGroups;
};

}  // namespace obby::train
