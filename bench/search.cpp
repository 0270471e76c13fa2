// How fast all cores search: Go-Explore rounds in box arenas with a goal out of reach, and the
// share of what the bare simulator does on the same threads in the same scene. The two take turns
// in short slices, so that what else the machine does hits both alike.
#include <ctime>
#include <vector>

#include "base/thread_pool.h"
#include "common/report.h"
#include "sim/simulator.h"
#include "sim/tick.h"
#include "solve/go_explore.h"
#include "solve/macro_random.h"
#include "support/level_builder.h"

namespace {

using namespace obby;

constexpr uint64_t kSliceSteps = 400'000;
constexpr int kSlices = 12;
constexpr uint32_t kTasks = 32, kWorldsPerTask = 8;
constexpr level::StartPose kStart{{0, 12, 0}, 0, 0};

double processSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Random actions in one world after another, nothing else.
void runRaw(const level::LevelView& level, ThreadPool& pool, uint64_t stream) {
  const uint32_t ticks = uint32_t(kSliceSteps / (kTasks * kWorldsPerTask));
  pool.run(int(kTasks), [&](int task) {
    for (uint32_t i = 0; i < kWorldsPerTask; ++i) {
      Random random(1, (stream * kTasks + uint64_t(task)) * kWorldsPerTask + i);
      sim::World world = sim::makeWorld(level, kStart);
      solve::RandomMacro macro{{}, 0};
      for (uint32_t t = 0; t < ticks; ++t) {
        if (macro.ticks-- == 0) macro = solve::drawRandomMacro(random);
        sim::tick(world, level, macro.action);
      }
    }
  });
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

void scene(bench::Report& report, const char* name, uint32_t boxes, ThreadPool& pool) {
  const level::Level level = support::boxArena(boxes, 1).compile();
  level::QueryView query{};
  query.goal = {{{0, 500, 0}, {}}, {2, 2, 2}};
  query.maxJumps = -1;
  const solve::Problem problem{level.view(),
                               query,
                               sim::makeWorld(level.view(), kStart),
                               level.bounds(),
                               level.hasMotion(),
                               level.motionPeriod()};
  solve::GoExplore search(problem, 1, solve::GoExploreSettings{}, pool);
  Sums raw, found;
  for (int slice = 0; slice < kSlices; ++slice) {
    addTo(raw, [&] { runRaw(level.view(), pool, uint64_t(slice)); });
    raw.steps += double(kSliceSteps);
    addTo(found, [&] {
      while (search.statistics().steps < kSliceSteps * uint64_t(slice + 1)) search.round();
    });
  }
  found.steps = double(search.statistics().steps);
  report.add(name, "stepsPerSecond", found.steps / found.wall, "1/s");
  report.add(name, "stepsPerCpuSecond", found.steps / found.cpu, "1/s");
  report.add(name, "shareOfRaw", (found.steps / found.wall) / (raw.steps / raw.wall), "");
  report.add(name, "cells", search.archive().cellCount(), "");
}

}  // namespace

int main(int argc, char** argv) {
  obby::bench::Report report(argc, argv, "search");
  obby::ThreadPool pool(obby::availableThreads());
  report.add("machine", "threads", pool.size(), "");
  scene(report, "parts20", 20, pool);
  scene(report, "parts100", 100, pool);
  scene(report, "parts300", 300, pool);
}
