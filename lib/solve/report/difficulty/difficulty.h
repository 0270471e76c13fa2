// Estimates how hard a solution is to play. A player with noise (noisy_player.h) tries each of its
// segments many times, each time from the recorded state at its start.
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
  uint32_t trials = 1000;  // per segment, >= 1
  uint64_t seed = 1;
  NoiseModel noise;
  const std::atomic<bool>* stop = nullptr;  // set from outside to cancel
};

// Ordered like schema::Band.
enum class Band : uint8_t { trivial, easy, medium, hard, extreme };

// Returns the band for a share of passed trials. trivial: at least 99 in 100 pass; easy: 9 in 10;
// medium: 6 in 10; hard: 2 in 10; extreme: fewer.
Band bandOf(float success);

struct DifficultyStep {
  Segment segment;
  uint32_t passed = 0;  // number of passed trials
  float success = 0;    // share of the trials that passed
  // Press window of the tightest jump, ms. 0: the segment has no jump, or, if segment.jumps > 0, a
  // jump that fails even as recorded.
  float window = 0;
  float margin = 0;      // landingMargin(); 0: the segment does not end with a landing
  float clearance = -1;  // killClearance()
};

// Returns true if fewer trials of `a` passed. On a tie the tighter window is harder, and a segment
// with a jump is harder than one without.
bool harder(const DifficultyStep& a, const DifficultyStep& b);

struct Difficulty {
  std::vector<DifficultyStep> steps;
  uint32_t trials = 0;
  // Index of the hardest step by harder(); on a tie the first one.
  uint32_t hardest = 0;
  float success = 1;           // product over the steps
  float expectedAttempts = 1;  // 1 / success, at most 1e6; 0 passed trials count as half of one
};

constexpr float kMaxAttempts = 1e6f;

// Estimates the difficulty of a solution with at least one tick. The result does not depend on the
// number of threads. It is invalid once `options.stop` is set.
Difficulty difficultyOf(const Problem& problem, const Course& course,
                        const DifficultyOptions& options, ThreadPool& pool);

}  // namespace obby::solve
