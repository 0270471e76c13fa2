// Counter-based random numbers: a pure function of (seed, stream, index), so that any thread or GPU
// lane can draw the numbers of any world in any order, with equal results. Philox4x32-10 (Salmon et
// al. 2011) from Random123.
#pragma once

#include <Random123/philox.h>

#include <cstdint>

#include "base/device.h"

namespace obby {

// One stream of 32-bit random numbers, which repeats after 2^34 of them. A copy draws the same
// numbers as the original from then on.
//   Random random(seed, rollout);
//   const bool jumps = random.unit() < 0.3f;
class Random {
 public:
  // `seed` identifies the run, `stream` the consumer of the numbers (a rollout, a level).
  OBBY_DEVICE Random(uint64_t seed, uint64_t stream)
      : key_{{uint32_t(seed), uint32_t(seed >> 32)}},
        counter_{{0, 0, uint32_t(stream), uint32_t(stream >> 32)}} {}

  // Returns a uniform number of 32 bits.
  OBBY_DEVICE uint32_t next() {
    if (used_ == 4) {
      block_ = r123::Philox4x32()(counter_, key_);
      counter_.v[0]++;
      used_ = 0;
    }
    return block_.v[used_++];
  }

  // Returns a uniform number in [0, n) for n > 0. The bias is below n / 2^32.
  OBBY_DEVICE uint32_t below(uint32_t n) { return uint32_t((uint64_t(next()) * n) >> 32); }

  // Returns a uniform number in [0, 1) with 24 random bits, exactly represented.
  OBBY_DEVICE float unit() { return float(next() >> 8) * 0x1p-24f; }

 private:
  r123::Philox4x32::key_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_{};
  int used_ = 4;
};

}  // namespace obby
