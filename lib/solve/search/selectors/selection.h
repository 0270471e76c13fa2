// Choice by weight: least seen cells first, leaning toward the goal, hedged so that no cell's lean
// is below a share of the best cell's. Integer weights, so that sums are exact and the choice is
// the same on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/search/selectors/chooser.h"
#include "solve/search/selectors/selection_weight.h"

namespace obby::solve {

class Selector : public Chooser {
 public:
  explicit Selector(float hedge) : hedge_(hedge) {}

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

  // Reads the weights of all blocks anew that have changed since the last time, shared by the
  // pool's threads; all of them if there is a new best potential.
  void update(const Archive& archive, ThreadPool& pool);
  // A cell with probability in proportion to its weight.
  uint32_t pick(Random& random) const;

 private:
  uint32_t blockSum(const Archive& archive, uint32_t block);

  float hedge_;
  float best_ = 0;                   // potential that the weights are relative to
  uint32_t epoch_ = 0;               // of the archive, in which they were read
  ChunkedVector<uint32_t> weights_;  // (cells)
  std::vector<uint32_t> sums_;       // (blocks)
  std::vector<uint64_t> running_;    // (groups of blocks), sum up to and including each
};

// With kHedge.
std::unique_ptr<Chooser> hedgedSelector(const Problem& problem, const ExploreContext& context);
// None, as published.
std::unique_ptr<Chooser> plainSelector(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
