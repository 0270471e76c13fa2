// Counter-based random numbers: a pure function of (seed, stream, index), so that any thread or GPU
// lane can draw the numbers of any world in any order and get the same ones. Philox4x32-10 (Salmon
// et al. 2011) from Random123.
#pragma once

#include <Random123/philox.h>

#include <cstdint>

#include "base/device.h"

namespace obby {

// One stream of 32-bit numbers. 12 bytes of identity, a small buffer; copying it forks the
// sequence.
class Random {
 public:
  // `stream` tells the user of the numbers (a rollout, a level), `seed` the run.
  OBBY_DEVICE Random(uint64_t seed, uint64_t stream)
      : key_{{uint32_t(seed), uint32_t(seed >> 32)}},
        counter_{{0, 0, uint32_t(stream), uint32_t(stream >> 32)}} {}

  // Uniform over all 32-bit numbers.
  OBBY_DEVICE uint32_t next() {
    if (used_ == 4) {
      block_ = r123::Philox4x32()(counter_, key_);
      counter_.v[0]++;
      used_ = 0;
    }
    return block_.v[used_++];
  }

  // Uniform over [0, n), n > 0; the bias is below n / 2^32.
  OBBY_DEVICE uint32_t below(uint32_t n) { return uint32_t((uint64_t(next()) * n) >> 32); }

  // Uniform over [0, 1): 24 bits, every value exact.
  OBBY_DEVICE float unit() { return float(next() >> 8) * 0x1p-24f; }

 private:
  r123::Philox4x32::key_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_{};
  int used_ = 4;
};

}  // namespace obby
