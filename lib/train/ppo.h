// Proximal policy optimisation over a batch of decisions: advantages, then a few epochs of
// minibatches. A minibatch is cut into a fixed number of shares. Their gradients are added in
// order, then those of the ranks, so the number of threads does not change any bit.
#pragma once

#include <span>
#include <vector>

#include "base/shuffle.h"
#include "nn/advantages.h"
#include "nn/pass.h"
#include "policy/decision.h"
#include "train/ranks.h"
#include "train/seen_rows.h"
#include "train/state.h"

namespace obby::train {

using policy::Decision;

struct PpoSettings {
  nn::PpoLossSettings loss{.entropyWeight = 0.005f};
  float discount = 0.99f;      // per decision
  float lambda = 0.95f;        // generalised advantage estimation
  uint32_t epochs = 2;         // per batch
  uint32_t minibatch = 4096;   // max decisions of an optimiser step, per rank
  float learningRate = 2e-3f;  // initial
  float maxGradNorm = 0.5f;
};

// Decisions of some worlds, one row each. Rows are ordered as (ticks, worlds).
struct Batch {
  Batch(uint32_t tickCount, uint32_t worldCount)
      : ticks(tickCount),
        worlds(worldCount),
        seen((size_t(ticks) + 1) * worlds),
        decisions(size_t(ticks) * worlds),
        values(size_t(ticks) * worlds),
        rewards(size_t(ticks) * worlds),
        last(worlds),
        done(size_t(ticks) * worlds) {}

  uint32_t ticks, worlds;
  SeenRows seen;  // rows before each decision, and after the last
  std::vector<Decision> decisions;
  std::vector<float> values;  // the network's estimates, in rewards
  std::vector<float> rewards;
  std::vector<float> last;    // (worlds), value of the state after the last tick
  std::vector<uint8_t> done;  // true if the episode ended with this decision
};

// Means over all decisions of all epochs; gradNorm is a mean over all minibatches.
struct Progress {
  double loss = 0, entropy = 0, approxKl = 0, clipFraction = 0, valueError = 0, gradNorm = 0;

  // Adds the loss of one decision.
  void add(const nn::PpoLoss<float>& r);
  void add(const Progress& sums);
  // Turns sums of this rank's decisions, and of the minibatches' norms, into means of all ranks.
  void finish(size_t decisions, uint32_t minibatches, Ranks& ranks);
};

// Returns the normalisation of a minibatch's advantages.
inline nn::AdvantageScale advantageScaleOf(const nn::Moments& m, double count) {
  return nn::advantageScale(m, count, 1e-8);
}

class Ppo {
 public:
  // The ranks train one network, each on its own batches.
  Ppo(const PpoSettings& settings, uint64_t seed, ThreadPool& pool, Ranks& ranks);

  const nn::Network<float>& net() const { return learner_.net(); }
  // Returns a value of the value head in rewards.
  float valueOf(float output) const { return values_.mean + values_.deviation * output; }

  // Returns the state from which restore() resumes, under the same settings.
  LearnerState state() const { return {learner_.state(), values_}; }
  void restore(const LearnerState& state);

  // Learns from the batch. `rate`: factor of the settings' learning rate.
  Progress learn(Batch& batch, float rate);

 private:
  struct Share {  // a part of the work
    nn::Pass<float> pass;
    std::vector<float> gradient;  // gradient of the loss with respect to a tile's outputs
    Progress sums;
    Sums returns{1};
  };

  // Runs nn::forShares with the shares of this object.
  template <class Task>
  void inShares(size_t count, Task&& task);
  void fillAdvantages(const Batch& batch);
  void rescaleValues();
  void learnMinibatch(const Batch& batch, std::span<const uint32_t> rows, float rate,
                      Progress& sums);
  void learnTile(const Batch& batch, std::span<const uint32_t> rows,
                 const nn::AdvantageScale& scale, Share& share, std::vector<float>& gradient);

  PpoSettings settings_;
  ThreadPool& pool_;
  Ranks& ranks_;
  uint64_t seed_;
  nn::Learner learner_;
  ValueScale values_;
  std::vector<float> void_;  // first-layer sums of empty surroundings, per minibatch
  std::vector<Share> shares_;
  std::vector<float> advantages_, returns_;  // (rows), in rewards
  std::vector<uint32_t> order_;              // (rows), order of an epoch
};

// Returns the order of decisions in an epoch. `steps`: Adam's steps before it.
inline Shuffle orderOf(uint64_t seed, uint64_t steps, size_t decisions) {
  return {seed ^ 0x6f72646572, steps, uint32_t(decisions)};
}

// Returns an untrained network with orthogonal initialisation.
nn::Network<float> firstNetwork(uint64_t seed);

}  // namespace obby::train
