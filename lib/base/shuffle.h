// A random permutation that is computed without a table, so that any thread can look up any place.
// It is a Feistel network over the next power of four, applied until the result is in range. It
// serves the order of training, not cryptography.
#pragma once

#include "base/random.h"

namespace obby {

class Shuffle {
 public:
  // `count` is above 0 and at most 2^31. Each stream has its own permutation.
  OBBY_DEVICE Shuffle(uint64_t seed, uint64_t stream, uint32_t count) : count_(count) {
    Random random(seed, stream);
    for (uint32_t& key : keys_) key = random.next();
    while (uint64_t(1) << 2 * halfBits_ < count) ++halfBits_;
  }

  // Returns the item at `place`, which must be below count.
  OBBY_DEVICE uint32_t operator()(uint32_t place) const {
    do {
      place = scrambled(place);
    } while (place >= count_);
    return place;
  }

 private:
  OBBY_DEVICE uint32_t scrambled(uint32_t v) const {
    const uint32_t mask = (1u << halfBits_) - 1;
    uint32_t left = v >> halfBits_, right = v & mask;
    for (const uint32_t key : keys_) {
      const uint32_t mixed = left ^ (mix(right ^ key) & mask);
      left = right;
      right = mixed;
    }
    return left << halfBits_ | right;
  }
  // The finalizer of MurmurHash3 (Appleby, public domain).
  OBBY_DEVICE static uint32_t mix(uint32_t h) {
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
  }

  uint32_t count_, halfBits_ = 1;
  uint32_t keys_[6];
};

}  // namespace obby
