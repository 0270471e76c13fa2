// The goals of CFLGE: states in which players stood, sampled by sparsity of the latent space around
// them. Host only.
#pragma once

#include <memory>
#include <vector>

#include "baselines/inverse_dynamics.h"
#include "baselines/names.h"

namespace obby::baselines {

// A state: the place at an index of a path.
struct Goal {
  std::shared_ptr<const Path> path;
  uint32_t index;
};

class GoalPool {
 public:
  static constexpr float kGeometric = 0.005f;  // parameter of the draw by rank
  static constexpr size_t kHalf = 1024;        // max old and max new states per refresh

  // Makes the states of a trajectory candidates for the next refresh.
  void add(const std::shared_ptr<const Path>& path);
  // Ranks states again: evenly sampled new ones and the sparsest old ones. `pass` is for the
  // module.
  void refresh(ThreadPool& pool, const InverseDynamics& module, NetPass& pass);

  bool empty() const { return ranked_.empty(); }
  // Samples a state; sparser ones are likelier. Safe to call from several threads.
  const Goal& draw(Random& random) const {
    return ranked_[drawGeometric(random, kGeometric, uint32_t(ranked_.size()))];
  }

 private:
  std::vector<Goal> ranked_, fresh_;  // ranked: the sparsest first
};

}  // namespace obby::baselines
