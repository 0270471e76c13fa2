// Generalised advantage estimation (Schulman et al. 2015) and the normalisation of advantages.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "math/lanes.h"

namespace obby::nn {

// Decisions of several agents, one row each. Rows are ordered as (steps, agents).
struct Rollout {
  uint32_t steps, agents;
  const float* values;   // (rows), the network's estimates at the time
  const float* rewards;  // (rows)
  const uint8_t* done;   // (rows), true if the episode ended with this decision
  const float* last;     // (agents), value of the state after the last step
};

// Fills one agent's rows of `advantages` and `returns`, (rows). `discount` is per decision, 0 to 1.
// `lambda` 0 estimates by one step, 1 by the rest of the episode.
OBBY_DEVICE void fillAdvantagesOf(const Rollout& r, uint32_t agent, float discount, float lambda,
                                  float* advantages, float* returns) {
  float next = r.last[agent], advantage = 0;
  for (uint32_t t = r.steps; t-- > 0;) {
    const size_t i = size_t(t) * r.agents + agent;
    const float goesOn = r.done[i] ? 0.0f : 1.0f;
    const float surprise = r.rewards[i] + discount * next * goesOn - r.values[i];
    advantage = surprise + discount * lambda * goesOn * advantage;
    advantages[i] = advantage;
    returns[i] = advantage + r.values[i];
    next = r.values[i];
  }
}

// Fills the rows of all agents.
OBBY_DEVICE void fillAdvantages(const Rollout& r, float discount, float lambda, float* advantages,
                                float* returns) {
  for (uint32_t agent = 0; agent < r.agents; ++agent)
    fillAdvantagesOf(r, agent, discount, lambda, advantages, returns);
}

// Sum of some numbers and sum of their squares.
struct Moments {
  double sum = 0, squares = 0;

  OBBY_DEVICE void add(double v) {
    sum += v;
    squares += v * v;
  }
  OBBY_DEVICE void add(const Moments& other) {
    sum += other.sum;
    squares += other.squares;
  }
};

// Shifts and scales advantages to mean 0 and standard deviation 1.
struct AdvantageScale {
  float mean = 0, scale = 1;

  OBBY_DEVICE float operator()(float advantage) const { return (advantage - mean) * scale; }
};

// Returns the normalisation for `count` advantages with these moments. `Real` is the precision of
// the standard deviation, to which `epsilon` is added.
template <class Real>
AdvantageScale advantageScale(const Moments& m, double count, Real epsilon) {
  const double mean = count > 0 ? m.sum / count : 0;
  const double variance = count > 0 ? m.squares / count - mean * mean : 0;
  const Real deviation = Real(__builtin_sqrt(double(Real(variance > 0 ? variance : 0))));
  return {float(mean), float(1 / (deviation + epsilon))};
}

}  // namespace obby::nn
