// Measures a GPU's simulation rates. Random walkers run in one arena of 100 boxes. They also run in
// 64 arenas of that kind, with a new arena after each episode, as in training. Searches on the GPU,
// with and without learning, run with all the work of a round. Exits with 77 without a GPU. With
// --emulate the CPU replaces the GPU at a small scale, which only tests this program.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "baselines/cflge.h"
#include "baselines/pbge.h"
#include "common/need.h"
#include "common/report.h"
#include "sim/backend.h"
#include "sim/host_device.h"
#include "solve/search/resident/resident_explore.h"
#include "solve/search/rollouts/device_rollouts.h"
#include "support/courses.h"

namespace {

using namespace obby;
using bench::need;

constexpr int kSkipped = 77;
constexpr uint32_t kStep = 32;             // ticks per launch
constexpr uint32_t kMaxResident = 131072;  // max rollouts per round that fit a search's memory
constexpr uint32_t kWarmTicks = 96;        // ticks until worlds have left the start

void stepOrFail(sim::Batch& batch, uint32_t ticks) {
  need(batch.step(ticks, sim::Actions::walker(1)));
}

// Returns the median of five runs of about `ticks` ticks each.
double stepsPerSecond(sim::Device& device, const sim::Course& course, uint32_t worlds,
                      uint32_t ticks, uint32_t step) {
  const auto batch = need(sim::makeKernelBatch(course, worlds, device));
  stepOrFail(*batch, kWarmTicks);
  std::vector<double> rates;
  for (int turn = 0; turn < 5; ++turn) {
    const double seconds = bench::secondsOf([&] {
      for (uint32_t t = 0; t < ticks; t += step) stepOrFail(*batch, step);
    });
    rates.push_back(double(worlds) * ticks / seconds);
  }
  std::sort(rates.begin(), rates.end());
  return rates[2];
}

// Returns the median of five runs of several rounds each, after the archive has begun to fill.
double searchStepsPerSecond(solve::Search& search, int rounds) {
  std::vector<double> rates;
  for (int turn = -1; turn < 5; ++turn) {
    const uint64_t before = search.statistics().steps;
    const double seconds = bench::secondsOf([&] {
      for (int i = 0; i < rounds; ++i) search.round();
    });
    if (turn >= 0) rates.push_back(double(search.statistics().steps - before) / seconds);
  }
  need(search.deviceStatus());
  std::sort(rates.begin(), rates.end());
  return rates[2];
}

solve::Problem endlessProblem(const support::Levels& arena) {
  level::QueryView query = arena.course.queries[0];
  query.timeLimitTicks = 0;
  return {arena.course.levels[0], query, arena.course.starts[0], {}, arena.levels[0].bounds()};
}

double residentStepsPerSecond(sim::Device& device, const support::Levels& arena, uint32_t rollouts,
                              bool small) {
  ThreadPool pool(1);
  solve::ResidentSettings settings;
  settings.explore.rollouts = settings.explore.maxRollouts = rollouts;
  solve::ResidentExplore search(endlessProblem(arena), 1, settings, {pool, &device});
  return searchStepsPerSecond(search, small ? 1 : 8);
}

// Measures a method that learns during the search, with and without the device.
template <class Search, class Settings>
void measureLearned(bench::Report& report, const char* name, sim::Device& device,
                    const support::Levels& arena, bool small) {
  ThreadPool pool(availableThreads());
  const solve::Problem problem = endlessProblem(arena);
  Search there(problem, 1, Settings{}, {pool, &device}), here(problem, 1, Settings{}, pool);
  const int rounds = small ? 1 : 16;
  report.add(name, "stepsPerSecond", searchStepsPerSecond(there, rounds), "1/s");
  report.add(name, "stepsPerSecondOfCpu", searchStepsPerSecond(here, rounds), "1/s");
}

void facts(bench::Report& report, const sim::Device& device, const sim::Kernel& kernel) {
  const auto f = device.facts(kernel);
  if (!f) return;
  report.add(kernel.name, "registers", f->registers, "");
  report.add(kernel.name, "localBytes", f->localBytes, "B");
  report.add(kernel.name, "residentWorldsPerSm", f->blocksPerSm * f->threads, "");
  report.add(kernel.name, "multiprocessors", f->smCount, "");
}

void measure(bench::Report& report, sim::Device& device, bool small) {
  using sim::StepKind;
  for (const StepKind kind : {StepKind::oneLevel, StepKind::manyLevels, StepKind::bodies}) {
    facts(report, device, sim::stepKernel(kind));
  }
  for (const bool bodies : {false, true}) facts(report, device, solve::rolloutKernel(bodies));
  for (const auto step : {solve::ResidentStep::explore, solve::ResidentStep::exploreDynamic}) {
    facts(report, device, solve::residentKernel(step));
  }
  const support::Levels one = support::arenas(1, 100, 600), many = support::arenas(64, 100, 240);
  const std::vector<uint32_t> counts =
      small ? std::vector<uint32_t>{256} : std::vector<uint32_t>{8192, 131072, 1048576};
  for (const uint32_t worlds : counts) {
    const uint32_t ticks = small ? kStep : worlds > 500000 ? 4 * kStep : 16 * kStep;
    const std::string name = std::to_string(worlds) + "worlds";
    const double single = stepsPerSecond(device, one.course, worlds, ticks, kStep);
    report.add(name, "stepsPerSecond", single, "1/s");
    report.add(name, "stepsPerSecondTickByTick",
               stepsPerSecond(device, one.course, worlds, kStep, 1), "1/s");
    const double mixed = stepsPerSecond(device, many.course, worlds, ticks, kStep);
    report.add(name, "stepsPerSecond64Levels", mixed, "1/s");
    report.add(name, "ratioToOneLevel", mixed / single, "");
    if (worlds > kMaxResident) continue;
    report.add(name, "residentStepsPerSecond", residentStepsPerSecond(device, one, worlds, small),
               "1/s");
  }
  using namespace baselines;
  measureLearned<Pbge, PbgeSettings>(report, "pbge", device, one, small);
  measureLearned<Cflge, CflgeSettings>(report, "cflge", device, one, small);
}

}  // namespace

int main(int argc, char** argv) {
  const auto emulate = [](const char* word) { return std::string_view(word) == "--emulate"; };
  char** const end = std::remove_if(argv + 1, argv + argc, emulate);
  const bool small = end != argv + argc;
  bench::Report report(int(end - argv), argv, "gpu");
  ThreadPool pool(availableThreads());
  sim::HostDevice host(pool);
  auto backend = sim::Backend::open(sim::BackendKind::cuda);
  if (!backend && !small) {
    std::fprintf(stderr, "bench_gpu: skipped: %s\n", backend.error().text().c_str());
    return kSkipped;
  }
  measure(report, small ? host : *backend->device(), small);
}
