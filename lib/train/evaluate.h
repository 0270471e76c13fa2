// Evaluates a policy by itself on levels that it was not trained on.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/thread_pool.h"
#include "policy/policy.h"
#include "train/training_level.h"

namespace obby::train {

struct EvaluationSettings {
  uint64_t seed = 1;
  uint64_t firstLevel = 0;
  uint32_t levels = 1000;  // max number of levels
  uint32_t tries = 8;      // episodes of each level; the first is greedy
  float hardest = 1;       // max difficulty of the levels, 0 to 1
  float patience = 3;      // as EnvGroupSettings::patience
  // Wall-clock time after which no level begins. Running episodes are given up a second later.
  double seconds = 1e30;
  policy::Observe observe = policy::observe;  // as EnvGroupSettings::observe
};

struct Solved {
  uint32_t levels = 0;   // played
  double likeliest = 0;  // share of levels that the greedy episode solves
  double drawn = 0;      // share of sampled episodes that solve their level; 0 if none are sampled
  double any = 0;        // share of levels that at least one episode solves
};

struct Evaluation : Solved {  // totals of all levels
  std::vector<Solved> kinds;  // totals per kind, up to the last that was played
  bool timeUp = false;        // time ran out
  // The error of the first level that the source did not return. Others were played.
  Status missing;
};

// Progress of an evaluation.
struct EvaluationSoFar {
  uint32_t levels = 0;   // played
  double likeliest = 0;  // share of the played levels that the greedy episode solves
  double done = 0;       // share of the levels or of the time, whichever is larger; 0 to 1
};

// Returns the kind of a level, from 0. Called from any thread.
using KindOf = std::function<uint16_t(const TrainingLevel&)>;

// Evaluates the levels in parallel. Ends early, with the levels completed so far, once `stop` is
// set, time is up, or the source has no more levels. Tells the source which levels are past. Calls
// `watch`, if given, for each level that was played, from any thread, one call at a time. Without
// `kindOf` all levels are of kind 0.
Evaluation evaluate(const policy::Network& network, const LevelSource& source,
                    const EvaluationSettings& settings, ThreadPool& pool,
                    const std::atomic<bool>& stop,
                    const std::function<void(const EvaluationSoFar&)>& watch = {},
                    const KindOf& kindOf = {});

}  // namespace obby::train
