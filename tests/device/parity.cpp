// Compares the GPU with the CPU bit by bit: the golden scenes' committed hashes, and other batches
// world by world. Exits with 77 (skipped) if there is no GPU. With --emulate the CPU stands in for
// the GPU, which tests everything except the launches.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "baselines/cflge.h"
#include "baselines/pbge.h"
#include "golden/hashes.h"
#include "sim/backend.h"
#include "sim/host_device.h"
#include "solve/search/methods/go_explore.h"
#include "solve/search/resident/resident_explore.h"
#include "support/courses.h"
#include "support/hasty.h"
#include "support/plain_problem.h"
#include "train/device/device_engine.h"
#include "train/gaps.h"

namespace {

using namespace obby;

constexpr int kSkipped = 77;

class Parity {
 public:
  Parity(sim::Device& device, ThreadPool& pool) : device_(device), pool_(pool) {}

  void golden() {
    for (const golden::Scene& scene : golden::kScenes) {
      const level::Level level = scene.build().compile();
      const sim::Course course = sim::courseOf(level.view(), level.spawns()[0]);
      auto batch = made(sim::makeKernelBatch(course, golden::kWorlds, device_), scene.name);
      if (!batch ||
          !done(batch->step(golden::kTicks, sim::Actions::walker(golden::kSeed)), scene.name))
        continue;
      const auto hash = batch->hash();
      if (!done(hash, scene.name)) continue;
      say(*hash == scene.hash, scene.name, "committed hash");
    }
  }

  // Steps the course on the CPU and the GPU, and compares every world.
  void compare(const char* name, const sim::Course& course, uint32_t worlds, uint32_t ticks,
               const sim::Actions& actions) {
    auto cpu = made(sim::makeCpuBatch(course, worlds, pool_), name);
    auto gpu = made(sim::makeKernelBatch(course, worlds, device_), name);
    if (!cpu || !gpu || !done(cpu->step(ticks, actions), name) ||
        !done(gpu->step(ticks, actions), name))
      return;
    const auto expected = cpu->worlds(), found = gpu->worlds();
    if (!done(found, name)) return;
    uint32_t different = 0, first = 0;
    for (uint32_t i = worlds; i-- > 0;) {
      if (stateHash((*expected)[i]) == stateHash((*found)[i])) continue;
      ++different;
      first = i;
    }
    const std::string what =
        std::to_string(worlds) + " worlds, " + std::to_string(ticks) + " ticks";
    say(different == 0, name, what.c_str());
    if (different != 0) std::printf("        %u differ, the first is world %u\n", different, first);
  }

  bool passed() const { return failures_ == 0; }

  void say(bool right, const char* name, const char* what) {
    std::printf("%-6s  %-28s %s\n", right ? "ok" : "WRONG", name, what);
    if (!right) ++failures_;
  }

 private:
  template <class T>
  bool done(const Result<T>& result, const char* name) {
    if (!result) say(false, name, result.error().text().c_str());
    return bool(result);
  }
  std::unique_ptr<sim::Batch> made(Result<std::unique_ptr<sim::Batch>> batch, const char* name) {
    return done(batch, name) ? *std::move(batch) : nullptr;
  }

  sim::Device& device_;
  ThreadPool& pool_;
  int failures_ = 0;
};

// Compares worlds that play a random table of actions, and worlds with one plan each.
void compareSources(Parity& parity, uint32_t worlds, uint32_t ticks) {
  const level::Level level = support::boxArena(100, 6).compile();
  const sim::Course course = sim::courseOf(level.view(), level.spawns()[0]);
  Random random(17, worlds);
  const auto draw = [&] {
    const Turns heading = Turns(random.next());
    return sim::Action{heading, random.below(8) != 0, random.below(4) == 0};
  };
  std::vector<sim::Action> table;
  for (size_t i = 0; i < size_t(ticks) * worlds; ++i) table.push_back(draw());
  parity.compare("actions from a table", course, worlds, ticks, sim::Actions::tabulated(table));
  std::vector<sim::ActionRun> runs;
  std::vector<uint32_t> firsts{0};
  for (uint32_t i = 0; i < worlds; ++i) {
    for (uint32_t k = random.below(20); k > 0; --k) runs.push_back({draw(), random.below(30)});
    firsts.push_back(uint32_t(runs.size()));
  }
  parity.compare("actions from plans", course, worlds, ticks, sim::Actions::plans(runs, firsts));
}

void compareWalkers(Parity& parity, uint32_t worlds, uint32_t ticks) {
  for (const uint64_t seed : {1, 2, 3}) {
    const level::Level arena = support::boxArena(100, seed).compile();
    const level::Level moving = support::movingArena(60, 14, seed).compile();
    const auto walk = sim::Actions::walker(seed);
    parity.compare("arena", sim::courseOf(arena.view(), arena.spawns()[0]), worlds, ticks, walk);
    parity.compare("moving arena", sim::courseOf(moving.view(), moving.spawns()[0]), worlds, ticks,
                   walk);
  }
  const support::Levels all = support::everyKind();
  parity.compare("levels of every kind", all.course, worlds, ticks, sim::Actions::walker(4));
  support::Levels ruled = support::everyKind();
  support::addRules(ruled);
  parity.compare("rules of every kind", ruled.course, worlds, ticks, sim::Actions::walker(6));
}

bool sameCells(const solve::Archive& a, const solve::Archive& b) {
  bool same = a.cellCount() == b.cellCount();
  for (uint32_t c = 0; same && c < a.cellCount(); ++c) {
    same = stateHash(a.world(c), a.bodies(c)) == stateHash(b.world(c), b.bodies(c));
  }
  return same;
}

// Compares every cell of a search whose rollouts run on threads with the same search on the device.
void compareSearch(Parity& parity, sim::Device& device, ThreadPool& pool, int rounds) {
  const level::Level level = support::movingArena(60, 10, 5).compile();
  const solve::Problem problem = support::endlessProblem(level);
  solve::GoExplore threads(problem, 1, {}, pool), kernel(problem, 1, {}, {pool, &device});
  for (int round = 0; round < rounds; ++round) {
    threads.round();
    kernel.round();
  }
  const bool same = threads.archive().seen() == kernel.archive().seen() &&
                    sameCells(threads.archive(), kernel.archive());
  const Status& status = kernel.deviceStatus();
  const std::string cells = std::to_string(threads.archive().cellCount()) + " cells";
  parity.say(bool(status) && same, "search",
             status ? cells.c_str() : status.error().text().c_str());
}

// Compares a search whose players and networks run on the device with the same search on the CPU.
template <class Search, class Settings>
void compareLearned(Parity& parity, const char* name, const level::Level& level,
                    sim::Device& device, ThreadPool& pool, int rounds) {
  const solve::Problem problem = support::endlessProblem(level);
  const Settings settings = support::hasty(Settings{});
  Search here(problem, 1, settings, pool), there(problem, 1, settings, {pool, &device});
  for (int round = 0; round < rounds; ++round) {
    here.round();
    there.round();
  }
  const bool same = here.cellCount() > 1 && here.statistics().steps == there.statistics().steps &&
                    here.returns().reached == there.returns().reached &&
                    sameCells(here.archive(), there.archive());
  const Status& status = there.deviceStatus();
  const std::string cells = std::to_string(here.cellCount()) + " cells";
  parity.say(bool(status) && same, name, status ? cells.c_str() : status.error().text().c_str());
}

// Compares the search that runs on the device alone with the same kernels run on the CPU.
void compareResident(Parity& parity, const char* name, const level::Level& level,
                     sim::Device& device, ThreadPool& pool, int rounds, uint32_t rollouts) {
  const solve::Problem problem = support::endlessProblem(level);
  solve::ResidentSettings settings;
  settings.explore.rollouts = rollouts;
  solve::ResidentExplore host(problem, 1, settings, pool);
  solve::ResidentExplore there(problem, 1, settings, {pool, &device});
  for (int round = 0; round < rounds; ++round) {
    host.round();
    there.round();
  }
  const auto expected = host.cells(), found = there.cells();
  bool same = expected.size() == found.size() && host.singletons() == there.singletons() &&
              host.statistics().steps == there.statistics().steps;
  for (size_t c = 0; same && c < expected.size(); ++c) {
    same = stateHash(expected[c].world, expected[c].bodies) ==
               stateHash(found[c].world, found[c].bodies) &&
           expected[c].node == found[c].node && expected[c].seen == found[c].seen;
  }
  const Status& status = there.deviceStatus();
  const std::string cells = std::to_string(expected.size()) + " cells";
  parity.say(bool(status) && same, name, status ? cells.c_str() : status.error().text().c_str());
}

// Compares training: its kernels and the learned network must match the CPU bit by bit.
void compareLearning(Parity& parity, const char* name, bool bodies, sim::Device& device,
                     ThreadPool& pool, uint32_t envGroups) {
  const train::Gaps gaps(bodies);
  train::TrainerSettings settings = train::small();
  settings.envGroups = envGroups;
  sim::HostDevice host(pool);
  std::vector<float> numbers[2];
  std::vector<uint64_t> worlds[2];
  Status status;
  for (int i = 0; i < 2 && status; ++i) {
    sim::Device& where = i == 0 ? host : device;
    auto made = train::Trainer::make(
        settings, train::makeDeviceEngine(settings, gaps, where, pool, train::alone()),
        train::alone());
    status = made ? Status() : Status(made.error());
    for (int n = 0; n < 3 && status; ++n) {
      const auto iteration = (*made)->iterate();
      if (!iteration) status = iteration.error();
    }
    if (!status) break;
    const auto state = (*made)->state();
    status = state ? Status() : Status(state.error());
    if (!status) break;
    numbers[i] = (*made)->network().numbers();
    for (const train::EnvGroupState& envGroup : state->envGroups) {
      for (const train::PlaceState& place : envGroup.places) {
        for (const train::Player& p : place.players) worlds[i].push_back(stateHash(p.world));
      }
    }
  }
  const std::string what = std::to_string(worlds[0].size()) + " worlds, and the network";
  parity.say(bool(status) && worlds[0] == worlds[1] && numbers[0] == numbers[1], name,
             status ? what.c_str() : status.error().text().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string option = argc == 2 ? argv[1] : "";
  if (argc > 2 || (argc == 2 && option != "--emulate" && option != "--quick")) {
    std::fputs("usage: gpu_parity [--quick | --emulate]\n", stderr);
    return 2;
  }
  ThreadPool pool(availableThreads());
  sim::HostDevice host(pool);
  auto backend = sim::Backend::open(sim::BackendKind::cuda);
  if (!backend && option != "--emulate") {
    std::printf("no device: skipped: %s\n", backend.error().text().c_str());
    return kSkipped;
  }
  sim::Device& device = option == "--emulate" ? host : *backend->device();
  std::printf("        %s against the CPU's lanes\n", device.name().c_str());
  Parity parity(device, pool);
  // Tools that check every memory access need small runs.
  const uint32_t worlds = option.empty() ? 20000 : 300;
  if (option != "--quick") parity.golden();
  compareWalkers(parity, worlds, 300);
  compareSources(parity, worlds, 120);
  compareSearch(parity, device, pool, option == "--quick" ? 4 : 40);
  const int rounds = option.empty() ? 40 : 4;
  const uint32_t rollouts = option.empty() ? 1024 : 64;
  const level::Level bodies = golden::dynamicBodies().compile();
  compareResident(parity, "resident search", support::movingArena(60, 10, 5).compile(), device,
                  pool, rounds, rollouts);
  compareResident(parity, "resident, loose bodies", bodies, device, pool, rounds / 4, rollouts);
  using namespace baselines;
  const level::Level moving = support::movingArena(40, 8, 3).compile();
  compareLearned<Pbge, PbgeSettings>(parity, "pbge", moving, device, pool, rounds);
  compareLearned<Cflge, CflgeSettings>(parity, "cflge", moving, device, pool, 2 * rounds);
  compareLearned<Pbge, PbgeSettings>(parity, "pbge, loose bodies", bodies, device, pool, 2);
  compareLearned<Cflge, CflgeSettings>(parity, "cflge, loose bodies", bodies, device, pool, 2);
  const uint32_t envGroups = option.empty() ? 16 : 1;
  compareLearning(parity, "learning", false, device, pool, envGroups);
  compareLearning(parity, "learning, loose bodies", true, device, pool, envGroups);
  return parity.passed() ? 0 : 1;
}
