// Generalised advantage estimation (Schulman et al. 2015). Host only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

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

// Fills `advantages` and `targets`, (rows): how much better than expected it was, and what it was.
inline void fillAdvantages(const Played& p, float discount, float lambda,
                           std::span<float> advantages, std::span<float> targets) {
  for (uint32_t w = 0; w < p.players; ++w) {
    float next = p.last[w], advantage = 0;
    for (uint32_t t = p.ticks; t-- > 0;) {
      const size_t i = size_t(t) * p.players + w;
      const float goesOn = p.done[i] ? 0.0f : 1.0f;
      const float surprise = p.rewards[i] + discount * next * goesOn - p.values[i];
      advantage = surprise + discount * lambda * goesOn * advantage;
      advantages[i] = advantage;
      targets[i] = advantage + p.values[i];
      next = p.values[i];
    }
  }
}

}  // namespace obby::policy
