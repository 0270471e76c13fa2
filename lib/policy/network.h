// The policy's network: two hidden layers of rectified units, a logit for each move and the value.
// Sums run over the inputs in their order, without contraction, so that an answer has the same bits
// on every machine and in every number of lanes. Most of a level is empty, so the first layer takes
// the inputs' differences from those of an empty level.
#pragma once

#include "policy/pilot_view.h"

namespace obby::policy {

constexpr float kMaxInput = 5;  // normalised inputs are clamped to this

template <class F>
OBBY_DEVICE F normalised(F v, F mean, F scale) {
  return clampf((v - mean) * scale, F(-kMaxInput), F(kMaxInput));
}

OBBY_DEVICE constexpr int smaller(int a, int b) { return a < b ? a : b; }

// Evaluates raw inputs, (kInputs). `outputs`: (kPaddedOutputs), logits and value.
template <class F>
OBBY_DEVICE void think(const NetworkView& network, const float* inputs, float* outputs) {
  constexpr int kStep = Lanes<F>::kCount;
  constexpr int kGroups = smaller(kHidden / kStep, 4), kLast = smaller(kPaddedOutputs / kStep, 3);
  nn::NonZero<F, kInputs> seen;
  for (int i = 0; i < kInputs; i += kStep) {
    F in, mean, scale, empty;
    loadRow(inputs + i, in);
    loadRow(network.means + i, mean);
    loadRow(network.scales + i, scale);
    loadRow(network.voids + i, empty);
    seen.put(i, normalised(in, mean, scale) - empty);
  }
  nn::NonZero<F, kHidden> a, b;
  const nn::LayerView* const layers = network.layers;
  nn::linearRow<F, kGroups>(layers[0], seen, kHidden,
                            [&](int i, F sum) OBBY_INLINED { a.put(i, maxf(sum, F(0.0f))); });
  nn::linearRow<F, kGroups>(layers[1], a, kHidden,
                            [&](int i, F sum) OBBY_INLINED { b.put(i, maxf(sum, F(0.0f))); });
  nn::linearRow<F, kLast>(layers[2], b, kPaddedOutputs,
                          [&](int i, F sum) OBBY_INLINED { storeRow(sum, outputs + i); });
}

}  // namespace obby::policy
