// Learning, an iteration at a time: all worlds play for a while under the policy as it is, then the
// policy learns from what came of it. Everything follows from the settings and the levels: the
// number of threads does not show.
#pragma once

#include <memory>
#include <vector>

#include "policy/policy.h"
#include "train/engine.h"
#include "train/start.h"

namespace obby::train {

// Of one iteration.
struct Iteration {
  uint64_t number = 0, decisions = 0;  // so far
  double seconds = 0, playSeconds = 0;
  double reward = 0;    // a decision
  double solved = 0;    // share of playthroughs from the start, smoothed
  uint64_t played = 0;  // such playthroughs
  float hardest = 0;    // difficulty of levels, at most
  Progress progress;
};

class Trainer {
 public:
  // What it refers to must outlive it. Ranks learn together: each makes a trainer, of the same
  // settings and source, and calls the same functions; an error of one is an error of all.
  static Result<std::unique_ptr<Trainer>> make(const TrainerSettings& settings,
                                               const LevelSource& source, ThreadPool& pool,
                                               Ranks& ranks);
  // The same with another engine than the CPU; with `start` instead of a fresh network, if given.
  static Result<std::unique_ptr<Trainer>> make(const TrainerSettings& settings,
                                               std::unique_ptr<Engine> engine, Ranks& ranks,
                                               const Start* start = nullptr);

  // Goes on from a state of trainers with the same settings, source and number of ranks. Errors
  // also: the state does not fit them.
  static Result<std::unique_ptr<Trainer>> resume(const TrainerSettings& settings,
                                                 const LevelSource& source, ThreadPool& pool,
                                                 Ranks& ranks, TrainerState state);
  static Result<std::unique_ptr<Trainer>> resume(const TrainerSettings& settings,
                                                 std::unique_ptr<Engine> engine, Ranks& ranks,
                                                 TrainerState state);

  // Throws std::runtime_error on a rank of several that could not learn: the others wait for it.
  // Error also: learning diverged. Then state() is none that could be gone on from.
  Result<Iteration> iterate();
  // Is there another? Error: what a source said that gave no more levels. What was learned stays,
  // and state() can be gone on from.
  const Status& more() const { return more_; }

  // Between two iterations; resume() goes on from it with the same bits. All env groups are in that
  // of the first rank. Error: the engine's.
  Result<TrainerState> state() const;
  // So far.
  uint64_t iterations() const { return iterations_; }
  uint64_t decisions() const { return decisions_; }

  // The policy as it is now, to be used elsewhere.
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
  std::vector<float> parameters_;  // the engine's network, as it is now
  bool finite_ = true;             // all that the engine learned
  Sums seen_{policy::kInputs};
  std::vector<float> means_, scales_;
  uint64_t iterations_ = 0, decisions_ = 0;
  double solved_ = 0;
  float hardest_;
  Status more_;
};

}  // namespace obby::train
