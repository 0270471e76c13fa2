#include "base/hash.h"

#include <xxhash.h>

namespace obby {

uint64_t hashBytes(const void* data, size_t size, uint64_t seed) {
  return XXH3_64bits_withSeed(data, size, seed);
}

}  // namespace obby
