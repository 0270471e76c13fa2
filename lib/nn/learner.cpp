#include "nn/learner.h"

namespace obby::nn {

Learner::Learner(Network<float> net, size_t shares)
    : net_(std::move(net)),
      gradients_(shares, std::vector<float>(net_.parameters().size())),
      momentum_(gradients_[0]),
      squares_(gradients_[0]) {}

void Learner::restore(const LearnerState& state) {
  net_.parameters() = state.parameters;
  momentum_ = state.momentum;
  squares_ = state.squares;
  steps_ = state.steps;
}

std::vector<float>& Learner::sumShares() {
  std::vector<float>& all = gradients_[0];
  for (size_t s = 1; s < gradients_.size(); ++s) {
    for (size_t i = 0; i < all.size(); ++i) all[i] += std::exchange(gradients_[s][i], 0.0f);
  }
  return all;
}

void Learner::step(float learningRate) {
  const AdamStep adam = AdamStep::at(++steps_, learningRate);
  std::vector<float>&all = gradients_[0], &parameters = net_.parameters();
  for (size_t i = 0; i < all.size(); ++i)
    adam.update(std::exchange(all[i], 0.0f), parameters[i], momentum_[i], squares_[i]);
}

void Learner::step(const LearnerSettings& settings, float scale) {
  std::vector<float>& all = sumShares();
  const Network<float>& net = net_;
  for (size_t i = 0; i < all.size(); ++i)
    all[i] = all[i] * scale + settings.weightDecay * net.parameters()[i];
  clipGradNorm<float>(all, settings.maxGradNorm);
  step(settings.learningRate);
}

}  // namespace obby::nn
