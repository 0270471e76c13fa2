// Where worlds play and the network learns from it: on the CPU, or on a device that runs kernels.
// The trainer says when; both mean the same, and round otherwise.
#pragma once

#include <memory>
#include <vector>

#include "sim/device.h"
#include "train/env_group.h"
#include "train/ppo.h"

namespace obby::train {

struct TrainerSettings {
  uint64_t seed = 1;
  uint32_t envGroups = 8;     // of each rank; tasks of the pool
  EnvGroupSettings envGroup;  // 8 x 32 worlds
  uint32_t ticks = 32;        // decisions of each world an iteration
  PpoSettings ppo;
  uint64_t decisions = 100'000'000;  // after so many the rate is down to a tenth
  float easiest = 0.1f;              // difficulty that levels begin with
  float raiseAt = 0.7f;     // share of playthroughs solved above which levels become harder
  float lowerAt = 0.45f;    // below which easier
  std::vector<int> hidden;  // inputs that the policy does not see, to learn their worth

  uint32_t worlds() const { return envGroups * envGroup.size(); }  // of each rank
};

constexpr uint32_t kCountEvery = 4;  // ticks between those whose rows the normaliser counts

// How an iteration is played.
struct PlayOrder {
  uint64_t iteration = 0;                   // so many before
  float hardest = 0;                        // difficulty of levels that are asked for now
  const std::vector<float>&means, &scales;  // of inputs
};

// What came of it, in this rank.
struct Played {
  double reward = 0;  // sum
  Tally tally;
  Sums seen{policy::kInputs};  // raw inputs
  // What the source said instead of a level that comes next: this can be learned from, but nothing
  // more be played. The places wait in envGroups().
  Status missing;
};

class Engine {
 public:
  virtual ~Engine() = default;

  // One of these comes first. Errors: the source's, the device's; a state that fits neither
  // settings nor levels. `envGroups`: of this rank.
  virtual Status begin(float hardest) = 0;
  virtual Status restore(const LearnerState& learner, std::span<EnvGroupState> envGroups) = 0;

  // Between begin() and the first play(): to learn on from it, instead of from a fresh network.
  virtual Status setLearner(const LearnerState& learner) = 0;

  virtual Result<Played> play(const PlayOrder& order) = 0;
  // From what was played last. `rate`: of what settings say.
  virtual Result<Progress> learn(float rate) = 0;

  virtual Result<LearnerState> learner() const = 0;
  virtual Result<std::vector<EnvGroupState>> envGroups() const = 0;
};

// What it refers to must outlive it.
std::unique_ptr<Engine> makeCpuEngine(const TrainerSettings& settings, const LevelSource& source,
                                      ThreadPool& pool, Ranks& ranks);

}  // namespace obby::train
