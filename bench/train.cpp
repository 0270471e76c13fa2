// How fast learning is: the whole loop of obby-train, levels made anew included, on all threads.
#include <fmt/format.h>

#include "common/report.h"
#include "shared/generated_levels.h"
#include "train/trainer.h"

namespace {

using namespace obby;

constexpr int kWarmUp = 10, kIterations = 60;

// `passes` over each batch.
void scene(bench::Report& report, uint32_t passes, ThreadPool& pool) {
  gen::Recipe recipe;
  recipe.difficulty = {0, 1};
  const auto source = tools::generatedLevels(recipe, 1);
  train::TrainerSettings settings;
  settings.easiest = 0.5f;
  settings.ppo.passes = passes;
  train::OneRank alone;
  const auto trainer = train::Trainer::make(settings, **source, pool, alone);
  uint64_t decisions = 0;
  double seconds = 0, playing = 0;
  for (int i = 0; i < kWarmUp + kIterations; ++i) {
    const auto iteration = (*trainer)->iterate();
    if (i == kWarmUp - 1) decisions = iteration->decisions;
    if (i < kWarmUp) continue;
    seconds += iteration->seconds;
    playing += iteration->playSeconds;
    if (i == kWarmUp + kIterations - 1) decisions = iteration->decisions - decisions;
  }
  const std::string name = fmt::format("passes{}", passes);
  report.add(name, "decisionsPerSecond", double(decisions) / seconds, "1/s");
  report.add(name, "playShare", playing / seconds, "");
}

}  // namespace

int main(int argc, char** argv) {
  obby::bench::Report report(argc, argv, "train");
  obby::ThreadPool pool(obby::availableThreads());
  report.add("machine", "threads", pool.size(), "");
  scene(report, 1, pool);
  scene(report, 2, pool);
}
