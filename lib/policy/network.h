// The policy's network: two hidden layers of rectified units, a logit for each move and the value.
// Sums run over the inputs in their order, without contraction, so that an answer has the same bits
// on every machine and in every number of lanes. Most of a level is empty: inputs are taken as what
// they differ by from those of an empty one.
#pragma once

#include "math/bits.h"
#include "math/lanes.h"
#include "policy/pilot_view.h"

namespace obby::policy {

constexpr float kMostInput = 5;  // normalised inputs are clamped to this

template <class F>
OBBY_DEVICE F normalised(F v, F mean, F scale) {
  return clampf((v - mean) * scale, F(-kMostInput), F(kMostInput));
}

// Calls visit(i) for the inputs that are not zero, in their order. `in`: (inputs), a multiple of
// the lanes.
template <class F, class Visit>
OBBY_DEVICE void forNonZero(const float* in, int inputs, Visit&& visit) {
  for (int first = 0; first < inputs; first += Lanes<F>::kCount) {
    F row;
    loadRow(in + first, row);
    for (uint32_t bits = laneBits(row != F(0.0f)); bits != 0; bits &= bits - 1) {
      visit(first + lowestBit(bits));
    }
  }
}

// `in`: (inputs), `out`: (outputs). kGroups of lanes at a time share the reads of the inputs.
// Inputs that are zero add nothing, and are most: they are passed over.
template <class F, int kGroups>
OBBY_DEVICE void layer(const LayerView& l, const float* in, int inputs, int outputs, bool rectified,
                       float* out) {
  constexpr int kStep = Lanes<F>::kCount;
  for (int first = 0; first < outputs; first += kStep * kGroups) {
    F sums[kGroups];
    for (int g = 0; g < kGroups; ++g) loadRow(l.biases + first + g * kStep, sums[g]);
    forNonZero<F>(in, inputs, [&](int i) OBBY_INLINED {
      const float* const row = l.weights + i * outputs + first;
#if !defined(__CUDACC__)
#pragma GCC unroll 4
#endif
      for (int g = 0; g < kGroups; ++g) {
        F w;
        loadRow(row + g * kStep, w);
        sums[g] = sums[g] + w * F(in[i]);
      }
    });
    for (int g = 0; g < kGroups; ++g) {
      storeRow(rectified ? maxf(sums[g], F(0.0f)) : sums[g], out + first + g * kStep);
    }
  }
}

OBBY_DEVICE constexpr int least(int a, int b) { return a < b ? a : b; }

// `outputs`: (kPaddedOutputs), logits and value, of raw inputs.
template <class F>
OBBY_DEVICE void think(const NetworkView& network, const float* inputs, float* outputs) {
  constexpr int kLanesOf = Lanes<F>::kCount;
  alignas(64) float x[kInputs], a[kHidden], b[kHidden];
  for (int i = 0; i < kInputs; ++i) {
    x[i] = normalised(inputs[i], network.means[i], network.scales[i]) - network.voids[i];
  }
  layer<F, least(kHidden / kLanesOf, 4)>(network.layers[0], x, kInputs, kHidden, true, a);
  layer<F, least(kHidden / kLanesOf, 4)>(network.layers[1], a, kHidden, kHidden, true, b);
  layer<F, least(kPaddedOutputs / kLanesOf, 3)>(network.layers[2], b, kHidden, kPaddedOutputs,
                                                false, outputs);
}

}  // namespace obby::policy
