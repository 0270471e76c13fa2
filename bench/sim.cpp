// How fast one core steps worlds: random walkers in box arenas of equal density, full character
// rules, 60 Hz control and 240 Hz physics.
#include <algorithm>
#include <vector>

#include "common/report.h"
#include "sim/simulator.h"
#include "sim/tick.h"
#include "support/level_builder.h"

namespace {

using namespace obby;

constexpr uint32_t kWorlds = 256, kTicks = 2000;

// Holds a random action for 10 to 50 ticks; jumps one time in twenty when it changes.
struct Walker {
  Random random;
  sim::Action action;
  uint32_t left = 0;

  sim::Action next() {
    if (left-- == 0) {
      left = 10 + random.below(40);
      action = {Turns(random.next()), random.below(10) != 0, random.below(20) < 8};
    }
    return action;
  }
};

struct Outcome {
  double stepsPerSecond;
  double grounded;  // share of ticks with a floor
};

Outcome run(const level::Level& level, uint64_t seed) {
  std::vector<sim::World> worlds(kWorlds, sim::makeWorld(level.view(), level.spawns()[0]));
  std::vector<Walker> walkers;
  for (uint32_t i = 0; i < kWorlds; ++i) walkers.push_back({Random(seed, i), {}, 0});
  uint64_t grounded = 0;
  const double seconds = bench::cpuSecondsOf([&] {
    for (uint32_t t = 0; t < kTicks; ++t) {
      for (uint32_t i = 0; i < kWorlds; ++i) {
        sim::tick(worlds[i], level.view(), walkers[i].next());
        grounded += worlds[i].flags & sim::kFloorSensed;
      }
    }
  });
  const double steps = double(kWorlds) * kTicks;
  return {steps / seconds, double(grounded) / steps};
}

template <class Scene>
void scene(bench::Report& report, const char* name, uint32_t boxes, Scene&& build) {
  std::vector<double> rates;
  double grounded = 0;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const level::Level level = build(boxes, seed).compile();
    const Outcome o = run(level, seed);
    rates.push_back(o.stepsPerSecond);
    grounded += o.grounded / 5;
  }
  std::sort(rates.begin(), rates.end());
  report.add(name, "stepsPerSecondPerCore", rates[2], "1/s");
  report.add(name, "groundedShare", grounded, "");
}

}  // namespace

int main(int argc, char** argv) {
  obby::bench::Report report(argc, argv, "sim");
  scene(report, "static20", 20, support::boxArena);
  scene(report, "static100", 100, support::boxArena);
  scene(report, "static300", 300, support::boxArena);
  scene(report, "course100", 100, support::platformCourse);
  report.add("world", "bytes", sizeof(obby::sim::World), "B");
}
