// What a device computes for methods that learn while they search: what players see, and networks
// forward and back. A number a thread, summed in the order of the CPU (product.h): the same bits.
#pragma once

#include "policy/observation.h"

namespace obby::solve::learned {

// What all players look at.
struct SightRules {
  level::LevelView level;
  level::QueryView query;
  policy::SurroundingsView surroundings;
};

template <class Table>
OBBY_DEVICE void forTables(SightRules& r, Table&& table) {
  forTables(r.level, table);
  forTables(r.query, table);
  forTables(r.surroundings, table);
}

// A player who looks `ahead` and is to reach `next`.
struct Looker {
  sim::World world;
  geom::Region next;
  Turns ahead;
};

struct SightArguments {
  SightRules rules;
  const Looker* players;        // (players)
  const sim::LooseBody* loose;  // (players, level.looseCount)
  float* inputs;                // (players, policy::kInputs)
};

// `i`: of (players, policy::kViewThreads).
OBBY_DEVICE void seePart(const SightArguments& a, uint32_t i) {
  const uint32_t p = i / policy::kViewThreads, part = i % policy::kViewThreads;
  if (part >= uint32_t(policy::kViewParts)) return;
  const Looker& player = a.players[p];
  const policy::Scene scene{a.rules.level, a.rules.query, a.rules.surroundings};
  sim::NextRegion next;
  next.region = &player.next;
  const size_t bodies = a.rules.level.looseCount;
  policy::observePart(scene, player.world, a.loose + p * bodies, next, player.ahead, int(part),
                      a.inputs + size_t(p) * policy::kInputs);
}

// A layer of a network: out = in x weights + biases, what is below 0 cut off where `rectified`.
struct LayerArguments {
  const float* in;       // (rows, inner)
  const float* weights;  // (inner, width)
  const float* biases;   // (width)
  float* out;            // (rows, width)
  uint32_t inner, width;
  bool rectified;
};

// `i`: of (rows, width).
OBBY_DEVICE void layerUnit(const LayerArguments& a, uint32_t i) {
  const uint32_t row = i / a.width, column = i % a.width;
  const float* const in = a.in + size_t(row) * a.inner;
  float sum = a.biases[column];
  for (uint32_t k = 0; k < a.inner; ++k) sum += in[k] * a.weights[size_t(k) * a.width + column];
  a.out[i] = a.rectified && !(sum > 0) ? 0.0f : sum;
}

// What is added to the gradient of a layer's weights, and after these of its biases.
struct GradientArguments {
  const float* in;     // (rows, inner)
  const float* slope;  // (rows, width)
  float* gradient;     // (inner + 1, width)
  uint32_t rows, inner, width;
};

// `i`: of (inner + 1, width).
OBBY_DEVICE void gradientOfWeight(const GradientArguments& a, uint32_t i) {
  const uint32_t input = i / a.width, column = i % a.width;
  const bool isBias = input == a.inner;
  float sum = a.gradient[i];
  for (uint32_t r = 0; r < a.rows; ++r) {
    const float slope = a.slope[size_t(r) * a.width + column];
    sum += isBias ? slope : a.in[size_t(r) * a.inner + input] * slope;
  }
  a.gradient[i] = sum;
}

// The slope by what a layer is given: slope x transposed(weights), added to what is there.
struct BackArguments {
  const float* slope;    // (rows, width)
  const float* weights;  // (inner, width)
  const float* units;    // (rows, inner): no slope where these are not above 0; or null
  float* out;            // (rows, inner)
  uint32_t inner, width;
};

// `i`: of (rows, inner).
OBBY_DEVICE void slopeBefore(const BackArguments& a, uint32_t i) {
  const uint32_t row = i / a.inner, input = i % a.inner;
  const float* const slope = a.slope + size_t(row) * a.width;
  const float* const weights = a.weights + size_t(input) * a.width;
  float sum = a.out[i];
  for (uint32_t o = 0; o < a.width; ++o) sum += slope[o] * weights[o];
  a.out[i] = a.units != nullptr && !(a.units[i] > 0) ? 0.0f : sum;
}

}  // namespace obby::solve::learned
