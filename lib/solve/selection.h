// Which cells a round starts from: least seen first, leaning toward the goal, hedged so that no
// cell's lean is below a tenth of the best cell's. Integer weights, so that sums are exact and the
// choice is the same on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "base/thread_pool.h"
#include "solve/archive.h"
#include "solve/problem.h"

namespace obby::solve {

// How promising a state is, whatever its count: (1 + 4 max(0, 1 - d / (1.5 d0))) (1 + 3 targets),
// targets the waypoints and visits behind, d the distance to the next region, d0 what it was when
// that became the next; with a choice of regions, the farthest that it can have been.
class Potential {
 public:
  explicit Potential(const Problem& problem);
  float operator()(const sim::World& world) const;

 private:
  level::QueryView query_;
  std::vector<float> spans_;  // (targets + 1), 1.5 d0 of each leg
};

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
