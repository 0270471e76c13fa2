// Which cell of the archive to return to: rather those where few actions were taken, with a weight
// of 1 / (1 + actions / 2). Integer weights, so that the choice is the same on every machine. Host
// only.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"

namespace obby::solve::learned {

class CellChoice {
 public:
  // One more action in a cell.
  void act(uint32_t cell);
  // To be called when actions or cells have been added. `cells`: there are, at least 1.
  void update(uint32_t cells);
  // A cell, by its weight. Safe to call from several threads.
  uint32_t pick(Random& random) const;

 private:
  std::vector<uint32_t> actions_;  // (cells)
  std::vector<uint64_t> running_;  // (cells), sum of the weights up to and including each
};

}  // namespace obby::solve::learned
