// Adam (Kingma and Ba 2015): one step of an optimiser.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "math/lanes.h"

namespace obby::policy {

// What a step multiplies moments by, and moves one weight against its gradient.
struct AdamStep {
  static constexpr float kMomentum = 0.9f, kSquares = 0.999f, kTiny = 1e-5f;

  float step, unbias;

  OBBY_DEVICE void update(float g, float& weight, float& momentum, float& squares) const {
    momentum = kMomentum * momentum + (1 - kMomentum) * g;
    squares = kSquares * squares + (1 - kSquares) * (g * g);
    weight -= step * momentum / (sqrtf32(squares * unbias) + kTiny);
  }
};

// Counts the steps, which say how much the moments are too small yet.
class Adam {
 public:
  // `steps`: done before, to go on from there.
  explicit Adam(uint64_t steps = 0) : steps_(steps) {}
  uint64_t steps() const { return steps_; }

  // To be called before the updates of each step.
  void next() { ++steps_; }
  // This step at the learning rate `rate`.
  AdamStep at(float rate) const {
    return {rate / (1 - power(AdamStep::kMomentum, steps_)),
            1 / (1 - power(AdamStep::kSquares, steps_))};
  }
  // Moves `count` weights against their gradient. `momentum`, `squares`: (count), zero at first.
  void update(float* weights, const float* gradient, float* momentum, float* squares, size_t count,
              float rate) const {
    const AdamStep step = at(rate);
    for (size_t i = 0; i < count; ++i)
      step.update(gradient[i], weights[i], momentum[i], squares[i]);
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
