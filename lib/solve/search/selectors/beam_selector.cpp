#include "solve/search/selectors/beam_selector.h"

#include <algorithm>

#include "solve/search/archive/block_tasks.h"

namespace obby::solve {

namespace {

constexpr uint32_t kTaken = 0xffffffffu;
constexpr uint64_t kNoRank = ~uint64_t(0);

}  // namespace

GoExploreSettings beamSettings() { return {}; }

void BeamSelector::addCells(const Archive& archive) {
  for (uint32_t cell = uint32_t(extra_.size()); cell < archive.cellCount(); ++cell) {
    extra_.push_back(greedyTicks(route_.view(), query_, archive.world(cell)));
  }
  blocks_.resize(archive.blockCount());
  groups_.resize(groupCount(archive));
}

// A rank is f, then the cell: of two cells with equal f the older one is better.
uint64_t BeamSelector::blockBest(const Archive& archive, uint32_t block) const {
  const uint32_t first = block * Archive::kBlock;
  const uint32_t count = std::min(Archive::kBlock, archive.cellCount() - first);
  const uint32_t* const ticks = archive.ticks().at(first);
  const uint32_t* const extra = extra_.at(first);
  uint64_t best = kNoRank;
  for (uint32_t i = 0; i < count; ++i) {
    const uint64_t rank = (uint64_t(ticks[i]) + extra[i]) << 32 | (first + i);
    best = std::min(best, extra[i] == kTaken ? kNoRank : rank);
  }
  return best;
}

uint64_t BeamSelector::groupBest(uint32_t group) const {
  const size_t first = size_t(group) * kGroupBlocks;
  const size_t end = std::min(first + kGroupBlocks, blocks_.size());
  uint64_t best = kNoRank;
  for (size_t block = first; block < end; ++block) best = std::min(best, blocks_[block]);
  return best;
}

void BeamSelector::update(const Archive& archive, ThreadPool& pool) {
  addCells(archive);
  forGroups(archive, pool, [&](uint32_t group, uint32_t first, uint32_t end) {
    for (uint32_t block = first; block < end; ++block) {
      if (archive.arrivedSince(block, epoch_)) blocks_[block] = blockBest(archive, block);
    }
    groups_[group] = groupBest(group);
  });
  epoch_ = archive.epoch();
}

void BeamSelector::rerank(const Archive& archive, uint32_t cell, uint32_t extra) {
  extra_[cell] = extra;
  const uint32_t block = cell / Archive::kBlock;
  blocks_[block] = blockBest(archive, block);
  groups_[block / kGroupBlocks] = groupBest(block / kGroupBlocks);
}

// Takes the best cell `width` times, then puts all of them back with the penalty for one more try.
void BeamSelector::rank(const Archive& archive, size_t width) {
  ranked_.clear();
  std::vector<uint32_t> extras;
  while (ranked_.size() < width) {
    const uint64_t best = *std::min_element(groups_.begin(), groups_.end());
    if (best == kNoRank) break;
    ranked_.push_back(best);
    extras.push_back(extra_[uint32_t(best)]);
    rerank(archive, uint32_t(best), kTaken);
  }
  for (size_t i = 0; i < ranked_.size(); ++i) {
    rerank(archive, uint32_t(ranked_[i]), extras[i] + kTriedTicks);
  }
}

void BeamSelector::choose(const Archive& archive, ThreadPool& pool, Random&,
                          std::span<Choice> choices) {
  update(archive, pool);
  rank(archive, (choices.size() + kBeamTries - 1) / kBeamTries);
  for (size_t i = 0; i < choices.size(); ++i) {
    choices[i].cell = uint32_t(ranked_[i % ranked_.size()]);
  }
}

std::unique_ptr<Selector> makeBeamSelector(const Problem& problem, const ExploreContext&) {
  return std::make_unique<BeamSelector>(problem);
}

}  // namespace obby::solve
