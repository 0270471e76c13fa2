// Training on the CPU: env groups play on the threads of a pool.
#include "train/engine.h"

namespace obby::train {

namespace {

class CpuEngine : public Engine {
 public:
  CpuEngine(const TrainerSettings& settings, const LevelSource& source, ThreadPool& pool,
            Ranks& ranks);

  Status begin(float hardest) override;
  Status restore(const LearnerState& learner, std::span<EnvGroupState> envGroups) override;
  Status setLearner(const LearnerState& learner) override {
    ppo_.restore(learner);
    return {};
  }
  Result<Played> play(const PlayOrder& order) override;
  Result<Progress> learn(float rate) override { return ppo_.learn(batch_, rate); }
  Result<LearnerState> learner() const override { return ppo_.state(); }
  Result<std::vector<EnvGroupState>> envGroups() const override;

 private:
  struct Group {  // an env group with its part of the batch
    Group(const LevelSource& source, const TrainerSettings& s, uint32_t number, const Ranks& ranks);
    EnvGroup envGroup;
    uint32_t first, worlds;      // the group's range of the batch's worlds
    std::vector<uint32_t> rows;  // rows of the group's worlds in a tick
    nn::Pass<float> pass;
    Sums seen{policy::kInputs};
    std::vector<uint8_t> mayJump;
    std::vector<int> moves;
    std::vector<Step> steps;
    std::vector<float> raw;  // observations of a tick, (worlds, kInputs)
    Status missing;          // error of the next levels
  };

  void play(Group& group, const PlayOrder& order);
  const float* look(Group& group, uint32_t tick, bool count);
  void decide(Group& group, const PlayOrder& order, uint32_t tick);
  void take(Group& group, uint32_t tick);
  uint64_t decisionOf(const PlayOrder& order, uint32_t tick) const {
    return order.iteration * settings_.ticks + tick;
  }
  size_t rowOf(const Group& group, uint32_t tick) const;  // row of the group's first world

  TrainerSettings settings_;
  const LevelSource& source_;
  ThreadPool& pool_;
  Ppo ppo_;
  std::vector<std::unique_ptr<Group>> groups_;
  Batch batch_;
  std::vector<float> void_;  // first-layer sums of empty surroundings in this iteration
};

// Env groups are numbered across all ranks.
CpuEngine::Group::Group(const LevelSource& source, const TrainerSettings& s, uint32_t number,
                        const Ranks& ranks)
    : envGroup(source, s.envGroup, s.seed, ranks.number() * s.envGroups + number,
               s.envGroups * ranks.count()),
      first(number * envGroup.size()),
      worlds(envGroup.size()),
      rows(worlds),
      mayJump(worlds),
      moves(worlds),
      steps(worlds),
      raw(size_t(worlds) * policy::kInputs) {}

CpuEngine::CpuEngine(const TrainerSettings& settings, const LevelSource& source, ThreadPool& pool,
                     Ranks& ranks)
    : settings_(settings),
      source_(source),
      pool_(pool),
      ppo_(settings.ppo, settings.seed, pool, ranks),
      batch_(settings.ticks, settings.worlds()) {
  for (uint32_t i = 0; i < settings.envGroups; ++i)
    groups_.push_back(std::make_unique<Group>(source, settings_, i, ranks));
}

Status CpuEngine::begin(float hardest) {
  for (auto& group : groups_) OBBY_RETURN_IF_ERROR(group->envGroup.begin(hardest));
  return {};
}

Status CpuEngine::restore(const LearnerState& learner, std::span<EnvGroupState> envGroups) {
  // A resumed stream is read from its beginning. Levels that were played before are not kept again.
  uint64_t first = ~uint64_t(0);
  for (size_t i = 0; i < groups_.size(); ++i)
    first = std::min(first, groups_[i]->envGroup.firstLevelOf(envGroups[i]));
  source_.past(first);
  for (size_t i = 0; i < groups_.size(); ++i)
    OBBY_RETURN_IF_ERROR(groups_[i]->envGroup.restore(std::move(envGroups[i])));
  ppo_.restore(learner);
  return {};
}

Result<std::vector<EnvGroupState>> CpuEngine::envGroups() const {
  std::vector<EnvGroupState> out;
  for (const auto& group : groups_) out.push_back(group->envGroup.state());
  return out;
}

// Returns the first row of the group's worlds. Rows of the batch: (ticks, groups, worlds).
size_t CpuEngine::rowOf(const Group& g, uint32_t tick) const {
  return size_t(tick) * batch_.worlds + g.first;
}

// Observes all worlds and returns the network's outputs, (worlds, kPaddedOutputs).
const float* CpuEngine::look(Group& g, uint32_t tick, bool count) {
  g.envGroup.observe(g.raw.data(), g.mayJump.data());
  for (uint32_t w = 0; w < g.worlds; ++w) {
    const float* const raw = g.raw.data() + size_t(w) * policy::kInputs;
    if (count) g.seen.add(raw);
    g.rows[w] = uint32_t(rowOf(g, tick) + w);
    batch_.seen.take(g.rows[w], raw);
  }
  return g.pass.forward(ppo_.net(), SeenPart(batch_.seen, g.rows, void_));
}

void CpuEngine::decide(Group& g, const PlayOrder& order, uint32_t tick) {
  const float* out = look(g, tick, tick % kCountEvery == 0);
  const size_t first = rowOf(g, tick);
  for (uint32_t w = 0; w < g.worlds; ++w, out += policy::kPaddedOutputs) {
    const bool mayJump = g.mayJump[w] != 0;
    const float draw =
        drawsOf(settings_.seed, Draw::move, decisionOf(order, tick), g.envGroup.firstWorld() + w)
            .unit();
    const nn::Drawn drawn = policy::drawMove(out, mayJump, draw);
    g.moves[w] = drawn.action;
    batch_.decisions[first + w] = {{drawn.action, drawn.logProbability, 0, 0}, mayJump};
    batch_.values[first + w] = ppo_.valueOf(out[policy::kMoves]);
  }
}

void CpuEngine::take(Group& g, uint32_t tick) {
  g.envGroup.step(g.moves, g.steps);
  const size_t first = rowOf(g, tick);
  for (uint32_t w = 0; w < g.worlds; ++w) {
    batch_.rewards[first + w] = g.steps[w].reward;
    batch_.done[first + w] = g.steps[w].ended;
  }
}

// The value of the last observation estimates the remaining return, even for cut episodes.
void CpuEngine::play(Group& g, const PlayOrder& order) {
  for (uint32_t t = 0; t < settings_.ticks; ++t) {
    if (t > 0) g.envGroup.settle(decisionOf(order, t - 1));
    decide(g, order, t);
    take(g, t);
  }
  const float* const out = look(g, settings_.ticks, false) + policy::kMoves;
  for (uint32_t w = 0; w < g.worlds; ++w)
    batch_.last[g.first + w] = ppo_.valueOf(out[size_t(w) * policy::kPaddedOutputs]);
  g.missing = g.envGroup.settleIteration(decisionOf(order, settings_.ticks - 1), order.hardest);
}

Result<Played> CpuEngine::play(const PlayOrder& order) {
  batch_.seen.normaliseBy(order.means, order.scales);
  voidSums(batch_.seen, ppo_.net(), void_);
  pool_.run(int(groups_.size()), [&](int i) { play(*groups_[size_t(i)], order); });
  Played out;
  uint64_t first = ~uint64_t(0);  // first level that is still played
  for (const auto& g : groups_) {
    if (out.missing) out.missing = std::move(g->missing);
    first = std::min(first, g->envGroup.firstLevel());
    const Tally t = g->envGroup.takeTally();
    out.tally.played += t.played;
    out.tally.solved += t.solved;
    out.seen.add(g->seen);
    g->seen = Sums(policy::kInputs);
  }
  source_.past(first);
  for (const float r : batch_.rewards) out.reward += double(r);
  return out;
}

}  // namespace

std::unique_ptr<Engine> makeCpuEngine(const TrainerSettings& settings, const LevelSource& source,
                                      ThreadPool& pool, Ranks& ranks) {
  return std::make_unique<CpuEngine>(settings, source, pool, ranks);
}

}  // namespace obby::train
