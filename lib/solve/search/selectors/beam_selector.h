// Beam search over cells, similar to A*: every round continues from the cells with the lowest f
// (beam_view.h).
#pragma once

#include "solve/search/guidance/beam_rank.h"
#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

GoExploreSettings beamSettings();

class BeamSelector : public Selector {
 public:
  explicit BeamSelector(const Problem& problem) : query_(problem.query), route_(problem) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

  float ticksLeft(const sim::World& world) const {
    return solve::ticksLeft(route_.view(), query_, world);
  }

 private:
  void addCells(const Archive& archive);
  uint64_t blockBest(const Archive& archive, uint32_t block) const;
  uint64_t groupBest(uint32_t group) const;
  void update(const Archive& archive, ThreadPool& pool);
  void rank(const Archive& archive, size_t width);
  void rerank(const Archive& archive, uint32_t cell, uint32_t extra);

  level::QueryView query_;
  BeamRoute route_;
  ChunkedVector<uint32_t> extra_;  // (cells), f less the ticks so far; kTaken: not to be ranked
  std::vector<uint64_t> blocks_;   // best rank of each block of cells
  std::vector<uint64_t> groups_;   // best rank of each group of blocks
  uint32_t epoch_ = 0;             // archive epoch of the last update
  std::vector<uint64_t> ranked_;   // this round's ranks, best first
};

std::unique_ptr<Selector> makeBeamSelector(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
