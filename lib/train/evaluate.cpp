#include "train/evaluate.h"

#include <algorithm>

namespace obby::train {

namespace {

// One playthrough by the policy alone; true: it reaches the goal. `random` null: the likeliest
// moves.
bool playAlone(const policy::NetworkView& network, const TrainingLevel& level, Random* random,
               uint32_t mostTicks) {
  const policy::Scene& scene = level.scene();
  sim::World world = level.start();
  std::vector<sim::LooseBody> loose = level.startLoose();
  for (uint32_t t = 0; t < mostTicks; t += policy::kDecisionTicks) {
    const sim::Action action = policy::decide(scene, network, world, loose.data(), random);
    for (uint32_t k = 0; k < policy::kDecisionTicks; ++k) {
      sim::advance(world, loose.data(), scene.level, &scene.query, action);
    }
    if (world.outcome != sim::Outcome::running) return world.outcome == sim::Outcome::goal;
  }
  return false;
}

}  // namespace

Result<Evaluation> evaluate(const policy::Network& network, const LevelSource& source,
                            const EvaluationSettings& settings, ThreadPool& pool,
                            const std::atomic<bool>& stop) {
  struct Score {
    Status status;
    bool done = false, likeliest = false;
    uint32_t drawn = 0;
  };
  std::vector<Score> scores(settings.levels);
  const policy::Thinker thinker(network);
  pool.run(int(settings.levels), [&](int i) {
    if (stop) return;
    Score& score = scores[size_t(i)];
    const uint64_t index = settings.firstLevel + uint64_t(i);
    const auto level = source.level(index, settings.hardest);
    if (!level) {
      score.status = level.error();
      return;
    }
    if (*level == nullptr) return;
    const uint32_t most = mostTicksOf(**level, settings.patience);
    score.likeliest = playAlone(thinker.view(), **level, nullptr, most);
    Random random(settings.seed, index);
    for (uint32_t k = 1; k < settings.tries; ++k)
      score.drawn += playAlone(thinker.view(), **level, &random, most);
    score.done = true;
  });
  Evaluation out;
  for (const Score& s : scores) {
    OBBY_RETURN_IF_ERROR(Status(s.status));
    if (!s.done) continue;
    ++out.levels;
    out.likeliest += s.likeliest;
    out.drawn += settings.tries > 1 ? double(s.drawn) / (settings.tries - 1) : 0;
    out.any += s.likeliest || s.drawn > 0;
  }
  for (double* share : {&out.likeliest, &out.drawn, &out.any})
    *share = out.levels > 0 ? *share / out.levels : 0;
  return out;
}

}  // namespace obby::train
