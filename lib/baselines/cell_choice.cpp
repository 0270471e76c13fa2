#include "baselines/cell_choice.h"

#include <algorithm>

#include "solve/search/selectors/selection_weight.h"

namespace obby::baselines {

void CellChoice::act(uint32_t cell) {
  if (cell >= actions_.size()) actions_.resize(cell + 1, 0);
  ++actions_[cell];
}

void CellChoice::update(uint32_t cells) {
  actions_.resize(std::max<size_t>(actions_.size(), cells), 0);
  running_.resize(cells);
  uint64_t sum = 0;
  for (uint32_t c = 0; c < cells; ++c) {
    sum += 1 + uint64_t(2 * kWeightScale) / (2 + uint64_t(actions_[c]));
    running_[c] = sum;
  }
}

uint32_t CellChoice::pick(Random& random) const {
  const uint64_t at = drawBelow(random, running_.back());
  return uint32_t(std::upper_bound(running_.begin(), running_.end(), at) - running_.begin());
}

}  // namespace obby::baselines
