// Worlds that learn together on the CPU: some levels, on each of them a few worlds. What becomes of
// an env group follows from its seed, its levels and the moves alone.
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
  uint32_t levels = 8;         // at a time
  uint32_t worlds = 32;        // on each level
  uint32_t playthroughs = 64;  // on a level, before the next takes its place
  RestartShares restarts;
  float patience = 3;  // times what walking the way takes, and ten seconds, before it is cut
  RewardSettings reward;
  // How worlds are seen, to try other ways: on the CPU only, and kept in no file.
  policy::Observe observe = policy::observe;

  uint32_t size() const { return levels * worlds; }
};

// The level that place `place` of env group `envGroup` among `envGroups` takes as its `taken`th,
// from 1: they share the levels of a source in turns.
uint64_t levelIndex(const EnvGroupSettings& settings, uint32_t envGroup, uint32_t envGroups,
                    uint32_t place, uint64_t taken);

// Error: a state that no place with this level could have, and that does not wait for it.
Status checkPlace(const PlaceState& state, const TrainingLevel& level,
                  const EnvGroupSettings& settings);

// Has enough been played of its level? Then the next takes its place, at the end of an iteration.
inline bool isOver(const PlaceCounts& counts, const EnvGroupSettings& settings) {
  return counts.played >= settings.playthroughs;
}

class EnvGroup {
 public:
  // `number`: of this env group among `envGroups`. The source must outlive it.
  EnvGroup(const LevelSource& source, const EnvGroupSettings& settings, uint64_t seed,
           uint32_t number, uint32_t envGroups);

  // Takes the first levels. Errors: the source's, or that it was told to stop. `hardest`:
  // difficulty of the first two of each place.
  Status begin(float hardest);

  // What restore() goes on from, in another env group of the same source, settings and number.
  // Errors of restore(): those of begin(), and what does not fit settings and levels.
  EnvGroupState state() const;
  Status restore(EnvGroupState state);
  // No level of the source before this one is played, or will be.
  uint64_t firstLevel() const { return firstLevel(places_); }
  uint64_t firstLevelOf(const EnvGroupState& state) const { return firstLevel(state.places); }

  uint32_t size() const { return settings_.size(); }
  // Its number among the worlds of all env groups.
  uint32_t firstWorld() const { return number_ * size(); }

  // `rows`: (size, kInputs), raw; `mayJump`: (size).
  void observe(float* rows, uint8_t* mayJump);

  // After observe(): plays a decision of each world. `moves`, `steps`: (size).
  void step(std::span<const int> moves, std::span<Step> steps);

  // After step(), which played `decision` of each world: begins anew what has ended.
  void settle(uint64_t decision);
  // The same after the last decision of an iteration: cuts what takes too long, and takes new
  // levels where enough was played. The level after each of them will be asked for with difficulty
  // `hardest`: a level ahead, so that it can be made while others are played. The error is the
  // source's. Then, and if it was told to stop, there is nothing more to observe: state() is left.
  Status settleIteration(uint64_t decision, float hardest);

  Tally takeTally();

 private:
  struct Place : PlaceState {                    // a level with its worlds
    std::shared_ptr<const TrainingLevel> level;  // null: it waits
    TrainingView view;
  };

  PlaceView viewOf(Place& place) const;
  // Of a place's level in the source, the taken-th that it has.
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
  sim::LooseBody* looseOf(Place& place, uint32_t player) const;

  const LevelSource& source_;
  EnvGroupSettings settings_;
  uint64_t seed_;
  uint32_t number_, envGroups_;
  std::vector<Place> places_;
  Tally tally_;
  // Of a tick.
  std::vector<sim::World*> worlds_;
  std::vector<sim::LooseBody*> loose_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::train
