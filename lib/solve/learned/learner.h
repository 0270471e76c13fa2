// A network in training: its gradient is gathered in a fixed number of shares, which are added in
// their order, so that it is the same for any number of threads. Host only.
#pragma once

#include <vector>

#include "base/thread_pool.h"
#include "policy/adam.h"
#include "solve/learned/net.h"

namespace obby::solve::learned {

constexpr size_t kShares = 4;

struct LearnerSettings {
  float rate = 1e-3f;      // of Adam
  float mostNorm = 1e30f;  // of a gradient: longer ones are shortened
  float decay = 0;         // weights are pulled to zero by this times themselves (L2)
};

class Learner {
 public:
  Learner(std::vector<size_t> sizes, const LearnerSettings& settings)
      : settings_(settings),
        net_(std::move(sizes)),
        momentum_(net_.numbers().size()),
        squares_(net_.numbers().size()) {
    for (auto& g : gradients_) g.assign(net_.numbers().size(), 0.0f);
  }

  Net<float>& net() { return net_; }
  const Net<float>& net() const { return net_; }

  // What share `s` of the rows is to add its gradient to; zero after each step.
  std::vector<float>& gradient(size_t s) { return gradients_[s]; }

  // Moves the weights against `scale` times the sum of the shares. Gives the sum's length, scaled.
  float step(float scale);

 private:
  LearnerSettings settings_;
  Net<float> net_;
  std::vector<float> gradients_[kShares], momentum_, squares_;
  policy::Adam adam_;
};

// Calls share(s, first, count) for the kShares shares of `rows` on the pool's threads; shares may
// be empty.
template <class Share>
void forShares(ThreadPool& pool, size_t rows, Share&& share) {
  const size_t each = (rows + kShares - 1) / kShares;
  pool.run(int(kShares), [&](int s) {
    const size_t first = std::min(size_t(s) * each, rows);
    share(size_t(s), first, std::min(each, rows - first));
  });
}

}  // namespace obby::solve::learned
