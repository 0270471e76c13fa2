// Tests the starts of a round's rollouts. Half are drawn by weight, half are the states of lowest
// f.
#include <algorithm>
#include <map>

#include "resident_scenes.h"
#include "solve/search/resident/kernels.h"

namespace obby::solve {
namespace {

// An archive of made-up cells. The kernels of a choice run one index at a time.
class ResidentChoice : public testing::Test {
 protected:
  explicit ResidentChoice(uint32_t cells = 9000) : ranks_(cells), waits_(cells), seen_(cells) {
    Random random(5, 6);
    for (uint32_t c = 0; c < cells; ++c) {
      ranks_[c] = uint64_t(random.below(2000)) << 16 | random.below(9);
      waits_[c] = random.below(5000);
      seen_[c] = random.below(20);
      potentials_.push_back(1 + random.unit());
    }
    a_.archive.ranks = ranks_.data();
    a_.archive.waits = waits_.data();
    a_.archive.seen = seen_.data();
    a_.archive.potentials = potentials_.data();
    a_.archive.cellCount = cells;
    a_.best = 2;
    a_.rules.seed = 1;
    a_.rankCounts = counts_.data();
    a_.weights = tree(cells, sums_[0]);
    a_.rankSums = tree(kRanks, sums_[1]);
    a_.bestCells = tree(cells, sums_[2]);
  }
  static SumTree tree(uint32_t leaves, std::vector<uint64_t>& memory) {
    SumTree t = makeSumTree(nullptr, leaves);
    memory.resize(t.firsts[t.levels]);
    t.sums = memory.data();
    return t;
  }
  static void sumUp(const SumTree& t) {
    for (SumArguments s{t, 1}; s.level < t.levels; ++s.level) {
      for (uint32_t i = 0; i < sumCount(t, s.level); ++i) sumOne(s, i);
    }
  }
  // Returns the number of rollouts that start from each cell, by cell.
  std::map<uint32_t, uint32_t> choose(uint32_t rollouts, uint32_t firstBeam, uint32_t width) {
    a_.firstBeam = firstBeam;
    a_.beamWidth = width;
    std::vector<uint32_t> starts(rollouts);
    a_.starts = starts.data();
    for (uint32_t i = 0; i < sumCount(a_.weights, 0); ++i) weighCells(a_, i);
    sumUp(a_.weights);
    for (uint32_t i = 0; i < sumCount(a_.bestCells, 0); ++i) countRanks(a_, i);
    for (uint32_t i = 0; i < sumCount(a_.rankSums, 0); ++i) sumRanks(a_, i);
    sumUp(a_.rankSums);
    for (uint32_t i = 0; i < sumCount(a_.bestCells, 0); ++i) markBest(a_, i);
    sumUp(a_.bestCells);
    std::map<uint32_t, uint32_t> times;
    for (uint32_t i = 0; i < rollouts; ++i) {
      chooseStart(a_, i);
      ++times[starts[i]];
    }
    return times;
  }
  uint32_t ticksOf(uint32_t cell) const { return uint32_t(ranks_[cell] >> 16) + waits_[cell]; }

  std::vector<uint64_t> ranks_;
  std::vector<uint32_t> waits_, seen_, counts_ = std::vector<uint32_t>(kRanks);
  std::vector<float> potentials_;
  std::vector<uint64_t> sums_[3];
  ResidentArguments a_{};
};

TEST_F(ResidentChoice, TheBeamHasTheCellsOfLowestF) {
  std::vector<uint32_t> sorted;
  for (uint32_t c = 0; c < a_.archive.cellCount; ++c) sorted.push_back(ticksOf(c));
  std::sort(sorted.begin(), sorted.end());
  const uint32_t width = 128, last = sorted[width - 1] / kRankTicks;
  const auto times = choose(8192, 0, width);
  EXPECT_GE(times.size(), width);
  for (uint32_t c = 0; c < a_.archive.cellCount; ++c) {
    EXPECT_EQ(times.count(c) == 1, ticksOf(c) / kRankTicks <= last) << c;
  }
}

TEST_F(ResidentChoice, ABeamWiderThanTheArchiveIsAllOfIt) {
  a_.archive.cellCount = 70;
  a_.weights = tree(70, sums_[0]);
  a_.bestCells = tree(70, sums_[2]);
  EXPECT_EQ(choose(4096, 0, 1000).size(), 70u);
}

TEST_F(ResidentChoice, TheOtherHalfFollowsTheWeights) {
  const uint32_t draws = 400'000;
  const auto times = choose(draws, draws, 1);
  double total = 0, apart = 0;
  for (uint32_t c = 0; c < a_.archive.cellCount; ++c) total += cellWeight(a_, c);
  for (const auto& [cell, count] : times) {
    const double expected = draws * double(cellWeight(a_, cell)) / total;
    apart += (count - expected) * (count - expected) / expected;
  }
  EXPECT_NEAR(apart / a_.archive.cellCount, 1, 0.1);  // chi-squared
}

}  // namespace
}  // namespace obby::solve
