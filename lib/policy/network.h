// The policy's network: two hidden layers of rectified units, a logit for each move and the value.
// Sums run over the inputs in their order, without contraction, so that an answer has the same bits
// on every machine and in every number of lanes. Most of a level is empty: inputs are taken as what
// they differ by from those of an empty one.
#pragma once

#include "math/lanes.h"
#include "policy/pilot_view.h"

namespace obby::policy {

constexpr float kMostInput = 5;  // normalised inputs are clamped to this

template <class F>
OBBY_DEVICE F normalised(F v, F mean, F scale) {
  return clampf((v - mean) * scale, F(-kMostInput), F(kMostInput));
}

// Numbers, (kMost), put in by rows: asked for are those that are not zero, in their order. One lane
// goes through all of them each time, so that the threads of a GPU read the same weights together.
// WideFloat has its own (policy.cpp).
template <class F, int kMost>
class NonZero {
 public:
  static_assert(Lanes<F>::kCount == 1);
  OBBY_DEVICE void put(int i, F number) { numbers_[i] = number; }

  // Calls visit(i, number).
  template <class Visit>
  OBBY_DEVICE void forEach(Visit&& visit) const {
    for (int i = 0; i < kMost; ++i) {
      if (numbers_[i] != 0) visit(i, numbers_[i]);
    }
  }

 private:
  F numbers_[kMost];
};

// put(i, row) is called for rows of the sums, in their order. kGroups of lanes at a time share the
// reads of the inputs. Inputs that are zero add nothing, and are most: they are passed over.
template <class F, int kGroups, int kInputsOf, class Put>
OBBY_DEVICE void layer(const LayerView& l, const NonZero<F, kInputsOf>& in, int outputs,
                       Put&& put) {
  constexpr int kStep = Lanes<F>::kCount;
  for (int first = 0; first < outputs; first += kStep * kGroups) {
    F sums[kGroups];
    for (int g = 0; g < kGroups; ++g) loadRow(l.biases + first + g * kStep, sums[g]);
    in.forEach([&](int i, float number) OBBY_INLINED {
      const float* const row = l.weights + i * outputs + first;
#if !defined(__CUDACC__)
#pragma GCC unroll 4
#endif
      for (int g = 0; g < kGroups; ++g) {
        F w;
        loadRow(row + g * kStep, w);
        sums[g] = sums[g] + w * F(number);
      }
    });
    for (int g = 0; g < kGroups; ++g) put(first + g * kStep, sums[g]);
  }
}

OBBY_DEVICE constexpr int least(int a, int b) { return a < b ? a : b; }

// `outputs`: (kPaddedOutputs), logits and value, of raw inputs.
template <class F>
OBBY_DEVICE void think(const NetworkView& network, const float* inputs, float* outputs) {
  constexpr int kStep = Lanes<F>::kCount;
  constexpr int kGroups = least(kHidden / kStep, 4), kLast = least(kPaddedOutputs / kStep, 3);
  NonZero<F, kInputs> seen;
  for (int i = 0; i < kInputs; i += kStep) {
    F in, mean, scale, empty;
    loadRow(inputs + i, in);
    loadRow(network.means + i, mean);
    loadRow(network.scales + i, scale);
    loadRow(network.voids + i, empty);
    seen.put(i, normalised(in, mean, scale) - empty);
  }
  NonZero<F, kHidden> a, b;
  const LayerView* const layers = network.layers;
  layer<F, kGroups>(layers[0], seen, kHidden,
                    [&](int i, F sum) OBBY_INLINED { a.put(i, maxf(sum, F(0.0f))); });
  layer<F, kGroups>(layers[1], a, kHidden,
                    [&](int i, F sum) OBBY_INLINED { b.put(i, maxf(sum, F(0.0f))); });
  layer<F, kLast>(layers[2], b, kPaddedOutputs,
                  [&](int i, F sum) OBBY_INLINED { storeRow(sum, outputs + i); });
}

}  // namespace obby::policy
