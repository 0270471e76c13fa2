// The weight by which cells are selected, and the draw. For host and device.
#pragma once

#include <stdint.h>

#include "base/random.h"
#include "math/lanes.h"

namespace obby::solve {

constexpr float kWeightScale = 1048576.0f;  // weight of an unseen cell with the best potential

constexpr float kHedge = 0.1f;  // keeps a near but unreachable goal from stalling the search
constexpr uint64_t kSelectionStream = 1ull << 63;  // streams of rollouts count up from 0

// Returns the weight of a cell seen `seen` times, at least 1. `hedge`: lower bound of the bias, as
// a share of the best.
OBBY_DEVICE uint32_t selectionWeight(float potential, float best, uint32_t seen, float hedge) {
  const float lean = maxf(potential / best, hedge);
  return 1u + uint32_t(kWeightScale * lean / sqrtf32(float(seen) + 1.0f));
}

// Draws uniformly from [0, n), n > 0. The bias is below n / 2^64.
OBBY_DEVICE uint64_t drawBelow(Random& random, uint64_t n) {
  const uint64_t high = random.next(), low = random.next();
  return uint64_t((__extension__ static_cast<unsigned __int128>(high << 32 | low) * n) >> 64);
}

}  // namespace obby::solve
