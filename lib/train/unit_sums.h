// Sums over a layer's units as lanes, and over lists of what is not zero: what learning on the CPU
// is made of. Host only.
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
  OBBY_LANES void rectify() {
    for (WideFloat& g : group) g = maxf(g, WideFloat(0.0f));
  }
  // 0 for units that are off in `row`.
  OBBY_LANES void stopWhereOff(const float* row) {
    const WideFloat zero(0.0f);
    for (int g = 0; g < kGroups; ++g)
      group[g] = select(load(row + g * kLanes) > zero, group[g], zero);
  }
  OBBY_LANES void put(float* to) const {
    for (int g = 0; g < kGroups; ++g) store(group[g], to + g * kLanes);
  }
};

// Adds `count` rows, one behind the other, to `sums`: (kUnits).
template <int kUnits>
OBBY_LANES void addRows(const float* rows, size_t count, float* sums) {
  UnitSums<kUnits> all(sums);
  for (size_t r = 0; r < count; ++r) all.add(rows + r * kUnits);
  all.put(sums);
}

// A bit for each number of a row that is not zero.
template <int kUnits>
OBBY_LANES uint64_t nonZero(const float* row) {
  static_assert(kUnits <= 64 && kUnits % kLanes == 0);
  uint64_t bits = 0;
  for (int i = 0; i < kUnits; i += kLanes)
    bits |= uint64_t(bitsOf(load(row + i) != WideFloat(0.0f))) << i;
  return bits;
}

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
