// Splits the rows of a batch into minibatches, one for each optimiser step.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby::nn {

// Makes as few minibatches as possible, of up to `max` rows. Sizes differ by at most a row, larger
// ones first: a small remainder would otherwise make as large a step as any other.
class Minibatches {
 public:
  // `rows` and `max` are at least 1; their sum is below 2^32.
  OBBY_DEVICE Minibatches(uint32_t rows, uint32_t max)
      : rows_(rows), count_((rows + max - 1) / max) {}

  OBBY_DEVICE uint32_t count() const { return count_; }
  // size() returns the number of rows of minibatch `i`, first() the number of rows before it.
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
