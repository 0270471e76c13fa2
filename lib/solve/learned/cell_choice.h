// Which cell of the archive to return to: of those in which the player stood, those where few
// actions were taken, with a weight of 1 / (1 + actions / 2). Integer weights, so that the choice
// is the same on every machine. Host only.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "solve/archive/archive.h"

namespace obby::solve::learned {

class CellChoice {
 public:
  // One more action in a cell.
  void act(uint32_t cell);
  // To be called when actions have been added or the archive has changed. Its first cell, the
  // start, can always be chosen.
  void update(const Archive& archive);
  // A cell, by its weight. Safe to call from several threads.
  uint32_t pick(Random& random) const;

 private:
  std::vector<uint32_t> actions_;  // (cells)
  std::vector<uint8_t> stands_;    // (cells)
  uint32_t epoch_ = 0;             // of the archive, when that was read
  std::vector<uint64_t> running_;  // (cells), sum of the weights up to and including each
};

}  // namespace obby::solve::learned
