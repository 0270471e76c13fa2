#include "solve/learned/learner.h"

namespace obby::solve::learned {

float Learner::step(float scale) {
  std::vector<float>& all = gradients_[0];
  const std::vector<float>& weights = net_.numbers();
  float squares[kColumns] = {};  // several sums, so that lanes can take them
  for (size_t i = 0; i < all.size(); ++i) {
    static_assert(kShares == 4);
    const float share = ((all[i] + gradients_[1][i]) + gradients_[2][i]) + gradients_[3][i];
    all[i] = share * scale + settings_.decay * weights[i];
  }
  for (size_t i = 0; i < all.size(); i += kColumns) {
    for (size_t k = 0; k < kColumns; ++k) squares[k] += all[i + k] * all[i + k];
  }
  float sum = 0;
  for (const float s : squares) sum += s;
  const float norm = sqrtf32(sum);
  if (norm > settings_.mostNorm) {
    const float shorter = settings_.mostNorm / norm;
    for (float& g : all) g *= shorter;
  }
  adam_.next();
  adam_.update(net_.numbers().data(), all.data(), momentum_.data(), squares_.data(), all.size(),
               settings_.rate);
  for (auto& g : gradients_) std::fill(g.begin(), g.end(), 0.0f);
  return norm;
}

}  // namespace obby::solve::learned
