// How hard a solution is to play: each of its segments is tried many times by a player with noise
// (noisy_player.h), each time from where the recorded one begins it.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "base/thread_pool.h"
#include "schema/obby.capnp.h"
#include "solve/model/route.h"
#include "solve/report/difficulty/noise.h"

namespace obby::solve {

struct DifficultyOptions {
  uint32_t trials = 1000;  // a segment, >= 1
  uint64_t seed = 1;
  NoiseModel noise;
  const std::atomic<bool>* stop = nullptr;  // set from outside: give it up
};

// In the order of the schema.
enum class Band : uint8_t { trivial, easy, medium, hard, extreme };

// Of a share of trials. trivial: at least 99 in 100 pass; easy: 9 in 10; medium: 6 in 10; hard: 2
// in 10; extreme: fewer.
Band bandOf(float success);

struct DifficultyStep {
  Segment segment;
  uint32_t passed = 0;  // of the trials
  float success = 0;    // share of the trials
  // ms in which its tightest jump must be pressed; 0: no jump, or, where segment.jumps says that
  // there are some, one that fails even as recorded.
  float window = 0;
  float margin = 0;      // landingMargin(); 0: does not land on a part out of the air
  float clearance = -1;  // killClearance()
};

// Fewer trials passed it; of as many, its tightest jump leaves less time (a way without jumps all
// of it).
bool harder(const DifficultyStep& a, const DifficultyStep& b);

struct Difficulty {
  std::vector<DifficultyStep> steps;
  uint32_t trials = 0;
  // The fewest trials passed it; of several the one with the tightest window, then the first.
  uint32_t hardest = 0;
  float success = 1;           // product over the steps
  float expectedAttempts = 1;  // 1 / success, at most 1e6; a step that no trial passed counts half
                               // a trial
};

constexpr float kMostAttempts = 1e6f;

// Of a solution with at least one tick. The same for any number of threads; of no use once
// `options.stop` is set.
Difficulty difficultyOf(const Problem& problem, const Course& course,
                        const DifficultyOptions& options, ThreadPool& pool);

}  // namespace obby::solve
