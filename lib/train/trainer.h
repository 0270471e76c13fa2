// Learning, an iteration at a time: all worlds play for a while under the policy as it is, then the
// policy learns from what came of it. Everything follows from the settings and the levels: the
// number of threads does not show.
#pragma once

#include <memory>
#include <vector>

#include "policy/policy.h"
#include "train/crowd.h"
#include "train/ppo.h"

namespace obby::train {

struct TrainerSettings {
  uint64_t seed = 1;
  uint32_t crowds = 8;  // of each rank; tasks of the pool
  CrowdSettings crowd;  // 8 x 32 worlds
  uint32_t ticks = 32;  // decisions of each world an iteration
  PpoSettings ppo;
  uint64_t decisions = 50'000'000;  // after so many the rate is down to a tenth
  float easiest = 0.1f;             // difficulty that levels begin with
  float raiseAt = 0.7f;             // share of playthroughs solved above which levels become harder
  float lowerAt = 0.45f;            // below which easier
  std::vector<int> hidden;          // inputs that the policy does not see, to learn their worth
};

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

  // Goes on from a state of trainers with the same settings, source and number of ranks. Errors
  // also: the state does not fit them.
  static Result<std::unique_ptr<Trainer>> resume(const TrainerSettings& settings,
                                                 const LevelSource& source, ThreadPool& pool,
                                                 Ranks& ranks, TrainerState state);

  Result<Iteration> iterate();

  // Between two iterations; resume() goes on from it with the same bits. All crowds are in that of
  // the first rank.
  TrainerState state() const;
  // So far.
  uint64_t iterations() const { return iterations_; }
  uint64_t decisions() const { return decisions_; }

  // The policy as it is now, to be used elsewhere.
  policy::Network network() const;

 private:
  Trainer(const TrainerSettings& settings, const LevelSource& source, ThreadPool& pool,
          Ranks& ranks);

  struct Group {  // a crowd with its part of the batch
    Group(const LevelSource& source, const TrainerSettings& s, uint32_t number, const Ranks& ranks);
    Crowd crowd;
    Random random;
    uint32_t first, worlds;  // of the batch's worlds: its own
    Pass<float> pass, cutPass;
    Sums seen{policy::kInputs};
    std::vector<uint8_t> mayJump;
    std::vector<int> moves;
    std::vector<Step> steps;
    Rows<float> row;  // of a tick, normalised
    Status status;
  };

  void play(Group& group);
  void decide(Group& group, uint32_t tick);
  Status take(Group& group, uint32_t tick);
  size_t rowOf(const Group& group, uint32_t tick) const;  // of its first world
  float valueOf(const Rows<float>& outputs, size_t row) const;
  void normalise(float* row) const;
  void gather(Iteration& out);
  void adapt(double solvedNow, uint64_t played);
  void refreshNormaliser();
  void hide();
  void dropPastLevels();
  Status restore(TrainerState state);
  Status begin();
  Status sameNetwork() const;

  TrainerSettings settings_;
  const LevelSource& source_;
  ThreadPool& pool_;
  Ranks& ranks_;
  Ppo ppo_;
  std::vector<std::unique_ptr<Group>> groups_;
  Batch batch_;
  Sums seen_{policy::kInputs};
  std::vector<float> means_, scales_;
  uint64_t iterations_ = 0, decisions_ = 0;
  double solved_ = 0;
  float hardest_;
};

}  // namespace obby::train
