// Measures an archive of ten million cells: its size, the rate of inserting and finding cells, and
// the time to select a round's cells. Keys and worlds are synthetic. Visits and improvements are
// spread over all cells, as in a search.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "base/thread_pool.h"
#include "common/report.h"
#include "sim/simulator.h"
#include "solve/search/archive/archive.h"
#include "solve/search/archive/cell.h"
#include "solve/search/selectors/beam_selector.h"
#include "solve/search/selectors/selection.h"
#include "support/level_builder.h"
#include "support/plain_problem.h"

namespace {

using namespace obby;

constexpr uint32_t kBetterEvery = 3;  // every n-th cell is reached again by a shorter trajectory
constexpr uint32_t kFinds = 2'000'000;
constexpr uint32_t kRounds = 30, kRollouts = 512;
constexpr uint32_t kVisits = 6000, kArrivals = 300;  // per round

// Returns the resident set in bytes.
double residentBytes() {
  long all = 0, resident = 0;
  FILE* const file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  if (std::fscanf(file, "%ld %ld", &all, &resident) != 2) resident = 0;
  std::fclose(file);
  return double(resident) * double(sysconf(_SC_PAGESIZE));
}

double peakBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);
}

uint64_t keyOf(uint32_t cell) { return solve::mixBits(uint64_t(cell) + 1); }

sim::World worldOf(uint32_t cell) {
  Random random(1, cell);
  sim::World w{};
  w.position = {1000 * random.unit(), 100 * random.unit(), 1000 * random.unit()};
  w.tick = 1000 + random.below(10000);
  return w;
}

void offer(solve::Archive& archive, uint32_t cell, const sim::World& world) {
  const float potential = 1 + world.position.x * 0.004f;
  archive.offer(keyOf(cell), world, {cell, cell / 2, 40}, potential);
}

void offerBetter(solve::Archive& archive, uint32_t cell) {
  sim::World world = archive.world(cell);
  world.tick -= world.tick > 0 ? 1 : 0;
  offer(archive, cell, world);
}

void fill(solve::Archive& archive, uint32_t cells) {
  for (uint32_t cell = archive.cellCount(); cell < cells; ++cell) {
    offer(archive, cell, worldOf(cell));
    if (cell % kBetterEvery == 0) offerBetter(archive, cell / 2);
  }
}

// Returns the rate of finds. Half of the keys are in the archive.
double findsPerSecond(const solve::Archive& archive) {
  Random random(2, archive.cellCount());
  std::vector<uint64_t> keys(kFinds);
  for (uint64_t& key : keys) key = keyOf(random.below(2 * archive.cellCount()));
  uint64_t found = 0;
  const double seconds = bench::secondsOf([&] {
    for (const uint64_t key : keys) found += archive.find(key) != solve::kNone;
  });
  if (found == 0) std::abort();
  return kFinds / seconds;
}

// Applies a round's visits and improvements.
void visit(solve::Archive& archive, Random& random) {
  for (uint32_t i = 0; i < kVisits; ++i) archive.countSeen(random.below(archive.cellCount()));
  for (uint32_t i = 0; i < kArrivals; ++i) offerBetter(archive, random.below(archive.cellCount()));
}

class Bench {
 public:
  Bench(bench::Report& report, const solve::Problem& problem)
      : report_(report),
        archive_(10'000'000),
        selector_(0.1f),
        beam_(problem),
        pool_(availableThreads()) {}

  void run(const std::string& name, uint32_t cells) {
    const uint32_t before = archive_.cellCount();
    const double seconds = bench::secondsOf([&] { fill(archive_, cells); });
    report_.add(name, "insertsPerSecond", (cells - before) / seconds, "1/s");
    report_.add(name, "findsPerSecond", findsPerSecond(archive_), "1/s");
    report_.add(name, "selectorMilliseconds", chooseMilliseconds(selector_), "ms");
    report_.add(name, "beamMilliseconds", chooseMilliseconds(beam_), "ms");
    report_.add(name, "bytesPerCell", residentBytes() / cells, "B");
    report_.add(name, "peakBytesPerCell", peakBytes() / cells, "B");
  }

 private:
  // Selects half of a round's cells, as under `auto`.
  double chooseMilliseconds(solve::Selector& selector) {
    std::vector<solve::Choice> choices(kRollouts / 2, {0, 40});
    double seconds = 0;
    for (uint32_t round = 0; round <= kRounds; ++round) {
      Random random(3, round);
      const double taken =
          bench::secondsOf([&] { selector.choose(archive_, pool_, random, choices); });
      if (round > 0) seconds += taken;  // the first round reads everything
      visit(archive_, random);
    }
    return 1000 * seconds / kRounds;
  }

  bench::Report& report_;
  solve::Archive archive_;
  solve::CellSelector selector_;
  solve::BeamSelector beam_;
  ThreadPool pool_;
};

}  // namespace

int main(int argc, char** argv) {
  bench::Report report(argc, argv, "archive");
  const level::Level level = support::boxArena(20, 1).compile();
  const solve::Problem problem = support::endlessProblem(level);
  Bench bench(report, problem);
  bench.run("million", 1'000'000);
  bench.run("tenMillion", 10'000'000);
}
