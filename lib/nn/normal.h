// Normally distributed random numbers.
#pragma once

#include "base/random.h"

namespace obby::nn {

// Returns the sum of twelve uniform numbers less 6: mean 0, standard deviation 1, within [-6, 6].
// It needs no libm.
OBBY_DEVICE float normal(Random& random) {
  float sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

}  // namespace obby::nn
