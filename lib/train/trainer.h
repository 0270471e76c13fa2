// The training loop. In each iteration all worlds play under the current policy, then the policy
// learns from it. The result follows from settings and levels, not from the number of threads.
#pragma once

#include <memory>
#include <vector>

#include "policy/policy.h"
#include "train/engine.h"
#include "train/start.h"

namespace obby::train {

// Statistics of one iteration.
struct Iteration {
  uint64_t number = 0, decisions = 0;  // counts so far
  double seconds = 0, playSeconds = 0;
  double reward = 0;    // mean reward per decision
  double solved = 0;    // share of episodes from the start, smoothed
  uint64_t played = 0;  // episodes from the start
  float hardest = 0;    // max difficulty of levels
  Progress progress;
};

class Trainer {
 public:
  // The arguments must outlive the trainer. Each rank makes a trainer with the same settings and
  // source, and calls the same functions. An error on one rank is an error on all.
  static Result<std::unique_ptr<Trainer>> make(const TrainerSettings& settings,
                                               const LevelSource& source, ThreadPool& pool,
                                               Ranks& ranks);
  // Uses an engine other than the CPU's. Starts from `start`, if given, instead of a fresh network.
  static Result<std::unique_ptr<Trainer>> make(const TrainerSettings& settings,
                                               std::unique_ptr<Engine> engine, Ranks& ranks,
                                               const Start* start = nullptr);

  // Resumes from a state of trainers with the same settings, source and number of ranks. Further
  // errors: a state that does not fit them.
  static Result<std::unique_ptr<Trainer>> resume(const TrainerSettings& settings,
                                                 const LevelSource& source, ThreadPool& pool,
                                                 Ranks& ranks, TrainerState state);
  static Result<std::unique_ptr<Trainer>> resume(const TrainerSettings& settings,
                                                 std::unique_ptr<Engine> engine, Ranks& ranks,
                                                 TrainerState state);

  // Throws std::runtime_error if this rank could not learn and others wait for it. Further errors:
  // training diverged; then state() cannot be resumed.
  Result<Iteration> iterate();
  // Returns success if another iteration can follow, else the source's error. The trained network
  // stays valid, and state() can be resumed.
  const Status& more() const { return more_; }

  // Returns the state from which resume() continues with the same bits. Call it between iterations.
  // On the first rank the state has the env groups of all ranks. Errors: the engine's.
  Result<TrainerState> state() const;
  // Counts so far.
  uint64_t iterations() const { return iterations_; }
  uint64_t decisions() const { return decisions_; }

  // Returns the current policy for use elsewhere.
  policy::Network network() const;

 private:
  Trainer(const TrainerSettings& settings, std::unique_ptr<Engine> engine, Ranks& ranks);

  void gather(const Played& played, Iteration& out);
  void adapt(double solvedNow, uint64_t played);
  void refreshNormaliser();
  void hide();
  Status restore(TrainerState state);
  Status takeParameters();
  Result<Progress> learned(Result<Progress> mine) const;
  Status sameNetwork() const;
  Status stillFinite() const;

  TrainerSettings settings_;
  Ranks& ranks_;
  std::unique_ptr<Engine> engine_;
  std::vector<float> parameters_;  // the engine's parameters
  bool finite_ = true;             // true while all trained numbers are finite
  Sums seen_{policy::kInputs};
  std::vector<float> means_, scales_;
  uint64_t iterations_ = 0, decisions_ = 0;
  double solved_ = 0;
  float hardest_;
  Status more_;
};

}  // namespace obby::train
