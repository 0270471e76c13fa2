// The winner of each cell among candidates made by hand: fewer ticks, then fewer jumps, then the
// earlier candidate.
#include "resident_scenes.h"

namespace obby::solve {
namespace {

struct Visit {
  uint64_t key;
  uint32_t tick;
  uint16_t jumps;
  float mark;  // identifies a world
};

class ResidentMerge : public testing::Test {
 protected:
  // Merges one round of trajectories with these visits.
  RoundFindings merge(const std::vector<std::vector<Visit>>& trajectories) {
    PlayedStarts played;
    played.capacity = 4;
    for (const auto& visits : trajectories) {
      PlayedStart trajectory{scene_.asked.problem().start, {}, uint32_t(visits.size())};
      played.trajectories.push_back(trajectory);
      for (uint32_t n = 0; n < played.capacity; ++n) {
        sim::World w = trajectory.end;
        const Visit v = n < visits.size() ? visits[n] : Visit{};
        w.tick = v.tick;
        w.jumps = v.jumps;
        w.position.x = v.mark;
        played.worlds.push_back(w);
        played.keys.push_back(v.key);
        played.ticks.push_back(v.tick);
      }
    }
    auto found = rounds().take(kWarmStart, played);
    EXPECT_TRUE(found);
    return *std::move(found);
  }
  float markOf(uint32_t cell) { return (*rounds().cells(0))[cell].world.position.x; }
  ResidentRounds& rounds() {
    if (!rounds_) {
      auto opened = ResidentRounds::open(device_, setup_, scene_.asked.problem(), maxCells_);
      EXPECT_TRUE(opened);
      rounds_.emplace(*std::move(opened));
    }
    return *rounds_;
  }

  ResidentScene scene_{steppingStones()};
  ThreadPool pool_{3};
  sim::HostDevice device_{pool_};
  ExploreSetup setup_{scene_.asked.problem(), 1, {}};
  uint32_t maxCells_ = 100;
  std::optional<ResidentRounds> rounds_;
};

TEST_F(ResidentMerge, RanksByTicksThenJumpsThenOrder) {
  const RoundFindings f = merge({{{7, 20, 1, 1}, {8, 30, 1, 2}, {9, 40, 2, 3}},
                                 {{7, 19, 5, 4}, {8, 30, 0, 5}, {9, 40, 2, 6}},
                                 {{7, 19, 5, 7}}});
  EXPECT_EQ(f.cells, 4u);  // including the start
  ASSERT_EQ(f.nodes.size(), 3u);
  EXPECT_EQ(f.report.candidates, 7u);
  // Cells are numbered by rollout, then visit: 9 comes from the first trajectory, 7 and 8 from the
  // second.
  EXPECT_EQ(markOf(1), 3);
  EXPECT_EQ(markOf(2), 4);
  EXPECT_EQ(markOf(3), 5);
  EXPECT_EQ(f.nodes[0].rollout, kWarmStart);
  EXPECT_EQ(f.nodes[1].rollout, kWarmStart + 1);
  EXPECT_EQ(f.nodes[1].ticks, 19u);
  EXPECT_EQ(f.report.lastFinder, 2u);
  EXPECT_EQ(f.report.sightings, 3u);  // several rollouts found each of the three
}

TEST_F(ResidentMerge, AnIncumbentIsReplacedByABetterOneOnly) {
  merge({{{7, 20, 1, 1}}});
  EXPECT_EQ(merge({{{7, 20, 1, 2}, {7, 21, 0, 3}}}).nodes.size(), 0u);
  EXPECT_EQ(markOf(1), 1);
  const RoundFindings f = merge({{{7, 20, 0, 4}}, {{7, 19, 9, 5}}});
  EXPECT_EQ(f.cells, 2u);
  ASSERT_EQ(f.nodes.size(), 1u);
  EXPECT_EQ(f.nodes[0].rollout, kWarmStart + 1);
  EXPECT_EQ(f.report.lastFinder, 0u);
  EXPECT_EQ(markOf(1), 5);
  EXPECT_EQ((*rounds().cells(0))[1].seen, 4u);
}

TEST_F(ResidentMerge, ARevisitByItsOwnRolloutIsNoSighting) {
  const RoundFindings f = merge({{{7, 20, 0, 1}, {8, 22, 0, 2}, {7, 25, 0, 3}}});
  EXPECT_EQ(f.cells, 3u);
  EXPECT_EQ(f.report.sightings, 0u);
  EXPECT_EQ(markOf(1), 1);
}

// A cell dropped for lack of capacity is new again in the next round, and better trajectories still
// count.
TEST_F(ResidentMerge, CellsBeyondTheCapacityAreDroppedInOrder) {
  maxCells_ = 3;
  const RoundFindings f =
      merge({{{7, 20, 0, 1}}, {{8, 20, 0, 2}, {9, 20, 0, 3}}, {{10, 20, 0, 4}}});
  EXPECT_EQ(f.cells, 3u);
  EXPECT_EQ(f.nodes.size(), 2u);
  EXPECT_EQ(f.report.lastFinder, 2u);
  EXPECT_EQ(markOf(1), 1);
  EXPECT_EQ(markOf(2), 2);
  const RoundFindings g = merge({{{9, 10, 0, 5}, {8, 10, 0, 6}}, {{7, 10, 0, 7}}});
  EXPECT_EQ(g.cells, 3u);
  ASSERT_EQ(g.nodes.size(), 2u);
  EXPECT_EQ(g.nodes[1].rollout, kWarmStart + 1);
  EXPECT_EQ(markOf(1), 7);
  EXPECT_EQ(markOf(2), 6);
  const auto cells = *rounds().cells(0);
  EXPECT_EQ(cells[2].node, 3u);  // after the start and the first two cells
  EXPECT_EQ(cells[1].node, 4u);
}

}  // namespace
}  // namespace obby::solve
