// Luau's seeded random numbers: PCG32 (O'Neill, "PCG: A Family of Simple Fast Space-Efficient
// Statistically Good Algorithms", 2014). Private to lib/engine.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/settings.h"

namespace obby::engine {

class Random {
 public:
  explicit Random(uint64_t seed, Draws draws = Draws::even) : draws_(draws) {
    (void)next();
    state_ += seed;
    (void)next();
  }
  // Returns a number in [0, 1).
  double share() {
    const uint64_t low = next(), high = next();
    const double even = double(low | (high << 32)) * 0x1p-64;
    if (draws_ == Draws::even) return even;
    double small = even;
    for (int i = 0; i < 7; ++i) small *= small;  // the 128th power
    return draws_ == Draws::low ? small : 1 - std::max(small, 0x1p-53);
  }

 private:
  uint32_t next() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005u + (kStream | 1);
    const uint32_t mixed = uint32_t(((old >> 18) ^ old) >> 27);
    const uint32_t turn = uint32_t(old >> 59);
    return (mixed >> turn) | (mixed << ((32 - turn) & 31));
  }

  static constexpr uint64_t kStream = 105;
  uint64_t state_ = 0;
  Draws draws_;
};

}  // namespace obby::engine
