// The places of a rank on a device: their levels, and transfers of their worlds' state.
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
  // The arguments must outlive this object.
  DevicePlaces(const TrainerSettings& settings, const LevelSource& source, sim::Device& device,
               ThreadPool& pool, uint32_t rank, uint32_t ranks);

  // Call one of these first; see Engine.
  Status begin(float hardest);
  Status restore(std::span<EnvGroupState> envGroups);

  // Fills in the members about places and worlds.
  void describe(PlayArguments& to) const;
  bool anyBodies() const { return anyBodies_; }

  // Call it after an iteration. Takes tallies and replaces levels whose episodes are complete.
  // Requests the levels after those, with difficulty `hardest`, to be made during play. `play`:
  // from describe(). If the source returned no level, only state() may be called afterwards.
  Result<Tally> endIteration(float hardest, const PlayArguments& play);
  // Returns the source's error if it returned no level although it was not stopped.
  const Status& missing() const { return missing_; }

  Result<std::vector<EnvGroupState>> state() const;

 private:
  struct Place {
    uint64_t taken = 0;
    float hardest = 0, nextHardest = 0;
    uint64_t levelHash = 0;
    std::shared_ptr<const sim::Memory> memory;  // holds this level among others
    bool waits = false;                         // has no level yet, as in PlaceState
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
  bool anyBodies_ = false;
  Status missing_;
  NextLevels next_;
  sim::DeviceTable<DevicePlace> table_;
  sim::DeviceTable<Player> players_;
  sim::DeviceTable<Reached> reached_;
  sim::DeviceTable<PlaceCounts> counts_;
};

}  // namespace obby::train
