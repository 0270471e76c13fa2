// Proximal policy optimisation over a batch of decisions: advantages, then a few epochs over the
// batch in minibatches. The same bits for any number of threads: a minibatch is cut into a fixed
// number of shares, whose gradients are added in order, and then those of the ranks.
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
  float discount = 0.99f;      // a decision
  float lambda = 0.95f;        // of generalised advantage estimation
  uint32_t epochs = 2;         // over a batch
  uint32_t minibatch = 4096;   // decisions a step of the optimiser, of each rank, at most
  float learningRate = 2e-3f;  // at first
  float maxGradNorm = 0.5f;
};

// Decisions of some worlds, a row each: (ticks, worlds), the worlds of one tick side by side.
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
  SeenRows seen;  // before each decision, and at last
  std::vector<Decision> decisions;
  std::vector<float> values;  // what the network expected, in rewards
  std::vector<float> rewards;
  std::vector<float> last;    // (worlds), value of the state after the last tick
  std::vector<uint8_t> done;  // the playthrough ended with this decision
};

// Means over all decisions of all epochs; gradNorm over all minibatches.
struct Progress {
  double loss = 0, entropy = 0, approxKl = 0, clipFraction = 0, valueError = 0, gradNorm = 0;

  // Adds the loss of one decision.
  void add(const nn::PpoLoss<float>& r);
  void add(const Progress& sums);
  // From the sums of this rank's decisions, and of the minibatches' norms.
  void finish(size_t decisions, uint32_t minibatches, Ranks& ranks);
};

// How the advantages of a minibatch are normalised.
inline nn::AdvantageScale advantageScaleOf(const nn::Moments& m, double count) {
  return nn::advantageScale(m, count, 1e-8);
}

class Ppo {
 public:
  // The ranks learn one network, each from batches of its own.
  Ppo(const PpoSettings& settings, uint64_t seed, ThreadPool& pool, Ranks& ranks);

  const nn::Network<float>& net() const { return learner_.net(); }
  // What the value head says, in rewards.
  float valueOf(float output) const { return values_.mean + values_.deviation * output; }

  // What restore() goes on from, under the same settings.
  LearnerState state() const { return {learner_.state(), values_}; }
  void restore(const LearnerState& state);

  // `rate`: of the learning rate that settings say. The batch's targets are filled in.
  Progress learn(Batch& batch, float rate);

 private:
  struct Share {  // of the work
    nn::Pass<float> pass;
    std::vector<float> gradient;  // of the loss by a tile's outputs
    Progress sums;
    Sums returns{1};
  };

  // nn::forShares with a share of this object.
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
  std::vector<float> void_;  // what the first layer makes of empty surroundings, of a minibatch
  std::vector<Share> shares_;
  std::vector<float> advantages_, returns_;  // (rows), in rewards
  std::vector<uint32_t> order_;              // (rows), of an epoch
};

// The order of decisions in an epoch, by what Adam has done before it.
inline Shuffle orderOf(uint64_t seed, uint64_t steps, size_t decisions) {
  return {seed ^ 0x6f72646572, steps, uint32_t(decisions)};
}

// A network that nothing was learned with yet: orthogonal columns or rows, whichever are fewer.
nn::Network<float> firstNetwork(uint64_t seed);

}  // namespace obby::train
