// Adam (Kingma and Ba 2015): one step of an optimiser.
#pragma once

#include <stdint.h>

#include "math/lanes.h"

namespace obby::nn {

// The factors of one optimiser step.
struct AdamStep {
  static constexpr float kMomentum = 0.9f, kSquares = 0.999f, kTiny = 1e-5f;

  float step, unbias;

  // Returns the factors of step `number`, counted from 1.
  static AdamStep at(uint64_t number, float learningRate) {
    return {learningRate / (1 - power(kMomentum, number)), 1 / (1 - power(kSquares, number))};
  }

  // Updates one parameter by its gradient `g`, and the two running means.
  OBBY_DEVICE void update(float g, float& parameter, float& momentum, float& squares) const {
    momentum = kMomentum * momentum + (1 - kMomentum) * g;
    squares = kSquares * squares + (1 - kSquares) * (g * g);
    parameter -= step * momentum / (sqrtf32(squares * unbias) + kTiny);
  }

 private:
  static float power(float base, uint64_t exponent) {
    float result = 1;
    for (; exponent != 0; exponent /= 2, base *= base) {
      if (exponent % 2 != 0) result *= base;
    }
    return result;
  }
};

}  // namespace obby::nn
