// Normally distributed random numbers.
#pragma once

#include "base/random.h"

namespace obby::nn {

// Near enough mean 0 and standard deviation 1, without libm: the sum of twelve uniform numbers.
// Never beyond 6.
OBBY_DEVICE float normal(Random& random) {
  float sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

}  // namespace obby::nn
