// Beam search over cells, A*-like: every round goes on from the cells with the least f = ticks so
// far + greed * ticks that are left at best + what the cell has been tried already.
#pragma once

#include "solve/go_explore.h"

namespace obby::solve {

GoExploreSettings beamSettings();

class BeamChooser : public Chooser {
 public:
  explicit BeamChooser(const Problem& problem);

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

  // Ticks to the goal in a straight line through the waypoints ahead, walking. Visits ahead count
  // as the way to the nearest, and from each to what is nearest to it.
  float ticksLeft(const sim::World& world) const;

 private:
  void addCells(const Archive& archive);
  uint64_t blockBest(const Archive& archive, uint32_t block) const;
  uint64_t groupBest(uint32_t group) const;
  void update(const Archive& archive, ThreadPool& pool);
  void rank(const Archive& archive, size_t width);
  void rerank(const Archive& archive, uint32_t cell, uint32_t extra);

  level::QueryView query_;
  float ticksPerStud_;
  std::vector<float> legs_;  // (waypoints + 1), studs from a waypoint to the end; 0 for the goal
  std::vector<float> hops_;  // (visits), studs from a visit to the nearest other or to the goal
  ChunkedVector<uint32_t> extra_;  // (cells), f less the ticks so far; kTaken: not to be ranked
  std::vector<uint64_t> blocks_;   // best rank of each block of cells
  std::vector<uint64_t> groups_;   // best rank of each group of blocks
  uint32_t epoch_ = 0;             // of the archive, in which they were found
  std::vector<uint64_t> ranked_;   // best ranks of all, the best first
};

std::unique_ptr<Chooser> makeBeamChooser(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
