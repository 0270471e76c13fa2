// How the rows of a batch are cut into parts, each of which is a step of the optimiser.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby::train {

// As few parts as may have `most` rows each, all of one size or one row apart, the larger ones
// first: a part of the few rows that are left over would be as large a step as any other.
class Parts {
 public:
  // Both at least 1; together below 2^32.
  OBBY_DEVICE Parts(uint32_t rows, uint32_t most) : rows_(rows), count_((rows + most - 1) / most) {}

  OBBY_DEVICE uint32_t count() const { return count_; }
  // Rows of part `i`, and those of the parts before it.
  OBBY_DEVICE uint32_t size(uint32_t i) const { return rows_ / count_ + (i < over() ? 1u : 0u); }
  OBBY_DEVICE uint32_t first(uint32_t i) const {
    return rows_ / count_ * i + (i < over() ? i : over());
  }
  OBBY_DEVICE uint32_t largest() const { return size(0); }

 private:
  OBBY_DEVICE uint32_t over() const { return rows_ % count_; }

  uint32_t rows_, count_;
};

}  // namespace obby::train
