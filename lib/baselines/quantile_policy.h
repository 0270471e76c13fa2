// The goal-conditioned policy of CFLGE: QR-DQN (Dabney et al. 2018) with hindsight goals
// (Andrychowicz et al. 2017). Each decision costs 1 until the goal is reached. Host only.
#pragma once

#include <span>

#include "baselines/inverse_dynamics.h"
#include "baselines/names.h"
#include "policy/moves.h"

namespace obby::baselines {

constexpr size_t kQuantiles = 8;
constexpr size_t kGoalInputs = 16;  // position of the goal relative to the player
constexpr size_t kPolicyInputs = size_t(policy::kInputs) + kGoalInputs;

// Fills `out`, (kGoalInputs), with the offset of `goal` from `place`, both (kPlace).
void observeGoal(const float* place, const float* goal, float* out);

// Returns the allowed move with the best mean of quantiles, the first one on ties. `quantiles`:
// (kMoves, kQuantiles).
int bestMove(const float* quantiles, bool mayJump);

struct QuantileSettings {
  nn::LearnerSettings learner{.learningRate = 1e-3f, .maxGradNorm = 10};
  float discount = 0.95f;
  float hindsight = 0.8f;  // share of decisions with a goal that was reached later
  uint32_t refresh = 200;  // steps between updates of the target network
};

class QuantilePolicy {
 public:
  static constexpr size_t kBatch = 64;  // decisions per step

  // `device`: as for NetPass.
  QuantilePolicy(const QuantileSettings& settings, uint64_t seed, DeviceWork* device = nullptr);

  // Returns the network from (kPolicyInputs) to (kMoves, kQuantiles).
  const nn::Network<float>& net() const { return learner_.net(); }

  // Takes one step on decisions sampled from the memory.
  void learn(ThreadPool& pool, const Memory& memory, const InverseDynamics& module);

 private:
  struct Lesson {
    const Track* track;
    size_t decision;
    const float* goal;  // (kPlace)
  };
  struct Share {
    NetPass pass, next, encoder;
    std::vector<float> inputs, nextInputs, places, points, gradient;
  };
  void draw(const Memory& memory, std::span<Lesson> lessons);
  void learnShare(const InverseDynamics& module, std::span<const Lesson> lessons, size_t s);

  QuantileSettings settings_;
  Random random_;
  nn::Learner learner_;
  nn::Network<float> target_;
  uint32_t steps_ = 0;
  Share shares_[kShares];
};

}  // namespace obby::baselines
