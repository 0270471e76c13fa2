#include "solve/search/selectors/selection.h"

#include <algorithm>
#include <numeric>

#include "solve/search/archive/block_tasks.h"

namespace obby::solve {

// The sum does not overflow: a block has at most 2^6 cells of weight 2^20 + 1 at most.
uint32_t CellSelector::blockSum(const Archive& archive, uint32_t block) {
  const uint32_t first = block * Archive::kBlock;
  const uint32_t count = std::min(Archive::kBlock, archive.cellCount() - first);
  const float* const potentials = archive.potentials().at(first);
  const uint32_t* const seen = archive.seen().at(first);
  uint32_t* const weights = weights_.at(first);
  const float best = best_, hedge = hedge_;
  uint32_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) {
    sum += weights[i] = selectionWeight(potentials[i], best, seen[i], hedge);
  }
  return sum;
}

void CellSelector::update(const Archive& archive, ThreadPool& pool) {
  const uint32_t since = archive.bestPotential() == best_ ? epoch_ : 0;
  best_ = archive.bestPotential();
  epoch_ = archive.epoch();
  weights_.resize(archive.cellCount());
  sums_.resize(archive.blockCount());
  running_.resize(groupCount(archive));
  forGroups(archive, pool, [&](uint32_t group, uint32_t first, uint32_t end) {
    for (uint32_t block = first; block < end; ++block) {
      if (archive.seenSince(block, since)) sums_[block] = blockSum(archive, block);
    }
    running_[group] = std::accumulate(sums_.begin() + first, sums_.begin() + end, uint64_t(0));
  });
  std::partial_sum(running_.begin(), running_.end(), running_.begin());
}

uint32_t CellSelector::pick(Random& random) const {
  uint64_t rest = drawBelow(random, running_.back());
  const size_t group =
      size_t(std::upper_bound(running_.begin(), running_.end(), rest) - running_.begin());
  if (group > 0) rest -= running_[group - 1];
  size_t block = group * kGroupBlocks;
  while (rest >= sums_[block]) rest -= sums_[block++];
  size_t cell = block * Archive::kBlock;
  while (rest >= weights_[cell]) rest -= weights_[cell++];
  return uint32_t(cell);
}

void CellSelector::choose(const Archive& archive, ThreadPool& pool, Random& random,
                          std::span<Choice> choices) {
  update(archive, pool);
  for (Choice& c : choices) c.cell = pick(random);
}

std::unique_ptr<Selector> hedgedSelector(const Problem&, const ExploreContext&) {
  return std::make_unique<CellSelector>(kHedge);
}

std::unique_ptr<Selector> plainSelector(const Problem&, const ExploreContext&) {
  return std::make_unique<CellSelector>(0.0f);
}

}  // namespace obby::solve
