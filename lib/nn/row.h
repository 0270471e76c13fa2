// A network's layer for a single row. Sums are vectorised over the outputs, follow the order of the
// inputs and are not fused, so their bits are the same for any lane width.
#pragma once

#include "math/lanes.h"

namespace obby::nn {

// One layer: y = W x + b. Weights are input-major, (inputs, padded), so that lanes read a row.
struct LayerView {
  const float* weights = nullptr;  // (inputs, padded)
  const float* biases = nullptr;   // (padded)
};

// A vector of kMax numbers. put() stores one lane group at a time, and forEach() visits the
// non-zero numbers in order. This form has one lane and scans all numbers, so that the threads of a
// GPU read the same weights together. policy/policy.cpp specialises it for WideFloat.
template <class F, int kMax>
class NonZero {
 public:
  static_assert(Lanes<F>::kCount == 1);
  OBBY_DEVICE void put(int i, F number) { numbers_[i] = number; }

  // Calls visit(i, number) for each number that is not zero.
  template <class Visit>
  OBBY_DEVICE void forEach(Visit&& visit) const {
    for (int i = 0; i < kMax; ++i) {
      if (numbers_[i] != 0) visit(i, numbers_[i]);
    }
  }

 private:
  F numbers_[kMax];
};

// Computes the outputs of one row and calls put(i, lanes) for them in order. kGroups lane groups at
// a time share the reads of the inputs. Zero inputs, the majority, are skipped.
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
