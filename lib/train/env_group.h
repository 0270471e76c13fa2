// Worlds that learn together on the CPU: some levels, with a few worlds on each. An env group is a
// function of its seed, its levels and the moves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "policy/policy.h"
#include "train/state.h"
#include "train/training_level.h"

namespace obby::train {

struct EnvGroupSettings {
  uint32_t levels = 8;     // levels at a time
  uint32_t worlds = 32;    // worlds on each level
  uint32_t episodes = 64;  // episodes on a level before the next replaces it
  RestartShares restarts;
  float patience = 3;  // max episode time: this times the route's walking time, plus ten seconds
  RewardSettings reward;
  // Observation function, for experiments. It works only on the CPU, and no file keeps it.
  policy::Observe observe = policy::observe;

  uint32_t size() const { return levels * worlds; }
};

// Returns the index of the `taken`th level (from 1) of place `place` in env group `envGroup`. The
// places of all `envGroups` take the levels of a source in turns.
uint64_t levelIndex(const EnvGroupSettings& settings, uint32_t envGroup, uint32_t envGroups,
                    uint32_t place, uint64_t taken);

// Returns an error for a state that no place with this level can have, unless it waits for the
// level.
Status checkPlace(const PlaceState& state, const TrainingLevel& level,
                  const EnvGroupSettings& settings);

// Returns true if the place's level has had all its episodes. The next level replaces it after the
// iteration.
inline bool isOver(const PlaceCounts& counts, const EnvGroupSettings& settings) {
  return counts.played >= settings.episodes;
}

class EnvGroup {
 public:
  // `number`: index of this env group among `envGroups`. The source must outlive this object.
  EnvGroup(const LevelSource& source, const EnvGroupSettings& settings, uint64_t seed,
           uint32_t number, uint32_t envGroups);

  // Takes the first levels. Errors: the source's, or that it was told to stop. `hardest`:
  // difficulty of each place's first two levels.
  Status begin(float hardest);

  // Returns the state from which restore() resumes, in an env group with the same source, settings
  // and number. restore() has the errors of begin(), and one for a state that does not fit.
  EnvGroupState state() const;
  Status restore(EnvGroupState state);
  // Returns the index of the source's first level that is still being played, or will be.
  uint64_t firstLevel() const { return firstLevel(places_); }
  uint64_t firstLevelOf(const EnvGroupState& state) const { return firstLevel(state.places); }

  uint32_t size() const { return settings_.size(); }
  // Returns the index of its first world among the worlds of all env groups.
  uint32_t firstWorld() const { return number_ * size(); }

  // `rows`: (size, kInputs), raw; `mayJump`: (size).
  void observe(float* rows, uint8_t* mayJump);

  // Call it after observe(). Plays a decision of each world. `moves`, `steps`: (size).
  void step(std::span<const int> moves, std::span<Step> steps);

  // Call it after step(), which played `decision` of each world. Restarts the ended episodes.
  void settle(uint64_t decision);
  // Call it instead of settle() after the last decision of an iteration. Cuts episodes that take
  // too long, and replaces levels that have had all their episodes. The level after each is
  // requested with difficulty `hardest`, so that it is made while others are played. Errors: the
  // source's. After an error, or if the source was told to stop, only state() may be called.
  Status settleIteration(uint64_t decision, float hardest);

  Tally takeTally();

 private:
  struct Place : PlaceState {                    // a level with its worlds
    std::shared_ptr<const TrainingLevel> level;  // null while the place waits
    TrainingView view;
  };

  PlaceView viewOf(Place& place) const;
  // Returns the source's index of the place's `taken`th level.
  uint64_t indexOf(uint32_t place, uint64_t taken) const;
  template <class Places>
  uint64_t firstLevel(const Places& places) const {
    uint64_t first = ~uint64_t(0);
    for (uint32_t p = 0; p < places.size(); ++p)
      first = std::min(first, indexOf(p, places[p].taken));
    return first;
  }
  Status findLevel(uint32_t place);
  Status needLevel(uint32_t place);
  Status takeLevel(uint32_t place, float nextHardest);
  void beginPlace(Place& place);
  void settle(uint64_t decision, bool endOfIteration);
  void advance(Place& place, std::span<const int> moves);
  sim::RigidBody* bodiesOf(Place& place, uint32_t player) const;

  const LevelSource& source_;
  EnvGroupSettings settings_;
  uint64_t seed_;
  uint32_t number_, envGroups_;
  std::vector<Place> places_;
  Tally tally_;
  // Buffers that step() and settle() use in each tick.
  std::vector<sim::World*> worlds_;
  std::vector<sim::RigidBody*> bodies_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::train
