// How fast all cores search: Go-Explore rounds in box arenas with a goal out of reach, and the
// share of what the bare simulator does on the same threads from the same states. The two take
// turns in short slices, so that what else the machine does hits both alike.
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
constexpr uint32_t kTasks = 256, kWorldsPerTask = 12, kRawTicks = 128;

double processSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Random actions from the states that the search has kept, one world after another, nothing else.
void runRaw(const level::LevelView& level, const solve::Archive& archive, ThreadPool& pool,
            uint64_t slice) {
  pool.run(int(kTasks), [&](int task) {
    for (uint32_t i = 0; i < kWorldsPerTask; ++i) {
      Random random(1, (slice * kTasks + uint64_t(task)) * kWorldsPerTask + i);
      sim::World world = archive.world(random.below(archive.cellCount()));
      solve::RandomMacro macro{{}, 0};
      for (uint32_t t = 0; t < kRawTicks; ++t) {
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

void scene(bench::Report& report, const char* name, const level::Level& level, ThreadPool& pool) {
  level::QueryView query{};
  query.goal = {{{0, 500, 0}, {}}, {2, 2, 2}};
  query.maxJumps = -1;
  const solve::Problem problem{level.view(), query, sim::makeWorld(level.view(), level.spawns()[0]),
                               level.bounds(), level.hasMotion()};
  solve::GoExplore search(problem, 1, solve::GoExploreSettings{}, pool);
  Sums raw, found;
  for (int slice = 0; slice < kSlices; ++slice) {
    addTo(found, [&] {
      while (search.statistics().steps < kSliceSteps * uint64_t(slice + 1)) search.round();
    });
    addTo(raw, [&] { runRaw(level.view(), search.archive(), pool, uint64_t(slice)); });
    raw.steps += double(kTasks) * kWorldsPerTask * kRawTicks;
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
  using obby::support::boxArena;
  scene(report, "parts20", boxArena(20, 1).compile(), pool);
  scene(report, "parts100", boxArena(100, 1).compile(), pool);
  scene(report, "parts300", boxArena(300, 1).compile(), pool);
  scene(report, "course100", obby::support::platformCourse(100, 1).compile(), pool);
}
