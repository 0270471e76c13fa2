// The goals of CFLGE: states in which players stood, drawn by how sparse the latent space is around
// them. Host only.
#pragma once

#include <memory>
#include <vector>

#include "solve/learned/inverse_dynamics.h"

namespace obby::solve::learned {

// A state: the i-th of a path.
struct Goal {
  std::shared_ptr<const Path> path;
  uint32_t index;
};

class GoalPool {
 public:
  static constexpr float kGeometric = 0.005f;  // of the draw by rank
  static constexpr size_t kHalf = 1024;  // states at each refreshing: so many old, so many new

  // The states of a path may become goals when the pool is refreshed.
  void add(const std::shared_ptr<const Path>& path);
  // Ranks states anew: new ones, evenly taken, and of the old those where it was sparsest. `pass`
  // is the module's.
  void refresh(ThreadPool& pool, const InverseDynamics& module, NetPass& pass);

  bool empty() const { return ranked_.empty(); }
  // The sparser it is around a state, the likelier. Safe to call from several threads.
  const Goal& draw(Random& random) const {
    return ranked_[drawGeometric(random, kGeometric, uint32_t(ranked_.size()))];
  }

 private:
  std::vector<Goal> ranked_, fresh_;  // ranked: the sparsest first
};

}  // namespace obby::solve::learned
