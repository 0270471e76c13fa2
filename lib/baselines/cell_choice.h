// Selects the cell of the archive to return to, with a weight of 1 / (1 + actions / 2). Weights are
// integers, so that the choice is the same on every machine. Host only.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "baselines/names.h"

namespace obby::baselines {

class CellChoice {
 public:
  // Counts one more action in a cell.
  void act(uint32_t cell);
  // Call it after actions or cells were added. `cells`: number of cells, at least 1.
  void update(uint32_t cells);
  // Samples a cell by its weight. Safe to call from several threads.
  uint32_t pick(Random& random) const;

 private:
  std::vector<uint32_t> actions_;  // (cells)
  std::vector<uint64_t> running_;  // (cells), cumulative weights
};

}  // namespace obby::baselines
