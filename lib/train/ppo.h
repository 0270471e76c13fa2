// Proximal policy optimisation over a batch of decisions: advantages, then a few passes over the
// batch in small parts. The same bits for any number of threads: a part is cut into a fixed number
// of shares, whose gradients are added in order, and then those of the ranks.
#pragma once

#include <span>
#include <vector>

#include "base/shuffle.h"
#include "base/thread_pool.h"
#include "policy/adam.h"
#include "policy/ppo_loss.h"
#include "train/normaliser.h"
#include "train/pass.h"
#include "train/ranks.h"
#include "train/state.h"

namespace obby::train {

using policy::Decision;

struct PpoSettings {
  policy::LossSettings loss{.entropyShare = 0.005f};
  float discount = 0.99f;  // a decision
  float lambda = 0.95f;    // of generalised advantage estimation
  uint32_t passes = 2;     // over a batch
  uint32_t part = 4096;    // decisions a step of the optimiser, of each rank, at most
  float rate = 2e-3f;      // of Adam, at first
  float mostNorm = 0.5f;   // of a gradient
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

// Of all passes over a batch, means.
struct Progress {
  double loss = 0, entropy = 0, divergence = 0, clipped = 0, valueError = 0, norm = 0;

  // From the sums of this rank's decisions, and of the parts' norms.
  void finish(size_t decisions, uint32_t parts, Ranks& ranks);
};

// How the advantages of a part are normalised, by the sums of all ranks.
struct AdvantageScale {
  AdvantageScale(double sum, double squares, double rows);
  float mean, scale, count;
};

class Ppo {
 public:
  // The ranks learn one network, each from batches of its own.
  Ppo(const PpoSettings& settings, uint64_t seed, ThreadPool& pool, Ranks& ranks);

  const Weights<float>& weights() const { return weights_; }
  // What the value head says, in rewards.
  float valueOf(float output) const { return values_.mean + values_.deviation * output; }

  // What restore() goes on from, under the same settings.
  LearnerState state() const;
  void restore(const LearnerState& state);

  // `rate`: of what settings say. The batch's advantages and targets are filled in.
  Progress learn(Batch& batch, float rate);

 private:
  struct Share {  // of the work
    Pass pass;
    Rows<float> slope;
    Weights<float> gradient;
    Progress sums;
    Sums returns{1};
  };

  // Calls task(first, count, share) for runs of numbers below `count`, a share each, on the pool.
  template <class Task>
  void inShares(size_t count, Task&& task);
  void fillAdvantages(const Batch& batch);
  void rescaleValues();
  void learnPart(const Batch& batch, std::span<const uint32_t> rows, float rate, Progress& sums);
  void learnShare(const Batch& batch, std::span<const uint32_t> rows, const AdvantageScale& scale,
                  Share& share) const;
  void learnTile(const Batch& batch, std::span<const uint32_t> rows, const AdvantageScale& scale,
                 Share& share) const;
  void addRanks(Weights<float>& gradient);
  void step(Weights<float>& gradient, float rate);

  PpoSettings settings_;
  ThreadPool& pool_;
  Ranks& ranks_;
  uint64_t seed_;
  Weights<float> weights_, momentum_, squares_;
  policy::Adam adam_;
  ValueScale values_;
  WeightsBack back_;
  Line<float> void_;  // what the first layer makes of empty surroundings, of a part
  std::vector<Share> shares_;
  std::vector<float> advantages_, targets_;  // (rows), in rewards
  std::vector<uint32_t> order_;              // (rows), of a pass
};

// The order of decisions in a pass, by what Adam has done before it.
inline Shuffle orderOf(uint64_t seed, uint64_t steps, size_t decisions) {
  return {seed ^ 0x6f72646572, steps, uint32_t(decisions)};
}

// Weights that nothing was learned with yet: orthogonal columns or rows, whichever are fewer.
Weights<float> firstWeights(uint64_t seed);

}  // namespace obby::train
