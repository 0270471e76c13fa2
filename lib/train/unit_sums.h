// Sums over a layer's units as lanes, and over lists of bits: what rows that are mostly empty are
// learned from with. Host only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/bits.h"
#include "simd/wide.h"

namespace obby::train {

// A number for each of a layer's units, in registers. Products are added unfused, so that the sums
// are the same for any number of lanes.
template <int kUnits>
struct UnitSums {
  static constexpr int kGroups = kUnits / kLanes;
  static_assert(kUnits % kLanes == 0);

  WideFloat group[kGroups];

  OBBY_LANES explicit UnitSums(const float* from) {
    for (int g = 0; g < kGroups; ++g) group[g] = load(from + g * kLanes);
  }
  OBBY_LANES void add(const float* row) {
    for (int g = 0; g < kGroups; ++g) group[g] = group[g] + load(row + g * kLanes);
  }
  OBBY_LANES void add(const float* row, float times) {
    const WideFloat all(times);
    for (int g = 0; g < kGroups; ++g) group[g] = group[g] + load(row + g * kLanes) * all;
  }
  OBBY_LANES void put(float* to) const {
    for (int g = 0; g < kGroups; ++g) store(group[g], to + g * kLanes);
  }
};

// Calls visit(number of the bit) from the lowest on.
template <class Visit>
OBBY_LANES void forBits(uint64_t bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(lowestBit(bits));
}

// Bit j of word i becomes bit i of word j: blocks of 32, 16, ... 1 change sides.
inline void transpose(uint64_t words[64]) {
  uint64_t mask = 0xffffffffu;
  for (int size = 32; size != 0; size /= 2, mask ^= mask << size) {
    for (int i = 0; i < 64; i = (i + size + 1) & ~size) {
      const uint64_t swap = (words[i] >> size ^ words[i + size]) & mask;
      words[i] ^= swap << size;
      words[i + size] ^= swap;
    }
  }
}

}  // namespace obby::train
