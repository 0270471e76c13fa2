// How well a policy plays by itself on levels that it was not trained on.
#pragma once

#include <atomic>

#include "base/thread_pool.h"
#include "policy/policy.h"
#include "train/training_level.h"

namespace obby::train {

struct EvaluationSettings {
  uint64_t seed = 1;
  uint64_t firstLevel = 0;
  uint32_t levels = 1000;  // at most
  uint32_t tries = 8;      // playthroughs of each level: the first takes the likeliest moves
  float hardest = 1;       // difficulty
  float patience = 3;      // as CrowdSettings::patience
};

struct Evaluation {
  uint32_t levels = 0;
  double likeliest = 0;  // share of levels that the first playthrough solves
  double drawn = 0;      // share of the other playthroughs that solve
  double any = 0;        // share of levels that any of them solves
};

// Ends early, with the levels so far, once `stop` is set or the source has no more. The error is
// the source's.
Result<Evaluation> evaluate(const policy::Network& network, const LevelSource& source,
                            const EvaluationSettings& settings, ThreadPool& pool,
                            const std::atomic<bool>& stop);

}  // namespace obby::train
