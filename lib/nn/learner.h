// A network in training: its gradient is gathered in a fixed number of shares, which are added in
// their order, so that it is the same for any number of threads. Host only.
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
  float maxGradNorm = 1e30f;  // of a gradient: longer ones are scaled down to it
  float weightDecay = 0;      // times the parameters themselves (L2)
};

// What training goes on from.
struct LearnerState {
  std::vector<float> parameters, momentum, squares;  // the last two: Adam's means of gradients
  uint64_t steps = 0;                                // of Adam
};

// Scales a gradient down to `max` where it is longer; returns how long it was. `Sum`: the type that
// squares are added in.
template <class Sum>
float clipGradNorm(std::span<float> gradient, float max) {
  Sum squares[kColumns] = {};  // several sums, so that lanes can take them
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

  // What share `s` of the rows adds its gradient to; zero after each step.
  std::vector<float>& gradient(size_t s) { return gradients_[s]; }
  // The sum of the shares, in the first of them.
  std::vector<float>& sumShares();
  // One step of Adam against the gradient in the first share.
  void step(float learningRate);
  // Both, with `scale` times the sum.
  void step(const LearnerSettings& settings, float scale);

 private:
  Network<float> net_;
  std::vector<std::vector<float>> gradients_;
  std::vector<float> momentum_, squares_;
  uint64_t steps_ = 0;
};

// Calls task(share, first, count) for `shares` runs of numbers below `count` on the pool's threads;
// some may be empty.
template <class Task>
void forShares(ThreadPool& pool, size_t shares, size_t count, Task&& task) {
  const size_t each = (count + shares - 1) / shares;
  const auto share = [&](int s) {
    const size_t first = std::min(size_t(s) * each, count);
    task(size_t(s), first, std::min(each, count - first));
  };
  pool.run(int(shares), std::ref(share));  // by itself it would be copied to the heap
}

}  // namespace obby::nn
