// Bit operations that host and device spell differently.
#pragma once

#include <stdint.h>

#include "base/device.h"

namespace obby {

// Returns the index of the lowest bit that is set. `bits` must not be 0.
OBBY_DEVICE int lowestBit(uint64_t bits) {
#if defined(__CUDA_ARCH__)
  return __ffsll(static_cast<long long>(bits)) - 1;
#else
  return __builtin_ctzll(bits);
#endif
}

// Returns the number of bits that are set.
OBBY_DEVICE uint32_t bitCount(uint32_t bits) {
#if defined(__CUDA_ARCH__)
  return uint32_t(__popc(bits));
#else
  return uint32_t(__builtin_popcount(bits));
#endif
}

}  // namespace obby
