// Generalised advantage estimation (Schulman et al. 2015).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/device.h"

namespace obby::policy {

// What is known of the decisions of some players, a row each: (ticks, players), those of one tick
// side by side.
struct Played {
  uint32_t ticks, players;
  const float* values;   // (rows), what was expected
  const float* rewards;  // (rows)
  const uint8_t* done;   // (rows), the playthrough ended with this decision
  const float* last;     // (players), value of the state after the last tick
};

// Fills the rows of one player in `advantages` and `targets`, (rows): how much better than expected
// it was, and what it was.
OBBY_DEVICE void fillAdvantagesOf(const Played& p, uint32_t player, float discount, float lambda,
                                  float* advantages, float* targets) {
  float next = p.last[player], advantage = 0;
  for (uint32_t t = p.ticks; t-- > 0;) {
    const size_t i = size_t(t) * p.players + player;
    const float goesOn = p.done[i] ? 0.0f : 1.0f;
    const float surprise = p.rewards[i] + discount * next * goesOn - p.values[i];
    advantage = surprise + discount * lambda * goesOn * advantage;
    advantages[i] = advantage;
    targets[i] = advantage + p.values[i];
    next = p.values[i];
  }
}

OBBY_DEVICE void fillAdvantages(const Played& p, float discount, float lambda, float* advantages,
                                float* targets) {
  for (uint32_t w = 0; w < p.players; ++w)
    fillAdvantagesOf(p, w, discount, lambda, advantages, targets);
}

}  // namespace obby::policy
