// Adam (Kingma and Ba 2015): one step of an optimiser. Host only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/lanes.h"

namespace obby::policy {

// Counts the steps, which say how much the moments are too small yet.
class Adam {
 public:
  static constexpr float kMomentum = 0.9f, kSquares = 0.999f, kTiny = 1e-5f;

  // `steps`: done before, to go on from there.
  explicit Adam(uint64_t steps = 0) : steps_(steps) {}
  uint64_t steps() const { return steps_; }

  // To be called before the updates of each step.
  void next() { ++steps_; }
  // Moves `count` weights against their gradient. `momentum`, `squares`: (count), zero at first.
  void update(float* weights, const float* gradient, float* momentum, float* squares, size_t count,
              float rate) const {
    const float step = rate / (1 - power(kMomentum, steps_));
    const float unbias = 1 / (1 - power(kSquares, steps_));
    for (size_t i = 0; i < count; ++i) {
      const float g = gradient[i];
      momentum[i] = kMomentum * momentum[i] + (1 - kMomentum) * g;
      squares[i] = kSquares * squares[i] + (1 - kSquares) * (g * g);
      weights[i] -= step * momentum[i] / (sqrtf32(squares[i] * unbias) + kTiny);
    }
  }

 private:
  static float power(float base, uint64_t exponent) {
    float result = 1;
    for (; exponent != 0; exponent /= 2, base *= base) {
      if (exponent % 2 != 0) result *= base;
    }
    return result;
  }

  uint64_t steps_;
};

}  // namespace obby::policy
