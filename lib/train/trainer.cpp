#include "train/trainer.h"

#include <algorithm>
#include <stdexcept>

#include "base/stopwatch.h"
#include "policy/policy.h"
#include "train/state_codec.h"

namespace obby::train {

namespace {

constexpr double kSlow = 0.05;       // weight of an iteration's share of solved episodes
constexpr float kHarder = 0.01f;     // step of the difficulty
constexpr float kEnoughPlayed = 64;  // episodes for full weight

}  // namespace

Trainer::Trainer(const TrainerSettings& settings, std::unique_ptr<Engine> engine, Ranks& ranks)
    : settings_(settings),
      ranks_(ranks),
      engine_(std::move(engine)),
      means_(policy::kInputs, 0.0f),
      scales_(policy::kInputs, 1.0f),
      hardest_(settings.easiest) {
  hide();
}

Result<std::unique_ptr<Trainer>> Trainer::make(const TrainerSettings& settings,
                                               const LevelSource& source, ThreadPool& pool,
                                               Ranks& ranks) {
  return make(settings, makeCpuEngine(settings, source, pool, ranks), ranks);
}

Result<std::unique_ptr<Trainer>> Trainer::make(const TrainerSettings& settings,
                                               std::unique_ptr<Engine> engine, Ranks& ranks,
                                               const Start* start) {
  std::unique_ptr<Trainer> trainer(new Trainer(settings, std::move(engine), ranks));
  OBBY_RETURN_IF_ERROR(ranks.agree(trainer->engine_->begin(settings.easiest)));
  if (start != nullptr) {
    OBBY_RETURN_IF_ERROR(ranks.agree(trainer->engine_->setLearner(start->learner)));
    trainer->seen_ = start->seen;
    trainer->refreshNormaliser();
  }
  OBBY_RETURN_IF_ERROR(ranks.agree(trainer->takeParameters()));
  return trainer;
}

Status Trainer::takeParameters() {
  OBBY_ASSIGN(LearnerState learner, engine_->learner());
  finite_ = isFinite(learner);
  parameters_ = std::move(learner.parameters);
  return {};
}

void Trainer::gather(const Played& played, Iteration& out) {
  Sums seen = played.seen;
  seen.add(ranks_);
  seen_.add(seen);
  double sums[] = {played.reward, double(played.tally.played), double(played.tally.solved)};
  ranks_.add(sums);
  out.reward = sums[0] / (double(settings_.worlds()) * settings_.ticks * ranks_.count());
  out.played = uint64_t(sums[1]);
  adapt(sums[1] > 0 ? sums[2] / sums[1] : 0, out.played);
}

// Raises the difficulty while most episodes are solved, lowers it while few are. The step is
// smaller after few episodes.
void Trainer::adapt(double solvedNow, uint64_t played) {
  const float weight = std::min(float(played) / kEnoughPlayed, 1.0f);
  solved_ += kSlow * double(weight) * (solvedNow - solved_);
  const float step = kHarder * weight;
  if (solved_ > double(settings_.raiseAt)) hardest_ = std::min(hardest_ + step, 1.0f);
  if (solved_ < double(settings_.lowerAt)) hardest_ = std::max(hardest_ - step, settings_.easiest);
}

void Trainer::refreshNormaliser() {
  for (size_t i = 0; i < means_.size(); ++i) {
    means_[i] = float(seen_.mean(i));
    scales_[i] = scaleOf(seen_.deviation(i));
  }
  hide();
}

// Hidden inputs are zero wherever the network is used.
void Trainer::hide() {
  for (const int i : settings_.hidden) scales_[size_t(i)] = 0;
}

// Throws if this rank could not learn and there are others. The other ranks are in the middle of an
// exchange, so they cannot agree on an error.
Result<Progress> Trainer::learned(Result<Progress> mine) const {
  if (!mine && ranks_.count() > 1) throw std::runtime_error(mine.error().text());
  return mine;
}

Result<Iteration> Trainer::iterate() {
  if (!more_) return more_.error();
  const Stopwatch watch;
  OBBY_ASSIGN(const Played played,
              ranks_.agree(engine_->play({iterations_, hardest_, means_, scales_})));
  Iteration out;
  out.playSeconds = watch.seconds();
  gather(played, out);
  const float share = std::min(float(double(decisions_) / double(settings_.decisions)), 1.0f);
  OBBY_ASSIGN(out.progress, learned(engine_->learn(1 - 0.9f * share)));
  OBBY_RETURN_IF_ERROR(ranks_.agree(takeParameters()));
  OBBY_RETURN_IF_ERROR(sameNetwork());
  OBBY_RETURN_IF_ERROR(ranks_.agree(stillFinite()));
  more_ = ranks_.agree(Status(played.missing));
  refreshNormaliser();
  decisions_ += uint64_t(settings_.worlds()) * settings_.ticks * ranks_.count();
  out.number = ++iterations_;
  out.decisions = decisions_;
  out.solved = solved_;
  out.hardest = hardest_;
  out.seconds = watch.seconds();
  return out;
}

policy::Network Trainer::network() const {
  policy::Network network;
  float* to = network.numbers().data();
  const auto append = [&](const float* from, size_t count) {
    std::copy_n(from, count, to);
    to += count;
  };
  append(means_.data(), means_.size());
  append(scales_.data(), scales_.size());
  append(parameters_.data(), parameters_.size());
  return network;
}

}  // namespace obby::train
