// A network's layer for a single row: sums in lanes over the outputs, in the order of the inputs,
// without contraction, with the same bits in every number of lanes.
#pragma once

#include "math/lanes.h"

namespace obby::nn {

// One layer: y = W x + b. Weights by input, (inputs, padded), so that a row is a run of lanes.
struct LayerView {
  const float* weights = nullptr;  // (inputs, padded)
  const float* biases = nullptr;   // (padded)
};

// Numbers, (kMax), put in lane by lane; read are those that are not zero, in their order. One lane
// goes through all of them each time, so that the threads of a GPU read the same weights together.
// WideFloat has its own (policy/policy.cpp).
template <class F, int kMax>
class NonZero {
 public:
  static_assert(Lanes<F>::kCount == 1);
  OBBY_DEVICE void put(int i, F number) { numbers_[i] = number; }

  // Calls visit(i, number).
  template <class Visit>
  OBBY_DEVICE void forEach(Visit&& visit) const {
    for (int i = 0; i < kMax; ++i) {
      if (numbers_[i] != 0) visit(i, numbers_[i]);
    }
  }

 private:
  F numbers_[kMax];
};

// The outputs of one row: calls put(i, lanes) for them in their order. kGroups of lanes at a time
// share the reads of the inputs. Inputs that are zero add nothing, and are most: they are skipped.
template <class F, int kGroups, int kInputs, class Put>
OBBY_DEVICE void linearRow(const LayerView& l, const NonZero<F, kInputs>& in, int outputs,
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

}  // namespace obby::nn
