// How fast one core steps worlds: random walkers in box arenas of equal density, full character
// rules, 60 Hz control and 240 Hz physics.
#include <algorithm>
#include <vector>

#include "common/report.h"
#include "sim/simulator.h"
#include "sim/tick.h"
#include "sim/wide_tick.h"
#include "support/level_builder.h"

namespace {

using namespace obby;

constexpr uint32_t kWorlds = 256, kTicks = 1000;

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
  double stepsPerSecond, singlyPerSecond;  // in lanes; by the scalar tick
  double grounded;                         // share of ticks with a floor
  sim::WideCounts counts;
};

// Worlds and their walkers; actions are drawn outside the time taken.
struct Crowd {
  std::vector<sim::World> worlds;
  std::vector<sim::World*> pointers;
  std::vector<Walker> walkers;
  std::vector<sim::Action> actions;

  Crowd(const level::Level& level, uint64_t seed)
      : worlds(kWorlds, sim::makeWorld(level.view(), level.spawns()[0])), actions(kWorlds) {
    for (sim::World& w : worlds) pointers.push_back(&w);
    for (uint32_t i = 0; i < kWorlds; ++i) walkers.push_back({Random(seed, i), {}, 0});
  }
  void decide() {
    for (uint32_t i = 0; i < kWorlds; ++i) actions[i] = walkers[i].next();
  }
};

// Both ways take turns, so that what else the machine does hits them alike.
Outcome run(const level::Level& level, uint64_t seed) {
  Crowd wide(level, seed), single(level, seed);
  Outcome o{};
  double wideSeconds = 0, singleSeconds = 0;
  for (uint32_t t = 0; t < kTicks; ++t) {
    wide.decide();
    single.decide();
    wideSeconds += bench::cpuSecondsOf([&] {
      sim::tickAll(level.view(), wide.pointers.data(), wide.actions.data(), kWorlds, &o.counts);
    });
    singleSeconds += bench::cpuSecondsOf([&] {
      for (uint32_t i = 0; i < kWorlds; ++i) {
        sim::tick(single.worlds[i], level.view(), single.actions[i]);
      }
    });
    for (const sim::World& w : wide.worlds) o.grounded += w.flags & sim::kFloorSensed;
  }
  const double steps = double(kWorlds) * kTicks;
  o.stepsPerSecond = steps / wideSeconds;
  o.singlyPerSecond = steps / singleSeconds;
  o.grounded /= steps;
  return o;
}

template <class Scene>
void scene(bench::Report& report, const char* name, uint32_t boxes, Scene&& build) {
  std::vector<double> rates, singly;
  double grounded = 0, contact = 0, fallback = 0;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const level::Level level = build(boxes, seed).compile();
    const Outcome o = run(level, seed);
    rates.push_back(o.stepsPerSecond);
    singly.push_back(o.singlyPerSecond);
    grounded += o.grounded / 5;
    contact += double(o.counts.contact) / double(o.counts.ticks) / 5;
    fallback += double(o.counts.single) / double(o.counts.ticks) / 5;
  }
  std::sort(rates.begin(), rates.end());
  std::sort(singly.begin(), singly.end());
  report.add(name, "stepsPerSecondPerCore", rates[2], "1/s");
  report.add(name, "scalarStepsPerSecondPerCore", singly[2], "1/s");
  report.add(name, "contactShare", contact, "");
  report.add(name, "scalarShare", fallback, "");
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
