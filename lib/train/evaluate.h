// How well a policy plays by itself on levels that it was not trained on.
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
  uint32_t levels = 1000;  // at most
  uint32_t tries = 8;      // playthroughs of each level: the first takes the likeliest moves
  float hardest = 1;       // difficulty
  float patience = 3;      // as EnvGroupSettings::patience
  // Of wall-clock time, after which no other level begins; what is played still is given up a
  // second later.
  double seconds = 1e30;
  policy::Observe observe = policy::observe;  // as EnvGroupSettings::observe
};

struct Solved {
  uint32_t levels = 0;   // played
  double likeliest = 0;  // share of levels that the first playthrough solves
  double drawn = 0;      // share of the other playthroughs that solve; 0 where there are none
  double any = 0;        // share of levels that any of them solves
};

struct Evaluation : Solved {  // of all levels
  std::vector<Solved> kinds;  // the same of each kind, by its number up to the last that was played
  bool timeUp = false;        // it ended early for that
  // What the source said instead of a level: of the first that it did not give. Others were played.
  Status missing;
};

// How far it is.
struct EvaluationSoFar {
  uint32_t levels = 0;   // played
  double likeliest = 0;  // share of them that the first playthrough solves
  double done = 0;       // share of the levels, or of the time where that is more, 0 to 1
};

// The number of a level's kind, by which levels are told apart; 0 is one, too. Asked from whichever
// thread.
using KindOf = std::function<uint16_t(const TrainingLevel&)>;

// Ends early, with the levels played to the end so far, once `stop` is set, time is up, or the
// source has no more. Tells the source what is past, and `watch`, if given, of each level that was
// played: from whichever thread, but one at a time. Without `kindOf` all levels are of kind 0.
Evaluation evaluate(const policy::Network& network, const LevelSource& source,
                    const EvaluationSettings& settings, ThreadPool& pool,
                    const std::atomic<bool>& stop,
                    const std::function<void(const EvaluationSoFar&)>& watch = {},
                    const KindOf& kindOf = {});

}  // namespace obby::train
