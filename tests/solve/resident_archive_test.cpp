// The archive of a resident search is the same for any number of threads and stays within its
// capacity. Replaying its trajectories reproduces its states.
#include <set>

#include "resident_scenes.h"

namespace obby::solve {
namespace {

void rounds(ResidentExplore& search, int count) {
  for (int i = 0; i < count; ++i) search.round();
}

TEST(ResidentArchive, IsTheSameForAnyNumberOfThreads) {
  for (const auto& [name, scene] : residentScenes()) {
    ThreadPool one(1);
    ResidentExplore expected(scene->asked.problem(), 4, smallRounds(scene->rollouts), {one});
    rounds(expected, 8);
    EXPECT_GT(expected.cellCount(), 20u) << name;
    for (const int threads : {2, 3}) {
      ThreadPool pool(threads);
      ResidentExplore search(scene->asked.problem(), 4, smallRounds(scene->rollouts), {pool});
      rounds(search, 8);
      expectSameArchive(search, expected, std::string(name) + ", " + std::to_string(threads));
    }
  }
}

TEST(ResidentArchive, EveryStateIsRegeneratedFromItsTrajectory) {
  for (const auto& [name, scene] : residentScenes()) {
    ThreadPool pool(2);
    ResidentExplore search(scene->asked.problem(), 9, smallRounds(scene->rollouts), {pool});
    rounds(search, 6);
    const std::vector<ArchivedCell> cells = search.cells();
    for (size_t c = 0; c < cells.size(); c += scene->replayed) {
      const Trajectory p = search.trajectoryTo(search.nodes()[cells[c].node]);
      ASSERT_EQ(sim::stateHash(p.end, p.endBodies), sim::stateHash(cells[c].world, cells[c].bodies))
          << name << ", cell " << c;
    }
  }
}

// No node is lost or duplicated: each belongs to a cell, or belonged to one until a better arrival.
TEST(ResidentArchive, CellsAreDistinctAndSoAreTheirNodes) {
  ResidentScene scene(support::movingArena(40, 8, 3));
  ThreadPool pool(2);
  ResidentExplore search(scene.asked.problem(), 2, smallRounds(), {pool});
  rounds(search, 10);
  const Problem problem = scene.asked.problem();
  const ExploreSetup setup(problem, 2, smallRounds().explore);
  std::set<uint64_t> keys;
  std::set<uint32_t> nodes;
  for (const ArchivedCell& c : search.cells()) {
    keys.insert(cellKey(setup.rules.binning, c.world, c.bodies.data()));
    nodes.insert(c.node);
  }
  EXPECT_EQ(keys.size(), search.cellCount());
  EXPECT_EQ(nodes.size(), search.cellCount());
  EXPECT_LT(*nodes.rbegin(), search.nodes().size());
  for (size_t n = 1; n < search.nodes().size(); ++n) {
    ASSERT_LT(search.nodes()[n].parent, n) << n;
    ASSERT_GT(search.nodes()[n].ticks, 0u) << n;
  }
}

TEST(ResidentArchive, AFullArchiveKeepsTheSameCellsForAnyNumberOfThreads) {
  ResidentScene scene(support::movingArena(40, 8, 3));
  ResidentSettings settings = smallRounds();
  settings.maxCells = 100;
  ThreadPool one(1), three(3);
  ResidentExplore expected(scene.asked.problem(), 4, settings, {one});
  ResidentExplore search(scene.asked.problem(), 4, settings, {three});
  uint64_t nodes = 0;
  for (int i = 0; i < 12; ++i) {
    expected.round();
    search.round();
    ASSERT_LE(search.cellCount(), 100u);
    nodes = search.nodes().size();
  }
  EXPECT_EQ(search.cellCount(), 100u);
  EXPECT_GT(nodes, 100u);  // better trajectories to known cells are still kept
  expectSameArchive(search, expected, "full");
}

// The search finds far more cells than fit in its initial memory.
TEST(ResidentArchive, GrowsWithItsContent) {
  ResidentScene scene(support::movingArena(60, 12, 3));
  ResidentSettings settings = smallRounds(1024);
  settings.explore.groundedOnly = false;
  settings.explore.cellWidth = 0.5f;
  ThreadPool pool(2);
  ResidentExplore search(scene.asked.problem(), 4, settings, {pool});
  rounds(search, 4);
  ASSERT_GT(search.cellCount(), 20'000u);
  const std::vector<ArchivedCell> cells = search.cells();
  for (size_t c = 0; c < cells.size(); c += 97) {
    const Trajectory p = search.trajectoryTo(search.nodes()[cells[c].node]);
    ASSERT_EQ(sim::stateHash(p.end), sim::stateHash(cells[c].world)) << c;
  }
}

}  // namespace
}  // namespace obby::solve
