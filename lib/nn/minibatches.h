// How the rows of a batch are cut into minibatches, each of which is a step of the optimiser.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby::nn {

// As few as may have `max` rows each, equal in size to within a row, the larger ones first: a
// minibatch of the rows left over would be as large a step as any other.
class Minibatches {
 public:
  // Both at least 1; together below 2^32.
  OBBY_DEVICE Minibatches(uint32_t rows, uint32_t max)
      : rows_(rows), count_((rows + max - 1) / max) {}

  OBBY_DEVICE uint32_t count() const { return count_; }
  // Rows of minibatch `i`, and those of the ones before it.
  OBBY_DEVICE uint32_t size(uint32_t i) const { return rows_ / count_ + (i < over() ? 1u : 0u); }
  OBBY_DEVICE uint32_t first(uint32_t i) const {
    return rows_ / count_ * i + (i < over() ? i : over());
  }
  OBBY_DEVICE uint32_t largest() const { return size(0); }

 private:
  OBBY_DEVICE uint32_t over() const { return rows_ % count_; }

  uint32_t rows_, count_;
};

}  // namespace obby::nn
