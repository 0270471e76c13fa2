// Measures the training rate: the whole loop of obby-train with newly generated levels, on all
// threads and on a GPU if present. With --gpu it runs on the GPU only and exits with 77 without
// one. With --emulate the CPU replaces the GPU at a small scale, which only tests this program.
// With --kernels it reports each kernel's share of the time instead of the device's rates.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "common/need.h"
#include "common/report.h"
#include "common/timed_device.h"
#include "nn/device/kernels.h"
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

// A loop of obby-train, on the CPU if `device` is null.
class Loop {
 public:
  struct Took {
    double seconds = 0, playing = 0;
    uint64_t decisions = 0;
  };

  Loop(const train::TrainerSettings& settings, ThreadPool& pool, sim::Device* device)
      : source_(need(tools::generatedLevels(anyDifficulty(), 1))),
        trainer_(need(train::Trainer::make(
            settings,
            device == nullptr ? train::makeCpuEngine(settings, *source_, pool, alone_)
                              : train::makeDeviceEngine(settings, *source_, *device, pool, alone_),
            alone_))) {}

  Took iterate(int times) {
    Took took;
    const uint64_t before = trainer_->decisions();
    for (int i = 0; i < times; ++i) {
      const train::Iteration iteration = need(trainer_->iterate());
      took.seconds += iteration.seconds;
      took.playing += iteration.playSeconds;
    }
    took.decisions = trainer_->decisions() - before;
    return took;
  }

 private:
  static gen::Recipe anyDifficulty() {
    gen::Recipe recipe;
    recipe.difficulty = {0, 1};
    return recipe;
  }

  std::unique_ptr<train::LevelSource> source_;
  train::OneRank alone_;
  std::unique_ptr<train::Trainer> trainer_;
};

void scene(bench::Report& report, const std::string& name, const train::TrainerSettings& settings,
           const Turns& turns, ThreadPool& pool, sim::Device* device) {
  Loop loop(settings, pool, device);
  loop.iterate(turns.warmUp);
  const Loop::Took took = loop.iterate(turns.measured);
  report.add(name, "decisionsPerSecond", double(took.decisions) / took.seconds, "1/s");
  report.add(name, "playShare", took.playing / took.seconds, "");
}

train::TrainerSettings settingsOf(uint32_t passes) {
  train::TrainerSettings settings;
  settings.easiest = 0.5f;
  settings.ppo.epochs = passes;
  return settings;
}

void onCpu(bench::Report& report, ThreadPool& pool) {
  for (const uint32_t passes : {1u, 2u})
    scene(report, fmt::format("passes{}", passes), settingsOf(passes), {}, pool, nullptr);
}

train::TrainerSettings settingsOnDevice(uint32_t passes, uint32_t worlds, uint32_t part) {
  train::TrainerSettings settings = settingsOf(passes);
  settings.envGroups = worlds / settings.envGroup.size();
  settings.ppo.minibatch = part;
  return settings;
}

// Reports each kernel's share of the time when every kernel is waited for.
void kernels(bench::Report& report, ThreadPool& pool, sim::Device& device, bool small) {
  bench::TimedDevice timed(device);
  const auto settings = small ? settingsOnDevice(1, 256, 1024) : settingsOnDevice(1, 65536, 65536);
  Loop loop(settings, pool, &timed);
  loop.iterate(small ? 1 : 5);
  timed.forget();
  const Loop::Took took = loop.iterate(small ? 1 : 5);
  report.add("waiting", "decisionsPerSecond", double(took.decisions) / took.seconds, "1/s");
  for (const auto& [name, time] : timed.times()) {
    report.add(name, "shareOfSeconds", time.seconds / took.seconds, "");
    report.add(name, "secondsOfLaunch", time.seconds / double(time.launches), "s");
  }
}

void onDevice(bench::Report& report, ThreadPool& pool, sim::Device& device, bool small) {
  for (const sim::Kernel& kernel :
       {train::trainKernel(train::TrainStep::act), train::trainKernel(train::TrainStep::observe),
        nn::kernel(nn::Step::product), nn::kernel(nn::Step::gradient)}) {
    const auto facts = device.facts(kernel);
    if (!facts) continue;
    report.add(kernel.name, "registers", facts->registers, "");
    report.add(kernel.name, "localBytes", facts->localBytes, "B");
  }
  const std::vector<uint32_t> counts =
      small ? std::vector<uint32_t>{256} : std::vector<uint32_t>{16384, 65536, 131072};
  for (const uint32_t worlds : counts) {
    for (const uint32_t passes : {1u, 2u}) {
      const auto settings = settingsOnDevice(passes, worlds, small ? 1024 : 65536);
      const Turns turns = small ? Turns{1, 2} : Turns{5, 20};
      scene(report, fmt::format("cuda{}passes{}", worlds, passes), settings, turns, pool, &device);
    }
  }
}

// Removes a word from the arguments. Returns true if it was there.
bool given(int& argc, char** argv, std::string_view word) {
  char** const end = std::remove_if(argv + 1, argv + argc,
                                    [&](const char* a) { return std::string_view(a) == word; });
  const bool found = end != argv + argc;
  argc = int(end - argv);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  const bool small = given(argc, argv, "--emulate"), only = given(argc, argv, "--gpu"),
             times = given(argc, argv, "--kernels");
  obby::bench::Report report(argc, argv, "train");
  obby::ThreadPool pool(obby::availableThreads());
  sim::HostDevice host(pool);
  const auto backend = obby::sim::Backend::open(obby::sim::BackendKind::cuda);
  if (only && !backend && !small) {
    std::fprintf(stderr, "bench_train: skipped: %s\n", backend.error().text().c_str());
    return kSkipped;
  }
  report.add("machine", "threads", pool.size(), "");
  if (!only && !small) onCpu(report, pool);
  sim::Device* const device = small ? &host : backend ? (*backend).device() : nullptr;
  if (device == nullptr) return 0;
  if (times) kernels(report, pool, *device, small);
  if (!times) onDevice(report, pool, *device, small);
}
