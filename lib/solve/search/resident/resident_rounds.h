// Rounds of a search whose archive, selection, rollouts and merge are kernels on one device. Only
// the results of a round are copied to the host.
#pragma once

#include <vector>

#include "solve/search/resident/device_archive.h"
#include "solve/search/resident/round_view.h"
#include "solve/search/resident/steps.h"
#include "solve/search/rollouts/explore_setup.h"

namespace obby::solve {

// The results of a round.
struct RoundFindings {
  RoundReport report{};
  uint32_t cells = 0;               // cells in the archive after the round
  std::vector<Node> nodes;          // nodes that the round added
  std::vector<GoalReached> goals;   // best first
  std::vector<ResidentEnd> ends;    // ends of the first rollouts, to show as attempts
  ResidentEnd closest{};            // end of rollout report.closestRollout
  std::vector<uint32_t> endCounts;  // (kOutcomes, endParts), counts over all rollouts
};

// Trajectories that the host has played from the start. `worlds`, `keys` and `ticks`:
// (trajectories, capacity), their visits.
struct PlayedStarts {
  uint32_t capacity = 0;
  std::vector<PlayedStart> trajectories;
  std::vector<sim::World> worlds;
  std::vector<uint64_t> keys;
  std::vector<uint32_t> ticks;
  std::vector<sim::RigidBody> bodies;  // (trajectories, capacity, bodyCount)
};

// A cell, copied to the host.
struct ArchivedCell {
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  uint32_t node, seen;
};

// Memory of the device, one for each table of the arguments.
struct RoundMemory {
  sim::Memory tables, starts, bodies, played, worlds, candidateBodies, keys, ticks, cells, slots,
      finds, findSums, ends, goals, endCounts, nodes, report, claimKeys, claimRanks, claimants,
      shared, rankCounts, rankSums;
};

class ResidentRounds {
 public:
  // The setup must outlive the rounds; the problem need not. Cells beyond `maxCells` are not kept.
  static Result<ResidentRounds> open(sim::Device& device, const ExploreSetup& setup,
                                     const Problem& problem, uint32_t maxCells);

  // Runs one round of rollouts firstRollout, firstRollout + 1, ...
  Result<RoundFindings> run(uint64_t firstRollout, uint32_t rollouts);
  // Runs one round of trajectories that the host has played.
  Result<RoundFindings> take(uint64_t firstRollout, const PlayedStarts& played);

  uint32_t endParts() const { return arguments_.endParts; }
  Result<std::vector<ArchivedCell>> cells(uint32_t first) const;

 private:
  ResidentRounds(sim::Device& device, const ExploreSetup& setup, const Problem& problem,
                 uint32_t maxCells);
  Status openTables(const ExploreSetup& setup, const Problem& problem);
  Status rankCells(uint32_t rollouts);
  Status begin(uint64_t firstRollout, uint32_t rollouts, uint32_t capacity);
  Status reserveRound(uint32_t rollouts, uint32_t capacity);
  Status chooseStarts(uint32_t rollouts);
  Status claim(uint32_t rollouts);
  Status makeClaims(uint32_t candidates);
  Result<RoundFindings> merge(uint32_t rollouts);
  Status place(uint32_t rollouts, RoundFindings& findings);
  Status collect(uint32_t rollouts, RoundFindings& findings) const;
  Status launch(ResidentStep step, uint32_t count) const;
  Status sumUp(const SumTree& tree) const;
  template <class T>
  Status reserve(sim::Memory& memory, T*& table, size_t count) {
    return sim::reserve(*device_, memory, table, count);
  }

  sim::Device* device_;
  uint32_t maxCells_;
  ResidentArguments arguments_{};
  DeviceArchive archive_;
  RoundMemory memory_;
};

}  // namespace obby::solve
