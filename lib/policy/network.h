// The policy's network: two hidden layers of rectified units, a logit for each move and the value.
// Sums run over the inputs in their order, without contraction, so that an answer has the same bits
// on every machine and in every number of lanes.
#pragma once

#include "math/lanes.h"
#include "policy/moves.h"

namespace obby::policy {

constexpr int kHidden = 64;         // units a layer
constexpr int kPaddedOutputs = 48;  // logits, the value, and padding for every number of lanes
constexpr float kMostInput = 5;     // normalised inputs are clamped to this

// One layer: y = W x + b. Weights by input, (inputs, padded), so that a row is a run of lanes.
struct LayerView {
  const float* weights = nullptr;  // (inputs, padded)
  const float* biases = nullptr;   // (padded)
};

// Plain spans, for device code.
struct NetworkView {
  const float* means = nullptr;   // (kInputs), of the observations that it was trained on
  const float* scales = nullptr;  // (kInputs), 1 / their spread
  LayerView layers[3];            // kInputs -> kHidden -> kHidden -> kPaddedOutputs
};

OBBY_DEVICE float normalised(float v, float mean, float scale) {
  return clampf((v - mean) * scale, -kMostInput, kMostInput);
}

// `in`: (inputs), `out`: (outputs). kGroups of lanes at a time share the reads of the inputs.
template <class F, int kGroups>
OBBY_DEVICE void layer(const LayerView& l, const float* in, int inputs, int outputs, bool rectified,
                       float* out) {
  constexpr int kStep = Lanes<F>::kCount;
  for (int first = 0; first < outputs; first += kStep * kGroups) {
    F sums[kGroups];
    for (int g = 0; g < kGroups; ++g) loadRow(l.biases + first + g * kStep, sums[g]);
    for (int i = 0; i < inputs; ++i) {
      const float* const row = l.weights + i * outputs + first;
#pragma GCC unroll 4
      for (int g = 0; g < kGroups; ++g) {
        F w;
        loadRow(row + g * kStep, w);
        sums[g] = sums[g] + w * F(in[i]);
      }
    }
    for (int g = 0; g < kGroups; ++g) {
      storeRow(rectified ? maxf(sums[g], F(0.0f)) : sums[g], out + first + g * kStep);
    }
  }
}

constexpr int least(int a, int b) { return a < b ? a : b; }

// `outputs`: (kPaddedOutputs), logits and value, of raw inputs.
template <class F>
OBBY_DEVICE void think(const NetworkView& network, const float* inputs, float* outputs) {
  constexpr int kLanesOf = Lanes<F>::kCount;
  alignas(64) float x[kInputs], a[kHidden], b[kHidden];
  for (int i = 0; i < kInputs; ++i) {
    x[i] = normalised(inputs[i], network.means[i], network.scales[i]);
  }
  layer<F, least(kHidden / kLanesOf, 4)>(network.layers[0], x, kInputs, kHidden, true, a);
  layer<F, least(kHidden / kLanesOf, 4)>(network.layers[1], a, kHidden, kHidden, true, b);
  layer<F, least(kPaddedOutputs / kLanesOf, 3)>(network.layers[2], b, kHidden, kPaddedOutputs,
                                                false, outputs);
}

}  // namespace obby::policy
