// How fast learning is: the whole loop of obby-train, levels made anew included; on all threads,
// and, where there is one, on a GPU. With --gpu on the GPU only: ends with 77 where there is none.
// With --emulate the CPU takes the GPU's place, in small: a test of this program, not a
// measurement.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "common/need.h"
#include "common/report.h"
#include "shared/generated_levels.h"
#include "sim/backend.h"
#include "sim/host_device.h"
#include "train/device/device_engine.h"
#include "train/device/kernels.h"
#include "train/trainer.h"

namespace {

using namespace obby;
using bench::need;

constexpr int kSkipped = 77;

struct Turns {
  int warmUp = 10, measured = 60;  // iterations
};

// `device` null: on the CPU.
void scene(bench::Report& report, const std::string& name, const train::TrainerSettings& settings,
           const Turns& turns, ThreadPool& pool, sim::Device* device) {
  gen::Recipe recipe;
  recipe.difficulty = {0, 1};
  const auto source = need(tools::generatedLevels(recipe, 1));
  train::OneRank alone;
  const auto trainer = need(train::Trainer::make(
      settings,
      device == nullptr ? train::makeCpuEngine(settings, *source, pool, alone)
                        : train::makeDeviceEngine(settings, *source, *device, pool, alone),
      alone));
  for (int i = 0; i < turns.warmUp; ++i) need(trainer->iterate());
  const uint64_t before = trainer->decisions();
  double seconds = 0, playing = 0;
  for (int i = 0; i < turns.measured; ++i) {
    const train::Iteration iteration = need(trainer->iterate());
    seconds += iteration.seconds;
    playing += iteration.playSeconds;
  }
  report.add(name, "decisionsPerSecond", double(trainer->decisions() - before) / seconds, "1/s");
  report.add(name, "playShare", playing / seconds, "");
}

train::TrainerSettings settingsOf(uint32_t passes) {
  train::TrainerSettings settings;
  settings.easiest = 0.5f;
  settings.ppo.passes = passes;
  return settings;
}

void onCpu(bench::Report& report, ThreadPool& pool) {
  for (const uint32_t passes : {1u, 2u})
    scene(report, fmt::format("passes{}", passes), settingsOf(passes), {}, pool, nullptr);
}

void onDevice(bench::Report& report, ThreadPool& pool, sim::Device& device, bool small) {
  for (const auto step : {train::TrainStep::act, train::TrainStep::observe,
                          train::TrainStep::product, train::TrainStep::gradient}) {
    const auto facts = device.facts(train::trainKernel(step));
    if (!facts) continue;
    report.add(train::trainKernel(step).name, "registers", facts->registers, "");
    report.add(train::trainKernel(step).name, "localBytes", facts->localBytes, "B");
  }
  const std::vector<uint32_t> counts =
      small ? std::vector<uint32_t>{256} : std::vector<uint32_t>{16384, 65536, 131072};
  for (const uint32_t worlds : counts) {
    for (const uint32_t passes : {1u, 2u}) {
      train::TrainerSettings settings = settingsOf(passes);
      settings.crowds = worlds / settings.crowd.size();
      settings.ppo.part = small ? 1024 : 65536;
      const Turns turns = small ? Turns{1, 2} : Turns{5, 20};
      scene(report, fmt::format("cuda{}passes{}", worlds, passes), settings, turns, pool, &device);
    }
  }
}

// Takes the word out of the arguments.
bool given(int& argc, char** argv, std::string_view word) {
  char** const end = std::remove_if(argv + 1, argv + argc,
                                    [&](const char* a) { return std::string_view(a) == word; });
  const bool found = end != argv + argc;
  argc = int(end - argv);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  const bool small = given(argc, argv, "--emulate"), only = given(argc, argv, "--gpu");
  obby::bench::Report report(argc, argv, "train");
  obby::ThreadPool pool(obby::availableThreads());
  obby::sim::HostDevice host(pool);
  const auto backend = obby::sim::Backend::open(obby::sim::BackendKind::cuda);
  if (only && !backend && !small) {
    std::fprintf(stderr, "bench_train: skipped: %s\n", backend.error().text().c_str());
    return kSkipped;
  }
  report.add("machine", "threads", pool.size(), "");
  if (!only && !small) onCpu(report, pool);
  if (small) onDevice(report, pool, host, true);
  if (backend && !small) onDevice(report, pool, *backend->device(), false);
}
