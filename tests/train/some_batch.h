// A batch of random decisions. Each world has its own random numbers.
#pragma once

#include <vector>

#include "base/random.h"
#include "train/ppo.h"

namespace obby::train {

constexpr uint32_t kTicks = 4;  // ticks of the batch

// Returns the decisions of `worlds` worlds, starting with world number `first`. A world's decisions
// are the same in every batch.
inline Batch someBatch(uint32_t first, uint32_t worlds) {
  Batch b(kTicks, worlds);
  b.seen.normaliseBy(std::vector<float>(policy::kInputs, 0.0f),
                     std::vector<float>(policy::kInputs, 1.0f));
  std::vector<float> raw(policy::kInputs);
  for (uint32_t w = 0; w < worlds; ++w) {
    Random random(9, first + w);
    for (uint32_t t = 0; t <= kTicks; ++t) {
      for (float& v : raw) v = random.unit() - 0.5f;
      b.seen.take(size_t(t) * worlds + w, raw.data());
      if (t == kTicks) break;
      const size_t row = size_t(t) * worlds + w;
      b.decisions[row] = {{int(random.below(policy::kMoves)), -3.5f, 0, 0}, true};
      b.values[row] = random.unit();
      b.rewards[row] = 2 * random.unit() - 1;
      b.done[row] = random.below(4) == 0;
    }
    b.last[w] = random.unit();
  }
  return b;
}

}  // namespace obby::train
