// A network in training. A fixed number of shares gather the gradient and are added in order, so
// the result does not depend on the number of threads. Host only.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "base/thread_pool.h"
#include "nn/adam.h"
#include "nn/network.h"

namespace obby::nn {

struct LearnerSettings {
  float learningRate = 1e-3f;
  float maxGradNorm = 1e30f;  // longer gradients are scaled down to this norm
  float weightDecay = 0;      // factor of the parameters in the gradient (L2)
};

// State from which training resumes.
struct LearnerState {
  std::vector<float> parameters, momentum, squares;  // Adam's means of the gradient and its square
  uint64_t steps = 0;                                // steps of Adam
};

// Scales a gradient down to the norm `max` if it is longer. Returns its norm before that. Squares
// are added in the type `Sum`.
template <class Sum>
float clipGradNorm(std::span<float> gradient, float max) {
  Sum squares[kColumns] = {};  // several sums, for vectorisation
  for (size_t i = 0; i < gradient.size(); i += kColumns) {
    for (size_t k = 0; k < kColumns; ++k) squares[k] += Sum(gradient[i + k]) * Sum(gradient[i + k]);
  }
  Sum sum = 0;
  for (const Sum s : squares) sum += s;
  const float norm = sqrtf32(float(sum));
  if (norm > max) {
    const float scale = max / norm;
    for (float& g : gradient) g *= scale;
  }
  return norm;
}

class Learner {
 public:
  Learner(Network<float> net, size_t shares);

  Network<float>& net() { return net_; }
  const Network<float>& net() const { return net_; }

  LearnerState state() const { return {net_.parameters(), momentum_, squares_, steps_}; }
  void restore(const LearnerState& state);
  uint64_t steps() const { return steps_; }

  // Returns the gradient to which share `s` of the rows is added. Zero after each step.
  std::vector<float>& gradient(size_t s) { return gradients_[s]; }
  // Adds all shares into the first and returns it.
  std::vector<float>& sumShares();
  // Takes one step of Adam by the gradient in the first share.
  void step(float learningRate);
  // Takes one step of Adam by `scale` times the sum of the shares, with weight decay and clipping.
  void step(const LearnerSettings& settings, float scale);

 private:
  Network<float> net_;
  std::vector<std::vector<float>> gradients_;
  std::vector<float> momentum_, squares_;
  uint64_t steps_ = 0;
};

// Splits [0, count) into `shares` ranges and calls task(share, first, count) for each on the pool's
// threads. Some ranges may be empty.
template <class Task>
void forShares(ThreadPool& pool, size_t shares, size_t count, Task&& task) {
  const size_t each = (count + shares - 1) / shares;
  const auto share = [&](int s) {
    const size_t first = std::min(size_t(s) * each, count);
    task(size_t(s), first, std::min(each, count - first));
  };
  pool.run(int(shares), std::ref(share));  // a reference saves a copy on the heap
}

}  // namespace obby::nn
