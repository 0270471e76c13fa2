// Go-Explore that lives on a device. Archive, selection, rollouts and merge are kernels over flat
// arrays, so rounds of tens of thousands of rollouts keep a GPU busy and little is copied. Without
// a GPU the CPU runs the same kernels. The result follows from (problem, seed, settings).
#pragma once

#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "base/chunked_vector.h"
#include "sim/host_device.h"
#include "solve/search/archive/archive.h"
#include "solve/search/machine.h"
#include "solve/search/regenerate.h"
#include "solve/search/resident/resident_rounds.h"
#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/search.h"

namespace obby::solve {

struct ResidentSettings {
  // Rounds double with the steps done: small ones answer easy queries soon.
  GoExploreSettings explore{.rollouts = 1024, .maxRollouts = 65536, .explore = {}};
  uint32_t maxCells = kMaxCells;
};

class ResidentExplore final : public Search {
 public:
  // `machine` is used from the first round on. If its device fails, the search starts over on the
  // CPU and finds the same.
  ResidentExplore(const Problem& problem, uint64_t seed, const ResidentSettings& settings,
                  const Machine& machine);

  void tryWarmStarts(size_t first, size_t count) override;
  void round() override;

  const Statistics& statistics() const override { return statistics_; }
  const Attempts& attempts() const override { return attempts_; }
  uint32_t cellCount() const override { return cells_; }
  Node newest() const override;
  uint64_t singletons() const override { return cells_ - sightings_; }
  std::vector<Vec3> places(uint32_t first) const override;
  const Status& deviceStatus() const override { return deviceStatus_; }
  const std::vector<Node>& goals() const override { return goals_; }
  Trajectory trajectoryTo(const Node& end) const override {
    return regenerate(setup_.rules.context, setup_.rules.seed, problem_, nodes_, end);
  }

  const ChunkedVector<Node>& nodes() const { return nodes_; }
  // Returns every cell of the archive, copied from the device.
  std::vector<ArchivedCell> cells() const;

 private:
  // Runs `work`. If the device fails, runs it again on the CPU.
  template <class Work>
  void onDevice(Work&& work);
  void restart();
  Status open();
  Status doRound();
  Status follow(size_t first, size_t count);
  PlayedStarts play(size_t first, size_t count);
  uint32_t roundSize() const;
  void take(const RoundFindings& found, uint64_t firstRollout, uint32_t rollouts);
  void takeEnds(const RoundFindings& found, uint64_t firstRollout);

  const Problem problem_;
  const ResidentSettings settings_;
  Machine machine_;
  const ExploreSetup setup_;
  uint32_t maxRollouts_, maxCells_;
  sim::HostDevice host_;
  std::optional<ResidentRounds> rounds_;
  Status deviceStatus_;
  ChunkedVector<Node> nodes_;  // nodes of all rounds; the device holds only this round's
  uint32_t cells_ = 1, sightings_ = 0;
  std::vector<std::pair<size_t, size_t>> known_;  // tried trajectories: first, count
  uint64_t nextRollout_ = 0;
  std::vector<Node> goals_;
  Attempts attempts_;
  Statistics statistics_;
};

template <class Work>
void ResidentExplore::onDevice(Work&& work) {
  Status done = work();
  if (!done && machine_.device != nullptr) {
    deviceStatus_ = std::move(done);
    machine_.device = nullptr;
    restart();
    done = work();
  }
  // On the CPU only an allocation can fail.
  if (!done) throw std::bad_alloc();
}

}  // namespace obby::solve
