// The loss of quantile regression (QR-DQN, Dabney et al. 2018): Huber losses, weighed so that each
// prediction becomes a quantile of the targets. Host only.
#pragma once

#include <cstddef>

namespace obby::solve::learned {

constexpr size_t kQuantiles = 8;

// `predicted`, `targets`, `slope`: (kQuantiles). Fills the slope by the predictions.
template <class S>
S quantileLoss(const S* predicted, const S* targets, S* slope) {
  S loss = 0;
  for (size_t i = 0; i < kQuantiles; ++i) {
    const S quantile = S(2 * i + 1) / S(2 * kQuantiles);
    slope[i] = 0;
    for (size_t j = 0; j < kQuantiles; ++j) {
      const S error = targets[j] - predicted[i], size = error < 0 ? -error : error;
      const S weight = (error < 0 ? 1 - quantile : quantile) / S(kQuantiles);
      const bool near = size <= 1;
      loss += weight * (near ? error * error / 2 : size - S(0.5));
      slope[i] -= weight * (near ? error : error / size);
    }
  }
  return loss;
}

}  // namespace obby::solve::learned
