// The goal-conditioned policy of PBGE: a network trained during the search by PPO on its own
// decisions and by imitation of kept trajectories. Host only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "baselines/names.h"
#include "baselines/net_pass.h"
#include "nn/advantages.h"
#include "nn/learner.h"
#include "policy/decision.h"

namespace obby::baselines {

struct GoalPolicySettings {
  nn::PpoLossSettings loss{.entropyWeight = 0.003f};
  nn::LearnerSettings learner{.learningRate = 1e-3f, .maxGradNorm = 0.5f};
  float imitation = 0.1f;        // weight of the imitation loss
  float imitationValue = 0.01f;  // weight of the value error in it
  float discount = 0.99f;        // per decision
  float lambda = 0.95f;          // generalised advantage estimation
  uint32_t epochs = 2;           // per round
  uint32_t minibatch = 256;      // decisions per optimiser step
};

// The source of a decision. Decisions of explorers are not learned.
enum class Maker : uint8_t { explorer, policy, kept };

// The decisions of a round, one row each. Rows are ordered as (ticks, players).
struct Decisions {
  Decisions(uint32_t tickCount, uint32_t playerCount)
      : ticks(tickCount),
        players(playerCount),
        inputs(rows() * policy::kInputs),
        made(rows()),
        makers(rows()),
        sharpness(rows(), 1.0f),
        values(rows()),
        rewards(rows()),
        done(rows()),
        last(players) {}
  size_t rows() const { return size_t(ticks) * players; }

  uint32_t ticks, players;
  std::vector<float> inputs;  // (rows, kInputs), from policy::observe
  std::vector<policy::Decision> made;
  std::vector<Maker> makers;
  std::vector<float> sharpness;  // factor of the logits
  std::vector<float> values;     // the network's estimates
  std::vector<float> rewards;
  std::vector<uint8_t> done;  // true if later rewards do not count
  std::vector<float> last;    // (players), value of the state after the last tick
};

class GoalPolicy {
 public:
  // `device`: as for NetPass.
  GoalPolicy(const GoalPolicySettings& settings, uint64_t seed, DeviceWork* device = nullptr);

  // Returns the network from (kInputs) to (kPaddedOutputs), logits and value.
  const nn::Network<float>& net() const { return learner_.net(); }

  void learn(ThreadPool& pool, const Decisions& d);

 private:
  struct Share {
    NetPass pass;
    std::vector<float> inputs, gradient;
  };

  void learnMinibatch(ThreadPool& pool, const Decisions& d, std::span<const uint32_t> rows);
  void learnShare(const Decisions& d, std::span<const uint32_t> rows,
                  const nn::AdvantageScale& scale, size_t s);

  GoalPolicySettings settings_;
  Random random_;
  nn::Learner learner_;
  Share shares_[kShares];
  std::vector<float> advantages_, targets_, returns_;  // (rows)
  std::vector<float> unused_;
};

}  // namespace obby::baselines
