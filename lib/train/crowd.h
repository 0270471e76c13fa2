// Worlds that learn together: some levels, on each of them a few worlds. What becomes of a crowd
// follows from its seed, its levels and the moves alone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "policy/moves.h"
#include "train/state.h"
#include "train/training_level.h"

namespace obby::train {

constexpr uint32_t kMostReached = 16;  // states to begin from that a level keeps

// What is worth how much.
struct RewardSettings {
  float stud = 0.1f;  // of the way left, less than ever before in this playthrough
  float goal = 5;
  float death = -1;         // and anything else that ends a playthrough
  float decision = -0.01f;  // time passes
};

struct CrowdSettings {
  uint32_t levels = 8;         // at a time
  uint32_t worlds = 32;        // on each level
  uint32_t playthroughs = 64;  // on a level, before the next takes its place
  float restartShare = 0.3f;   // of playthroughs that begin where another had come to
  float patience = 3;  // times what walking the way takes, and ten seconds, before it is cut
  RewardSettings reward;
};

// What came of a world's move.
struct Step {
  float reward = 0;
  bool ended = false;  // by a goal, a death, a broken rule
  bool cut = false;    // for lack of time: more could have come of it
};

class Crowd {
 public:
  // `number`: of this crowd among `crowds`, which share the levels of `source` in turns. The source
  // must outlive it.
  Crowd(const LevelSource& source, const CrowdSettings& settings, uint64_t seed, uint32_t number,
        uint32_t crowds);

  // Difficulty of the levels that come next.
  void setHardest(float hardest) { hardest_ = hardest; }

  // Takes the first levels; an error is the source's.
  Status begin();

  // What restore() goes on from, in another crowd of the same source, settings and number; `draws`
  // is the caller's. Errors of restore(): the source's, and what does not fit settings and levels.
  CrowdState state() const;
  Status restore(CrowdState state);
  // No level of the source before this one is played, or will be.
  uint64_t firstLevel() const { return firstLevel(places_); }
  uint64_t firstLevelOf(const CrowdState& state) const { return firstLevel(state.places); }

  uint32_t size() const { return settings_.levels * settings_.worlds; }

  // `rows`: (size, kInputs), raw; `mayJump`: (size).
  void observe(float* rows, uint8_t* mayJump);

  // After observe(): `moves`, `steps`: (size). For those that are cut, what they saw last:
  // cutRows() and whose it is, cutWorlds().
  Status step(std::span<const int> moves, std::span<Step> steps);
  const std::vector<float>& cutRows() const { return cutRows_; }
  const std::vector<uint32_t>& cutWorlds() const { return cutWorlds_; }

  Tally takeTally() { return std::exchange(tally_, {}); }

 private:
  struct Place : PlaceState {  // a level with its worlds
    std::shared_ptr<const TrainingLevel> level;
    uint32_t mostTicks = 0;
  };

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
  Status takeLevel(uint32_t place);
  void restart(Place& place, uint32_t player);
  void remember(Place& place, const sim::World& world);
  void advance(Place& place, std::span<const int> moves);
  Step judge(Place& place, uint32_t player);
  void noteCut(Place& place, uint32_t player, uint32_t row);
  sim::LooseBody* looseOf(Place& place, uint32_t player) const;

  const LevelSource& source_;
  CrowdSettings settings_;
  Random random_;
  uint32_t number_, crowds_;
  float hardest_ = 1;
  std::vector<Place> places_;
  std::vector<float> cutRows_;
  std::vector<uint32_t> cutWorlds_;
  Tally tally_;
  // Of a tick.
  std::vector<sim::World*> worlds_;
  std::vector<sim::LooseBody*> loose_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::train
