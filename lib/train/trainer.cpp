#include "train/trainer.h"

#include <algorithm>
#include <chrono>

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

// Crowds are numbered over all ranks.
Trainer::Group::Group(const LevelSource& source, const TrainerSettings& s, uint32_t number,
                      const Ranks& ranks)
    : crowd(source, s.crowd, s.seed, ranks.number() * s.crowds + number, s.crowds * ranks.count()),
      random(s.seed, 1'000'000u + ranks.number() * s.crowds + number),
      first(number * crowd.size()),
      worlds(crowd.size()),
      mayJump(worlds),
      moves(worlds),
      steps(worlds),
      row(worlds, policy::kInputs) {}

Trainer::Trainer(const TrainerSettings& settings, const LevelSource& source, ThreadPool& pool,
                 Ranks& ranks)
    : settings_(settings),
      source_(source),
      pool_(pool),
      ranks_(ranks),
      ppo_(settings.ppo, settings.seed, pool, ranks),
      batch_(settings.ticks, settings.crowds * settings.crowd.levels * settings.crowd.worlds),
      means_(policy::kInputs, 0.0f),
      scales_(policy::kInputs, 1.0f),
      hardest_(settings.easiest) {
  for (uint32_t i = 0; i < settings.crowds; ++i)
    groups_.push_back(std::make_unique<Group>(source, settings_, i, ranks));
  hide();
}

Result<std::unique_ptr<Trainer>> Trainer::make(const TrainerSettings& settings,
                                               const LevelSource& source, ThreadPool& pool,
                                               Ranks& ranks) {
  std::unique_ptr<Trainer> trainer(new Trainer(settings, source, pool, ranks));
  OBBY_RETURN_IF_ERROR(ranks.agree(trainer->begin()));
  return trainer;
}

Status Trainer::begin() {
  for (auto& group : groups_) {
    group->crowd.setHardest(settings_.easiest);
    OBBY_RETURN_IF_ERROR(group->crowd.begin());
  }
  return {};
}

void Trainer::normalise(float* row) const {
  for (size_t i = 0; i < means_.size(); ++i)
    row[i] = policy::normalised(row[i], means_[i], scales_[i]);
}

// Rows of the batch: (ticks, groups, worlds).
size_t Trainer::rowOf(const Group& g, uint32_t tick) const {
  return size_t(tick) * batch_.worlds + g.first;
}

float Trainer::valueOf(const Rows<float>& outputs, size_t row) const {
  return ppo_.valueMean() + ppo_.valueDeviation() * outputs(Eigen::Index(row), policy::kMoves);
}

void Trainer::decide(Group& g, uint32_t tick) {
  g.crowd.observe(g.row.data(), g.mayJump.data());
  for (uint32_t w = 0; w < g.worlds; ++w) {
    if (tick % kCountEvery == 0) g.seen.add(g.row.row(w).data());
    normalise(g.row.row(w).data());
  }
  const Rows<float>& out = g.pass.forward(ppo_.weights(), g.row);
  const size_t first = rowOf(g, tick);
  batch_.inputs.middleRows(Eigen::Index(first), g.worlds) = g.row;
  for (uint32_t w = 0; w < g.worlds; ++w) {
    float chances[policy::kMoves];
    policy::chancesOf(out.row(w).data(), g.mayJump[w] != 0, chances);
    float rest = g.random.unit();
    int move = 0;
    for (int m = 0; m < policy::kMoves && rest >= 0; ++m) {
      if (!(chances[m] > 0)) continue;
      move = m;
      rest -= chances[m];
    }
    g.moves[w] = move;
    batch_.decisions[first + w] = {move, g.mayJump[w] != 0, logOf(chances[move]), 0, 0};
    batch_.values[first + w] = valueOf(out, w);
  }
}

// After a cut the value of what was seen last stands for what would have come.
Status Trainer::take(Group& g, uint32_t tick) {
  OBBY_RETURN_IF_ERROR(g.crowd.step(g.moves, g.steps));
  const size_t first = rowOf(g, tick);
  for (uint32_t w = 0; w < g.worlds; ++w) {
    batch_.rewards[first + w] = g.steps[w].reward;
    batch_.done[first + w] = g.steps[w].ended || g.steps[w].cut;
  }
  const auto& cut = g.crowd.cutWorlds();
  if (cut.empty()) return {};
  Rows<float> rows = Eigen::Map<const Rows<float>>(g.crowd.cutRows().data(),
                                                   Eigen::Index(cut.size()), policy::kInputs);
  for (size_t i = 0; i < cut.size(); ++i) normalise(rows.row(Eigen::Index(i)).data());
  const Rows<float>& out = g.cutPass.forward(ppo_.weights(), rows);
  for (size_t i = 0; i < cut.size(); ++i)
    batch_.rewards[first + cut[i]] += settings_.ppo.discount * valueOf(out, i);
  return {};
}

void Trainer::play(Group& g) {
  g.crowd.setHardest(hardest_);
  g.status = Status{};
  for (uint32_t t = 0; t < settings_.ticks && g.status; ++t) {
    decide(g, t);
    g.status = take(g, t);
  }
  g.crowd.observe(g.row.data(), g.mayJump.data());
  for (uint32_t w = 0; w < g.worlds; ++w) normalise(g.row.row(w).data());
  const Rows<float>& out = g.pass.forward(ppo_.weights(), g.row);
  for (uint32_t w = 0; w < g.worlds; ++w) batch_.last[g.first + w] = valueOf(out, w);
}

void Trainer::gather(Iteration& out) {
  Tally tally;
  Sums seen(policy::kInputs);
  double reward = 0;
  for (const auto& g : groups_) {
    const Tally t = g->crowd.takeTally();
    tally.played += t.played;
    tally.solved += t.solved;
    seen.add(g->seen);
    g->seen = Sums(policy::kInputs);
  }
  for (const float r : batch_.rewards) reward += double(r);
  seen.add(ranks_);
  seen_.add(seen);
  double sums[] = {reward, double(tally.played), double(tally.solved)};
  ranks_.add(sums);
  out.reward = sums[0] / (double(batch_.rewards.size()) * ranks_.count());
  out.played = uint64_t(sums[1]);
  adapt(sums[1] > 0 ? sums[2] / sums[1] : 0, out.played);
}

// Levels become harder while most are solved, easier while few are.
void Trainer::adapt(double solvedNow, uint64_t played) {
  if (played < kEnoughPlayed) return;
  solved_ += kSlow * (solvedNow - solved_);
  if (solved_ > double(settings_.raiseAt)) hardest_ = std::min(hardest_ + kHarder, 1.0f);
  if (solved_ < double(settings_.lowerAt))
    hardest_ = std::max(hardest_ - kHarder, settings_.easiest);
}

void Trainer::refreshNormaliser() {
  for (size_t i = 0; i < means_.size(); ++i) {
    means_[i] = float(seen_.mean(i));
    scales_[i] = 1 / std::max(float(seen_.deviation(i)), kLeastDeviation);
  }
  hide();
}

// Wherever the network is used, what it was not shown is zero.
void Trainer::hide() {
  for (const int i : settings_.hidden) scales_[size_t(i)] = 0;
}

void Trainer::dropPastLevels() {
  uint64_t first = ~uint64_t(0);
  for (const auto& g : groups_) first = std::min(first, g->crowd.firstLevel());
  source_.past(first);
}

Result<Iteration> Trainer::iterate() {
  const auto begin = Clock::now();
  pool_.run(int(groups_.size()), [&](int i) { play(*groups_[size_t(i)]); });
  Status played;
  for (const auto& g : groups_) {
    if (played) played = g->status;
  }
  OBBY_RETURN_IF_ERROR(ranks_.agree(std::move(played)));
  Iteration out;
  out.playSeconds = secondsSince(begin);
  gather(out);
  const float share = std::min(float(double(decisions_) / double(settings_.decisions)), 1.0f);
  out.progress = ppo_.learn(batch_, 1 - 0.9f * share);
  OBBY_RETURN_IF_ERROR(sameNetwork());
  refreshNormaliser();
  dropPastLevels();
  decisions_ += batch_.decisions.size() * ranks_.count();
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
