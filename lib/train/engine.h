// Engines play worlds and train the network, on the CPU or on a device. The trainer controls them.
// Both run the same algorithm and differ only in rounding.
#pragma once

#include <memory>
#include <vector>

#include "sim/device.h"
#include "train/env_group.h"
#include "train/ppo.h"

namespace obby::train {

struct TrainerSettings {
  uint64_t seed = 1;
  uint32_t envGroups = 8;     // env groups per rank; tasks of the thread pool
  EnvGroupSettings envGroup;  // 8 x 32 worlds
  uint32_t ticks = 32;        // decisions of each world per iteration
  PpoSettings ppo;
  uint64_t decisions = 100'000'000;  // decisions over which the learning rate decays to a tenth
  float easiest = 0.1f;              // difficulty of the first levels
  float raiseAt = 0.7f;              // share of solved episodes above which levels become harder
  float lowerAt = 0.45f;             // share of solved episodes below which levels become easier
  std::vector<int> hidden;           // inputs that the policy does not see (ablation)

  uint32_t worlds() const { return envGroups * envGroup.size(); }  // per rank
};

constexpr uint32_t kCountEvery = 4;  // the normaliser counts the rows of every 4th tick

// Parameters of one iteration's play.
struct PlayOrder {
  uint64_t iteration = 0;                   // iterations before this one
  float hardest = 0;                        // max difficulty of levels requested now
  const std::vector<float>&means, &scales;  // normalisation of the inputs
};

// Results of one iteration's play, of this rank.
struct Played {
  double reward = 0;  // sum
  Tally tally;
  Sums seen{policy::kInputs};  // raw inputs
  // The source's error in place of a next level. Training can still learn from this iteration, but
  // cannot play another. The waiting places are in envGroups().
  Status missing;
};

class Engine {
 public:
  virtual ~Engine() = default;

  // Call begin() or restore() first. Errors: those of the source or the device, and a state that
  // does not fit the settings or levels. `envGroups`: those of this rank.
  virtual Status begin(float hardest) = 0;
  virtual Status restore(const LearnerState& learner, std::span<EnvGroupState> envGroups) = 0;

  // Call it between begin() and the first play() to start from `learner` instead of a fresh
  // network.
  virtual Status setLearner(const LearnerState& learner) = 0;

  virtual Result<Played> play(const PlayOrder& order) = 0;
  // Learns from the last play(). `rate`: factor of the settings' learning rate.
  virtual Result<Progress> learn(float rate) = 0;

  virtual Result<LearnerState> learner() const = 0;
  virtual Result<std::vector<EnvGroupState>> envGroups() const = 0;
};

// The arguments must outlive the engine.
std::unique_ptr<Engine> makeCpuEngine(const TrainerSettings& settings, const LevelSource& source,
                                      ThreadPool& pool, Ranks& ranks);

}  // namespace obby::train
