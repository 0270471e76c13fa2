// A shuffle as a function: which of `count` things comes at a place, without a table of them all,
// so that any thread can ask for any place. A Feistel network over the next power of four, walked
// until it comes to one of them. For the order of learning, not for secrets.
#pragma once

#include "base/random.h"

namespace obby {

class Shuffle {
 public:
  // `count` > 0, at most 2^31. Another stream is another shuffle.
  OBBY_DEVICE Shuffle(uint64_t seed, uint64_t stream, uint32_t count) : count_(count) {
    Random random(seed, stream);
    for (uint32_t& key : keys_) key = random.next();
    while (uint64_t(1) << 2 * halfBits_ < count) ++halfBits_;
  }

  // `place` < count.
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
  // The end of MurmurHash3 (Appleby, public domain).
  OBBY_DEVICE static uint32_t mix(uint32_t h) {
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
  }

  uint32_t count_, halfBits_ = 1;
  uint32_t keys_[6];
};

}  // namespace obby
