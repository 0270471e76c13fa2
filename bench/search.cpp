// Measures the search rate of all cores: Go-Explore rounds in box arenas with an unreachable goal.
// It also measures the ratio to the bare simulator with the same rollouts and threads. Both
// alternate in short slices, so that other load affects them equally.
#include <atomic>
#include <ctime>
#include <vector>

#include "base/thread_pool.h"
#include "common/report.h"
#include "sim/simulator.h"
#include "sim/wide_tick.h"
#include "solve/search/methods/go_explore.h"
#include "solve/search/rollouts/rollout.h"
#include "support/level_builder.h"
#include "support/plain_problem.h"

namespace {

using namespace obby;

constexpr uint64_t kSliceSteps = 400'000;
constexpr int kSlices = 12;
constexpr uint32_t kRollouts = 3072, kTaskRollouts = 128, kRolloutTicks = 128;

double processSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// A rollout of the search, to be simulated again without the search.
struct Recorded {
  sim::World start;
  std::vector<sim::Action> actions;
};

// Samples rollouts from kept states, as the search does.
std::vector<Recorded> record(const solve::GoExplore& search, uint64_t slice) {
  std::vector<Recorded> rollouts(kRollouts);
  Random random(2, slice);
  for (uint32_t i = 0; i < kRollouts; ++i) {
    Recorded& r = rollouts[i];
    r.start = search.archive().world(random.below(search.archive().cellCount()));
    sim::World world = r.start;
    solve::runRollout(search.context(), 3, slice * kRollouts + i, world, nullptr, kRolloutTicks,
                      [&](const sim::Action& a, const sim::World&) { r.actions.push_back(a); });
  }
  return rollouts;
}

// Simulates the same ticks and nothing else. Returns their number.
double runRaw(const level::LevelView& level, const std::vector<Recorded>& rollouts,
              ThreadPool& pool) {
  std::atomic<uint64_t> steps{0};
  pool.run(int(kRollouts / kTaskRollouts), [&](int task) {
    const Recorded* const first = rollouts.data() + uint32_t(task) * kTaskRollouts;
    std::vector<sim::World> worlds;
    for (uint32_t i = 0; i < kTaskRollouts; ++i) worlds.push_back(first[i].start);
    std::vector<sim::World*> running;
    std::vector<sim::Action> actions;
    for (uint32_t t = 0; t < kRolloutTicks; ++t) {
      running.clear();
      actions.clear();
      for (uint32_t i = 0; i < kTaskRollouts; ++i) {
        if (t >= first[i].actions.size()) continue;
        running.push_back(&worlds[i]);
        actions.push_back(first[i].actions[t]);
      }
      sim::tickAll(level, running.data(), nullptr, actions.data(), running.size());
      steps += running.size();
    }
  });
  return double(steps);
}

struct Sums {
  double wall = 0, cpu = 0, steps = 0;
};

template <class Work>
void addTo(Sums& sums, Work&& work) {
  const double cpu = processSeconds();
  sums.wall += bench::secondsOf(work);
  sums.cpu += processSeconds() - cpu;
}

void scene(bench::Report& report, const char* name, const level::Level& level, ThreadPool& pool) {
  const solve::Problem problem = support::endlessProblem(level);
  solve::GoExplore search(problem, 1, solve::GoExploreSettings{}, pool);
  Sums raw, found;
  for (int slice = 0; slice < kSlices; ++slice) {
    addTo(found, [&] {
      while (search.statistics().steps < kSliceSteps * uint64_t(slice + 1)) search.round();
    });
    const std::vector<Recorded> rollouts = record(search, uint64_t(slice));
    addTo(raw, [&] { raw.steps += runRaw(level.view(), rollouts, pool); });
  }
  found.steps = double(search.statistics().steps);
  report.add(name, "stepsPerSecond", found.steps / found.wall, "1/s");
  report.add(name, "stepsPerCpuSecond", found.steps / found.cpu, "1/s");
  report.add(name, "busyThreads", found.cpu / found.wall, "");
  report.add(name, "rawBusyThreads", raw.cpu / raw.wall, "");
  report.add(name, "shareOfRaw", (found.steps / found.wall) / (raw.steps / raw.wall), "");
  report.add(name, "cells", search.archive().cellCount(), "");
}

}  // namespace

int main(int argc, char** argv) {
  obby::bench::Report report(argc, argv, "search");
  obby::ThreadPool pool(obby::availableThreads());
  report.add("machine", "threads", pool.size(), "");
  using obby::support::boxArena;
  scene(report, "parts20", boxArena(20, 1).compile(), pool);
  scene(report, "parts100", boxArena(100, 1).compile(), pool);
  scene(report, "parts300", boxArena(300, 1).compile(), pool);
  scene(report, "course100", obby::support::platformCourse(100, 1).compile(), pool);
}
