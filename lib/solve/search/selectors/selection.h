// Selects cells at random by weight: rarely seen cells first, with a bias toward the goal. The
// hedge keeps the bias of each cell above a share of the best cell's. Weights are integers, so that
// sums are exact and the choice is the same on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/search/selectors/selection_weight.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

class CellSelector : public Selector {
 public:
  explicit CellSelector(float hedge) : hedge_(hedge) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

  // Recomputes the weights of blocks that have changed since the last call, on the pool's threads.
  // A new best potential changes all blocks.
  void update(const Archive& archive, ThreadPool& pool);
  // Draws a cell with a probability proportional to its weight.
  uint32_t pick(Random& random) const;

 private:
  uint32_t blockSum(const Archive& archive, uint32_t block);

  float hedge_;
  float best_ = 0;                   // potential that the weights are relative to
  uint32_t epoch_ = 0;               // archive epoch of the last update
  ChunkedVector<uint32_t> weights_;  // (cells)
  std::vector<uint32_t> sums_;       // (blocks)
  std::vector<uint64_t> running_;    // (groups of blocks), inclusive prefix sums
};

// Makes a selector with kHedge.
std::unique_ptr<Selector> hedgedSelector(const Problem& problem, const ExploreContext& context);
// Makes a selector without a hedge, as published.
std::unique_ptr<Selector> plainSelector(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
