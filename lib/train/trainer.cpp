#include "train/trainer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "policy/policy.h"

namespace obby::train {

namespace {

constexpr uint32_t kCountEvery = 4;       // ticks between those whose rows the normaliser counts
constexpr double kSlow = 0.05;            // weight of a new share of playthroughs solved
constexpr float kHarder = 0.01f;          // a step of the difficulty
constexpr uint64_t kEnoughPlayed = 64;    // playthroughs that say something
constexpr float kLeastDeviation = 0.02f;  // of an input: what never changes is not blown up

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

}  // namespace

Trainer::Group::Group(const LevelSource& source, const TrainerSettings& s, uint32_t number)
    : crowd(source, s.crowd, s.seed, number, s.crowds),
      random(s.seed, 1'000'000u + number),
      batch(s.ticks, s.crowd.levels * s.crowd.worlds),
      mayJump(batch.worlds),
      moves(batch.worlds),
      steps(batch.worlds),
      row(batch.worlds, policy::kInputs) {}

Trainer::Trainer(const TrainerSettings& settings, const LevelSource& source, ThreadPool& pool)
    : settings_(settings),
      pool_(pool),
      ppo_(settings.ppo, settings.seed, pool),
      all_(settings.ticks, settings.crowds * settings.crowd.levels * settings.crowd.worlds),
      means_(policy::kInputs, 0.0f),
      scales_(policy::kInputs, 1.0f),
      hardest_(settings.easiest) {
  for (uint32_t i = 0; i < settings.crowds; ++i)
    groups_.push_back(std::make_unique<Group>(source, settings_, i));
}

Result<std::unique_ptr<Trainer>> Trainer::make(const TrainerSettings& settings,
                                               const LevelSource& source, ThreadPool& pool) {
  std::unique_ptr<Trainer> trainer(new Trainer(settings, source, pool));
  for (auto& group : trainer->groups_) {
    group->crowd.setHardest(settings.easiest);
    OBBY_RETURN_IF_ERROR(group->crowd.begin());
  }
  return trainer;
}

template <class Row>
void Trainer::normalise(Row&& row) const {
  for (int i = 0; i < policy::kInputs; ++i) {
    row[i] = clampf((row[i] - means_[size_t(i)]) * scales_[size_t(i)], -policy::kMostInput,
                    policy::kMostInput);
  }
}

// Rows of the batch of all: (ticks, groups, worlds).
void Trainer::decide(Group& g, uint32_t tick) const {
  g.crowd.observe(g.row.data(), g.mayJump.data());
  for (uint32_t w = 0; w < g.batch.worlds; ++w) {
    if (tick % kCountEvery == 0) g.seen.add(g.row.row(w).data());
    normalise(g.row.row(w).data());
  }
  const Rows<float>& out = g.pass.forward(ppo_.weights(), g.row);
  const size_t first = size_t(tick) * g.batch.worlds;
  g.batch.inputs.middleRows(Eigen::Index(first), g.batch.worlds) = g.row;
  for (uint32_t w = 0; w < g.batch.worlds; ++w) {
    const float* const logits = out.row(w).data();
    float chances[policy::kMoves];
    chancesOf(logits, g.mayJump[w] != 0, chances);
    float rest = g.random.unit();
    int move = 0;
    for (int m = 0; m < policy::kMoves && rest >= 0; ++m) {
      if (!(chances[m] > 0)) continue;
      move = m;
      rest -= chances[m];
    }
    g.moves[w] = move;
    g.batch.decisions[first + w] = {move, g.mayJump[w] != 0, std::log(chances[move]), 0, 0};
    g.batch.values[first + w] = ppo_.valueMean() + ppo_.valueDeviation() * logits[policy::kMoves];
  }
}

// After a cut the value of what was seen last stands for what would have come.
Status Trainer::take(Group& g, uint32_t tick) const {
  OBBY_RETURN_IF_ERROR(g.crowd.step(g.moves, g.steps));
  const size_t first = size_t(tick) * g.batch.worlds;
  for (uint32_t w = 0; w < g.batch.worlds; ++w) {
    g.batch.rewards[first + w] = g.steps[w].reward;
    g.batch.done[first + w] = g.steps[w].ended || g.steps[w].cut;
  }
  const auto& cut = g.crowd.cutWorlds();
  if (cut.empty()) return {};
  Rows<float> rows = Eigen::Map<const Rows<float>>(g.crowd.cutRows().data(),
                                                   Eigen::Index(cut.size()), policy::kInputs);
  for (size_t i = 0; i < cut.size(); ++i) normalise(rows.row(Eigen::Index(i)).data());
  const Rows<float>& out = g.cutPass.forward(ppo_.weights(), rows);
  for (size_t i = 0; i < cut.size(); ++i) {
    const float value = out(Eigen::Index(i), policy::kMoves);
    g.batch.rewards[first + cut[i]] +=
        settings_.ppo.discount * (ppo_.valueMean() + ppo_.valueDeviation() * value);
  }
  return {};
}

void Trainer::play(Group& g) const {
  g.crowd.setHardest(hardest_);
  g.status = Status{};
  for (uint32_t t = 0; t < settings_.ticks && g.status; ++t) {
    decide(g, t);
    g.status = take(g, t);
  }
  g.crowd.observe(g.row.data(), g.mayJump.data());
  for (uint32_t w = 0; w < g.batch.worlds; ++w) normalise(g.row.row(w).data());
  const Rows<float>& out = g.pass.forward(ppo_.weights(), g.row);
  for (uint32_t w = 0; w < g.batch.worlds; ++w)
    g.batch.last[w] = ppo_.valueMean() + ppo_.valueDeviation() * out(w, policy::kMoves);
}

void Trainer::gather(Iteration& out) {
  const uint32_t each = groups_[0]->batch.worlds;
  Tally tally;
  double reward = 0;
  for (size_t n = 0; n < groups_.size(); ++n) {
    Group& g = *groups_[n];
    const size_t column = n * each;
    for (uint32_t t = 0; t < settings_.ticks; ++t) {
      const size_t from = size_t(t) * each, to = size_t(t) * all_.worlds + column;
      all_.inputs.middleRows(Eigen::Index(to), each) =
          g.batch.inputs.middleRows(Eigen::Index(from), each);
      const auto copy = [&](const auto& a, auto& b) {
        std::copy_n(a.begin() + ptrdiff_t(from), each, b.begin() + ptrdiff_t(to));
      };
      copy(g.batch.decisions, all_.decisions);
      copy(g.batch.values, all_.values);
      copy(g.batch.rewards, all_.rewards);
      copy(g.batch.done, all_.done);
    }
    std::copy_n(g.batch.last.begin(), each, all_.last.begin() + ptrdiff_t(column));
    const Tally t = g.crowd.takeTally();
    tally.played += t.played;
    tally.solved += t.solved;
    seen_.add(g.seen);
    g.seen = Sums(policy::kInputs);
  }
  for (const float r : all_.rewards) reward += double(r);
  out.reward = reward / double(all_.rewards.size());
  out.played = tally.played;
  adapt(tally.played > 0 ? double(tally.solved) / double(tally.played) : 0, tally.played);
}

// Levels become harder while most are solved, easier while few are.
void Trainer::adapt(double solvedNow, uint64_t played) {
  if (played < kEnoughPlayed) return;
  solved_ += kSlow * (solvedNow - solved_);
  if (solved_ > double(settings_.raiseAt)) hardest_ = std::min(hardest_ + kHarder, 1.0f);
  if (solved_ < double(settings_.lowerAt))
    hardest_ = std::max(hardest_ - kHarder, settings_.easiest);
}

Result<Iteration> Trainer::iterate() {
  const auto begin = Clock::now();
  pool_.run(int(groups_.size()), [&](int i) { play(*groups_[size_t(i)]); });
  for (const auto& g : groups_) OBBY_RETURN_IF_ERROR(Status(g->status));
  Iteration out;
  out.playSeconds = secondsSince(begin);
  gather(out);
  const float share = std::min(float(double(decisions_) / double(settings_.decisions)), 1.0f);
  out.progress = ppo_.learn(all_, 1 - 0.9f * share);
  for (size_t i = 0; i < means_.size(); ++i) {
    means_[i] = float(seen_.mean(i));
    scales_[i] = 1 / std::max(float(seen_.deviation(i)), kLeastDeviation);
  }
  decisions_ += all_.decisions.size();
  out.number = ++iterations_;
  out.decisions = decisions_;
  out.solved = solved_;
  out.hardest = hardest_;
  out.seconds = secondsSince(begin);
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
  Weights<float> weights = ppo_.weights();
  weights.blocks(append);
  return network;
}

}  // namespace obby::train
