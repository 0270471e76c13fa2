#include "solve/learned/cell_choice.h"

#include <algorithm>

#include "solve/choosers/selection_weight.h"
#include "solve/rollouts/explore_context.h"

namespace obby::solve::learned {

void CellChoice::act(uint32_t cell) {
  if (cell >= actions_.size()) actions_.resize(cell + 1, 0);
  ++actions_[cell];
}

// Who is in the air is on the way to elsewhere, mostly down.
void CellChoice::update(const Archive& archive) {
  const uint32_t cells = archive.cellCount();
  actions_.resize(std::max<size_t>(actions_.size(), cells), 0);
  stands_.resize(cells);
  running_.resize(cells);
  uint64_t sum = 0;
  for (uint32_t c = 0; c < cells; ++c) {
    if (archive.arrivedSince(c / Archive::kBlock, epoch_)) stands_[c] = grounded(archive.world(c));
    if (stands_[c] || c == 0) sum += 1 + uint64_t(2 * kWeightScale) / (2 + uint64_t(actions_[c]));
    running_[c] = sum;
  }
  epoch_ = archive.epoch();
}

uint32_t CellChoice::pick(Random& random) const {
  const uint64_t at = drawBelow(random, running_.back());
  return uint32_t(std::upper_bound(running_.begin(), running_.end(), at) - running_.begin());
}

}  // namespace obby::solve::learned
