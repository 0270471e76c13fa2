// The weight by which cells are chosen, and the draw, for host and device.
#pragma once

#include <stdint.h>

#include "base/random.h"
#include "math/lanes.h"

namespace obby::solve {

constexpr float kWeightScale = 1048576.0f;  // weight of the best potential, never seen

constexpr float kHedge = 0.1f;  // a goal that is near and out of reach must not hold the search up
constexpr uint64_t kSelectionStream = 1ull << 63;  // streams of rollouts count up from 0

// The weight of a cell seen `seen` times: at least 1. `hedge`: the least lean, as a share of the
// best.
OBBY_DEVICE uint32_t selectionWeight(float potential, float best, uint32_t seen, float hedge) {
  const float lean = maxf(potential / best, hedge);
  return 1u + uint32_t(kWeightScale * lean / sqrtf32(float(seen) + 1.0f));
}

// Uniform over [0, n), n > 0; the bias is below n / 2^64.
OBBY_DEVICE uint64_t drawBelow(Random& random, uint64_t n) {
  const uint64_t high = random.next(), low = random.next();
  return uint64_t((__extension__ static_cast<unsigned __int128>(high << 32 | low) * n) >> 64);
}

}  // namespace obby::solve
