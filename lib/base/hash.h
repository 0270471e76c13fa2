// Digests of levels, states and trajectories: XXH3 64 bit, the same on every machine for the same
// bytes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace obby {

// Returns the digest of `size` bytes, continued from `seed`: hash(b, hash(a)) digests a then b.
uint64_t hashBytes(const void* data, size_t size, uint64_t seed = 0);

}  // namespace obby
