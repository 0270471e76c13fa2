#include "solve/search/selectors/selection.h"
#include "solve/search/guidance/potential.h"

#include <gtest/gtest.h>

#include "scenes.h"
#include "solve/search/rollouts/trail.h"

namespace obby::solve {
namespace {

TEST(SelectionWeight, FallsWithTheRootOfTheCount) {
  const double fresh = selectionWeight(2, 2, 0, 0.1f);
  EXPECT_NEAR(selectionWeight(2, 2, 3, 0.1f), fresh / 2, 2);
  EXPECT_NEAR(selectionWeight(2, 2, 99, 0.1f), fresh / 10, 2);
  EXPECT_GE(selectionWeight(2, 2, 0xffffffff, 0.1f), 1u);
}

TEST(SelectionWeight, LeansTowardThePotentialButNeverBelowATenth) {
  const double best = selectionWeight(20, 20, 0, 0.1f);
  EXPECT_NEAR(selectionWeight(10, 20, 0, 0.1f), best / 2, 2);
  EXPECT_NEAR(selectionWeight(0.01f, 20, 0, 0.1f), best / 10, 2);
}

TEST(Potential, RisesTowardTheGoalAndWithWaypoints) {
  const level::Level level = steppingStones().compile();
  PlainQuery q(level);
  q.waypoints.push_back({boxAt({0, 2, -16}, {8, 4, 8}), -1});
  const Potential potential(q.problem());
  sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
  const float start = potential(w);
  w.position = {0, 0, -12};
  const float nearWaypoint = potential(w);
  w.waypoints = 1;
  const float behindWaypoint = potential(w);
  w.position = {0, 0, -28};
  const float atGoal = potential(w);
  EXPECT_LT(start, nearWaypoint);
  EXPECT_LT(nearWaypoint, behindWaypoint);
  EXPECT_LT(behindWaypoint, atGoal);
  EXPECT_FLOAT_EQ(atGoal, 5.0f * 4.0f);
  EXPECT_FLOAT_EQ(distanceLeft(q.problem().query, w), 0);
}

TEST(CellSelector, PicksInProportionToTheWeights) {
  Archive archive;
  const uint32_t cells = 1500;  // enough cells for several blocks of sums
  for (uint32_t i = 0; i < cells; ++i) {
    archive.offer(i + 1, sim::World{}, {}, i % 3 == 0 ? 4.0f : 1.0f);
  }
  for (uint32_t i = 0; i < 8; ++i) archive.countSeen(0);
  ThreadPool pool(2);
  CellSelector selector(0.1f);
  selector.update(archive, pool);
  Random random(1, 2);
  std::vector<double> share(3, 0);
  double first = 0;
  const int draws = 300000;
  for (int i = 0; i < draws; ++i) {
    const uint32_t cell = selector.pick(random);
    ASSERT_LT(cell, cells);
    share[cell % 3] += 1.0 / draws;
    first += cell == 0;
  }
  EXPECT_NEAR(share[0], 4.0 / 6, 0.01);
  EXPECT_NEAR(share[1], 1.0 / 6, 0.01);
  EXPECT_NEAR(share[2], 1.0 / 6, 0.01);
  EXPECT_NEAR(first, draws * (4.0 / 3) / (2.0 * cells),
              40);  // cell 0 has a third of the weight of a fresh cell
}

TEST(CellSelector, SameChoicesForAnyNumberOfThreads) {
  Archive archive;
  for (uint32_t i = 0; i < 20000; ++i) archive.offer(i + 1, sim::World{}, {}, 1 + float(i % 7));
  for (uint32_t i = 0; i < 20000; i += 3) archive.countSeen(i);
  std::vector<uint32_t> expected;
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    CellSelector selector(0.1f);
    selector.update(archive, pool);
    Random random(5, 6);
    std::vector<uint32_t> picks;
    for (int i = 0; i < 1000; ++i) picks.push_back(selector.pick(random));
    if (expected.empty()) expected = picks;
    EXPECT_EQ(picks, expected) << threads << " threads";
  }
}

}  // namespace
}  // namespace obby::solve
