// Which cells a round starts from: least seen first, leaning toward the goal, hedged so that no
// cell's lean is below a tenth of the best cell's. Integer weights, so that sums are exact and the
// choice is the same on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "base/thread_pool.h"
#include "solve/archive.h"

namespace obby::solve {

// The weight of a cell seen `seen` times: at least 1.
uint32_t selectionWeight(float potential, float best, uint32_t seen);

class Selector {
 public:
  // Reads all weights anew. O(cells), shared by the pool's threads.
  void update(const Archive& archive, ThreadPool& pool);
  // A cell with probability in proportion to its weight.
  uint32_t pick(Random& random) const;

 private:
  std::vector<uint32_t> weights_;  // (cells)
  std::vector<uint64_t> sums_;     // (blocks), running sum up to and including each block
};

}  // namespace obby::solve
