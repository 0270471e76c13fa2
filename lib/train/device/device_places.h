// The places of a rank on a device: which levels they have, and their worlds' state there and back.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/device_table.h"
#include "train/device/next_levels.h"
#include "train/engine.h"

namespace obby::train {

class DevicePlaces {
 public:
  // What it refers to must outlive it.
  DevicePlaces(const TrainerSettings& settings, const LevelSource& source, sim::Device& device,
               ThreadPool& pool, uint32_t rank, uint32_t ranks);

  // One of these comes first; see Engine.
  Status begin(float hardest);
  Status restore(std::span<EnvGroupState> envGroups);

  // Fills in what is known of places and worlds.
  void describe(PlayArguments& to) const;
  bool anyLoose() const { return anyLoose_; }

  // After an iteration: takes tallies, and new levels where enough was played; asks for the levels
  // after those with difficulty `hardest`, which are made while these are played. `play`: as
  // described. If the source gave none nothing more can be played: state() is left.
  Result<Tally> endIteration(float hardest, const PlayArguments& play);
  // What the source said where it gave none, if it was not told to stop.
  const Status& missing() const { return missing_; }

  Result<std::vector<EnvGroupState>> state() const;

 private:
  struct Place {
    uint64_t taken = 0;
    float hardest = 0, nextHardest = 0;
    uint64_t levelHash = 0;
    std::shared_ptr<const sim::Memory> memory;  // where its level is, with others
    bool waits = false;                         // for its level, as PlaceState
  };

  uint64_t indexOf(size_t place, uint64_t taken) const;
  std::vector<size_t> allPlaces() const;
  void dropPastLevels() const;
  void askForNext(std::span<const size_t> places);
  Status make();
  Result<NextLevel> needed(size_t place);
  Status takeLevels(std::span<const size_t> places, float nextHardest);
  void putIn(size_t place, NextLevel level);
  Status putPlaces();
  Status beginNew();
  Status restorePlace(size_t place, const PlaceState& state);
  Status putState(size_t place, const PlaceState& state);
  Result<PlaceState> stateOf(size_t place) const;

  TrainerSettings settings_;
  const LevelSource& source_;
  sim::Device& device_;
  uint32_t rank_, ranks_;
  std::vector<Place> places_;
  std::vector<DevicePlace> described_;
  bool anyLoose_ = false;
  Status missing_;
  NextLevels next_;
  sim::DeviceTable<DevicePlace> table_;
  sim::DeviceTable<Player> players_;
  sim::DeviceTable<Reached> reached_;
  sim::DeviceTable<PlaceCounts> counts_;
};

}  // namespace obby::train
