// Measures how fast one core steps worlds: random walkers in box arenas of equal density, with full
// character rules, 60 Hz control and 240 Hz physics.
#include <algorithm>
#include <cstdlib>
#include <vector>

#if defined(OBBY_HAS_BULLET)
#include "common/bullet_arena.h"
#endif
#include "common/instructions.h"
#include "common/report.h"
#include "sim/batch.h"
#include "sim/simulator.h"
#include "sim/tick.h"
#include "sim/wide_tick.h"
#include "support/courses.h"
#include "support/level_builder.h"
#include "support/walker.h"

namespace {

using namespace obby;
using support::Walker;

constexpr uint32_t kWorlds = 256, kTicks = 1000, kSeeds = 5;
constexpr uint32_t kSettling = 240;  // ticks until dynamic bodies rest

struct Outcome {
  double stepsPerSecond, singlyPerSecond;  // steps per second with lanes, and with the scalar tick
  double grounded;                         // share of ticks with a floor
  double awake;                            // share of ticks with an awake dynamic body
  double instructions;                     // per step in lanes; 0: no counter
  sim::WideCounts counts;
};

// Worlds and their walkers. The actions are drawn outside the measured time.
struct Envs {
  std::vector<sim::World> worlds;
  std::vector<sim::World*> pointers;
  std::vector<sim::RigidBody> bodies;
  std::vector<sim::RigidBody*> bodyPointers;
  std::vector<Walker> walkers;
  std::vector<sim::Action> actions;

  Envs(const level::Level& level, uint64_t seed)
      : worlds(kWorlds, sim::makeWorld(level.view(), level.spawns()[0])), actions(kWorlds) {
    for (sim::World& w : worlds) pointers.push_back(&w);
    const std::vector<sim::RigidBody> start = sim::makeBodies(level.view());
    for (uint32_t i = 0; i < kWorlds; ++i) bodies.insert(bodies.end(), start.begin(), start.end());
    for (uint32_t i = 0; i < kWorlds; ++i) bodyPointers.push_back(bodies.data() + i * start.size());
    for (uint32_t i = 0; i < kWorlds; ++i) walkers.push_back({Random(seed, i), {}, 0});
  }
  void decide() {
    for (uint32_t i = 0; i < kWorlds; ++i) actions[i] = walkers[i].next();
  }
};

// Measures both variants in alternation, so that other load affects them equally.
Outcome run(const level::Level& level, uint64_t seed) {
  Envs wide(level, seed), single(level, seed);
  for (uint32_t t = 0; t < kSettling && level.view().bodyCount != 0; ++t) {
    for (Envs* envs : {&wide, &single}) {
      sim::tickAll(level.view(), envs->pointers.data(), envs->bodyPointers.data(),
                   envs->actions.data(), kWorlds);
    }
  }
  Outcome o{};
  double wideSeconds = 0, singleSeconds = 0;
  const bench::InstructionCounter counter;
  for (uint32_t t = 0; t < kTicks; ++t) {
    wide.decide();
    single.decide();
    const uint64_t before = counter.count().value_or(0);
    wideSeconds += bench::cpuSecondsOf([&] {
      sim::tickAll(level.view(), wide.pointers.data(), wide.bodyPointers.data(),
                   wide.actions.data(), kWorlds, &o.counts);
    });
    o.instructions += double(counter.count().value_or(0) - before);
    singleSeconds += bench::cpuSecondsOf([&] {
      for (uint32_t i = 0; i < kWorlds; ++i) {
        sim::tick(single.worlds[i], single.bodyPointers[i], level.view(), single.actions[i]);
      }
    });
    for (const sim::World& w : wide.worlds) {
      o.grounded += w.flags & sim::kFloorSensed;
      o.awake += w.flags & sim::kBodyAwake ? 1 : 0;
    }
  }
  const double steps = double(kWorlds) * kTicks;
  o.stepsPerSecond = steps / wideSeconds;
  o.singlyPerSecond = steps / singleSeconds;
  o.grounded /= steps;
  o.awake /= steps;
  o.instructions /= steps;
  return o;
}

#if defined(OBBY_HAS_BULLET)
constexpr uint32_t kBulletWorlds = 64, kBulletTicks = 200;

// Returns Bullet's steps per second in the same scene with the same walkers.
double bulletPerSecond(const level::Level& level, uint64_t seed) {
  std::vector<bench::BulletWorld> worlds;
  std::vector<Walker> walkers;
  for (uint32_t i = 0; i < kBulletWorlds; ++i) {
    worlds.emplace_back(level.view(), level.spawns()[0].feet);
    walkers.push_back({Random(seed, i), {}, 0});
  }
  const double seconds = bench::cpuSecondsOf([&] {
    for (uint32_t t = 0; t < kBulletTicks; ++t) {
      for (uint32_t i = 0; i < kBulletWorlds; ++i) worlds[i].step(walkers[i].next());
    }
  });
  return kBulletWorlds * kBulletTicks / seconds;
}
#endif

struct Scene {
  const char* name;
  uint32_t parts;
  support::LevelBuilder (*build)(uint32_t parts, uint64_t seed);
  bool bullet;  // compare with Bullet
};

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Measures the median over five random scenes. Returns the steps per second.
double measure(bench::Report& report, const Scene& scene) {
  std::vector<double> rates, singly, bullet;
  double grounded = 0, contact = 0, fallback = 0, awake = 0, instructions = 0;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const level::Level level = scene.build(scene.parts, seed).compile();
    const Outcome o = run(level, seed);
    rates.push_back(o.stepsPerSecond);
    singly.push_back(o.singlyPerSecond);
    grounded += o.grounded / kSeeds;
    awake += o.awake / kSeeds;
    instructions += o.instructions / kSeeds;
    contact += double(o.counts.contact) / double(o.counts.ticks) / kSeeds;
    fallback += double(o.counts.single) / double(o.counts.ticks) / kSeeds;
#if defined(OBBY_HAS_BULLET)
    if (scene.bullet) bullet.push_back(bulletPerSecond(level, seed));
#endif
  }
  const double rate = medianOf(rates);
  report.add(scene.name, "stepsPerSecondPerCore", rate, "1/s");
  report.add(scene.name, "scalarStepsPerSecondPerCore", medianOf(singly), "1/s");
  if (!bullet.empty()) {
    report.add(scene.name, "bulletStepsPerSecondPerCore", medianOf(bullet), "1/s");
    report.add(scene.name, "ratioToBullet", rate / medianOf(bullet), "");
  }
  report.add(scene.name, "contactShare", contact, "");
  report.add(scene.name, "scalarShare", fallback, "");
  report.add(scene.name, "groundedShare", grounded, "");
  if (instructions > 0) report.add(scene.name, "instructionsPerStep", instructions, "");
  if (awake > 0) report.add(scene.name, "looseAwakeShare", awake, "");
  return rate;
}

// Measures batches of worlds in one level, and in 64 levels with a new level after each episode, as
// in training. Both alternate. The single levels are among the 64.
void levels(bench::Report& report) {
  constexpr uint32_t kLevels = 64, kEnvs = 4096, kStep = 64, kRounds = 12;
  ThreadPool pool(1);
  const support::Levels all = support::arenas(kLevels, 100, 240);
  const auto many = *sim::makeCpuBatch(all.course, kEnvs, pool);
  double manySeconds = 0, oneSeconds = 0;
  const auto timed = [](sim::Batch& batch) {
    return bench::cpuSecondsOf([&] {
      if (!batch.step(kStep, sim::Actions::walker(1))) std::abort();
    });
  };
  for (uint32_t round = 0; round < kRounds; ++round) {
    sim::Course course = all.course;
    course.queue = {round * (kLevels / kRounds)};
    const auto one = *sim::makeCpuBatch(course, kEnvs, pool);
    for (uint32_t i = 0; i < 10; ++i) {
      oneSeconds += timed(*one);
      manySeconds += timed(*many);
    }
  }
  const double steps = 10.0 * kRounds * kStep * kEnvs;
  report.add("oneLevel", "stepsPerSecondPerCore", steps / oneSeconds, "1/s");
  report.add("manyLevels", "stepsPerSecondPerCore", steps / manySeconds, "1/s");
  report.add("manyLevels", "ratioToOneLevel", oneSeconds / manySeconds, "");
}

// Measures snapshots, which are plain copies: worlds are copied to an archive in another order and
// back.
void snapshots(bench::Report& report) {
  constexpr uint32_t kKept = 4096, kRounds = 200;
  const level::Level level = support::boxArena(20, 1).compile();
  std::vector<sim::World> worlds(kKept, sim::makeWorld(level.view(), level.spawns()[0]));
  std::vector<sim::World> archive(kKept);
  const double seconds = bench::cpuSecondsOf([&] {
    for (uint32_t round = 0; round < kRounds; ++round) {
      for (uint32_t i = 0; i < kKept; ++i) archive[(i * 1663 + round) % kKept] = worlds[i];
      for (uint32_t i = 0; i < kKept; ++i) worlds[i] = archive[(i * 769 + round) % kKept];
    }
  });
  report.add("world", "saveAndRestore", 1e9 * seconds / (double(kKept) * kRounds), "ns");
  report.add("world", "bytes", sizeof(sim::World), "B");
}

}  // namespace

int main(int argc, char** argv) {
  obby::bench::Report report(argc, argv, "sim");
  using obby::support::boxArena;
  const double few = measure(report, {"static20", 20, boxArena, false});
  const double hundred = measure(report, {"static100", 100, boxArena, true});
  measure(report, {"static300", 300, boxArena, false});
  const double many = measure(report, {"static3000", 3000, boxArena, false});
  // Cost of a step relative to 20 parts, at equal density.
  report.add("growth", "cost100Over20", few / hundred, "");
  report.add("growth", "cost3000Over20", few / many, "");
  measure(report,
          {"moving8", 100,
           [](uint32_t parts, uint64_t seed) { return obby::support::movingArena(parts, 8, seed); },
           false});
  measure(report,
          {"moving8dynamic4asleep", 4,
           [](uint32_t n, uint64_t seed) { return support::bodyArena(n, false, seed); }, false});
  measure(report,
          {"moving8dynamic4awake", 4,
           [](uint32_t n, uint64_t seed) { return support::bodyArena(n, true, seed); }, false});
  measure(report, {"course100", 100, obby::support::platformCourse, false});
  levels(report);
  snapshots(report);
}
