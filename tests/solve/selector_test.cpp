// Tests which cells the selectors of rival methods pick from hand-made archives.
#include "solve/search/selectors/selector.h"

#include <gtest/gtest.h>

#include <map>

#include "scenes.h"
#include "solve/search/rollouts/surfaces.h"
#include "solve/search/selectors/beam_selector.h"
#include "solve/search/selectors/mcts_selector.h"
#include "solve/search/selectors/rrt_selector.h"

namespace obby::solve {
namespace {

sim::World at(Vec3 position, uint32_t tick = 0, uint8_t waypoints = 0) {
  sim::World w{};
  w.position = position;
  w.tick = tick;
  w.waypoints = waypoints;
  return w;
}

// The stepping stones, with everything that a selector needs.
struct Scene {
  Scene() : level(steppingStones().compile()), asked(level), surfaces(level.view()) {}
  ExploreContext context() {
    const Problem p = asked.problem();
    return {p.level, p.query, surfaces.view(), jumpReach(p.level.params), {}, false, -1e30f};
  }
  uint32_t add(const sim::World& w, float potential = 1) {
    archive.offer(archive.cellCount() + 1, w, {}, potential);
    return archive.cellCount() - 1;
  }
  std::vector<Choice> choose(Selector& selector, size_t count, int threads = 2) {
    std::vector<Choice> choices(count, Choice{kNone, 40});
    ThreadPool pool(threads);
    Random random(3, stream++);
    selector.choose(archive, pool, random, choices);
    for (const Choice& c : choices) EXPECT_LT(c.cell, archive.cellCount());
    return choices;
  }
  level::Level level;
  PlainQuery asked;
  Surfaces surfaces;
  Archive archive;
  uint64_t stream = 0;
};

std::map<uint32_t, int> tally(const std::vector<Choice>& choices) {
  std::map<uint32_t, int> counts;
  for (const Choice& c : choices) ++counts[c.cell];
  return counts;
}

TEST(NearestCells, FindsTheNearestOfTheLayerAndTheLowestOfTies) {
  NearestCells cells;
  cells.add(0, {10, 0, 0}, 0);
  cells.add(0, {-10, 0, 0}, 1);  // another block
  cells.add(2, {0, 0, 0}, 2);
  cells.add(0, {10, 0, 0}, 3);
  EXPECT_EQ(cells.nearest(0, {1, 0, 0}), 0u);
  EXPECT_EQ(cells.nearest(0, {-1, 0, 0}), 1u);
  EXPECT_EQ(cells.nearest(0, {0, 0, 0}), 0u);
  EXPECT_EQ(cells.nearest(2, {500, 0, 0}), 2u);
  EXPECT_EQ(cells.layers(), 3u);
  EXPECT_TRUE(cells.empty(1));
  EXPECT_EQ(cells.nearest(1, {0, 0, 0}), kNone);
}

TEST(NearestCells, AgreesWithALinearScan) {
  Random random(1, 1);
  const auto place = [&] {
    return Vec3{float(random.below(64)), float(random.below(16)), float(random.below(64))};
  };
  NearestCells cells;
  std::vector<Vec3> all;
  for (uint32_t i = 0; i < 3000; ++i) {
    all.push_back(place() - Vec3{32, 8, 32});
    cells.add(0, all.back(), i);
  }
  for (int i = 0; i < 500; ++i) {
    const Vec3 to = place() * 2.0f - Vec3{64, 16, 64};
    uint32_t best = 0;
    const auto distance2 = [&](uint32_t c) { return dot(all[c] - to, all[c] - to); };
    for (uint32_t c = 1; c < all.size(); ++c) {
      if (distance2(c) < distance2(best)) best = c;
    }
    ASSERT_EQ(cells.nearest(0, to), best);
  }
}

TEST(RrtSelector, StartsFromTheNearestCellOfEqualProgress) {
  Scene s;
  s.asked.waypoints.push_back({boxAt({0, 2, -16}, {8, 4, 8}), -1});
  RrtSelector selector(s.asked.problem(), s.context());
  const uint32_t start = s.add(at({0, 0, -2})), middle = s.add(at({0, 0, -16}));
  const uint32_t away = s.add(at({0, 0, 900}));
  auto counts = tally(s.choose(selector, 1000));
  EXPECT_EQ(counts[away], 0);
  EXPECT_GT(counts[start], 150);
  EXPECT_GT(counts[middle], 500);  // targets near this cell, and targets beyond it
  const uint32_t further = s.add(at({0, 0, 900}, 0, 1));
  counts = tally(s.choose(selector, 1000));
  EXPECT_EQ(counts[away], 0);
  EXPECT_NEAR(counts[further], 500, 80);  // half of the targets are beyond the waypoint
}

TEST(RrtSelector, RolloutsAreShortAndOfAnyLength) {
  Scene s;
  RrtSelector selector(s.asked.problem(), s.context());
  s.add(at({0, 0, -2}));
  std::map<uint32_t, int> lengths;
  for (const Choice& c : s.choose(selector, 2000)) ++lengths[c.ticks];
  EXPECT_GE(lengths.begin()->first, 1u);
  EXPECT_EQ(lengths.rbegin()->first, 40u);
  EXPECT_GT(lengths.size(), 30u);
}

TEST(RrtSelector, SameChoicesForAnyNumberOfThreads) {
  std::vector<uint32_t> expected;
  for (const int threads : {1, 2, 3, 8}) {
    Scene s;
    RrtSelector selector(s.asked.problem(), s.context());
    for (int i = 0; i < 500; ++i) s.add(at({float(i % 7), 0, -float(i % 30)}));
    std::vector<uint32_t> cells;
    for (const Choice& c : s.choose(selector, 300, threads)) cells.push_back(c.cell);
    if (expected.empty()) expected = cells;
    EXPECT_EQ(cells, expected) << threads;
  }
}

// A tree whose root is cell 0. Its children are cells 1 and 2, found by one rollout each.
struct Fork : Scene {
  Fork() {
    add(at({}), 1);
    choose(selector, 2);
    add(at({}), 1);
    add(at({}), 1);
    selector.learn(archive, std::vector<Tried>{{0, 1, 1, 1}, {0, 2, 1, 1}});
  }
  uint32_t next() { return choose(selector, 1)[0].cell; }
  void pay(uint32_t cell, float potential) {
    selector.learn(archive, std::vector<Tried>{{cell, archive.cellCount(), 0, potential}});
  }
  MctsSelector selector;
};

TEST(MctsSelector, TriesUntriedCellsFirst) {
  Fork f;
  const auto counts = tally(f.choose(f.selector, 2));
  EXPECT_EQ(counts, (std::map<uint32_t, int>{{1, 1}, {2, 1}}));
}

TEST(MctsSelector, ARolloutsCellsFormAChain) {
  Scene s;
  MctsSelector selector;
  s.add(at({}));
  s.choose(selector, 1);
  for (int i = 0; i < 3; ++i) s.add(at({}));
  selector.learn(s.archive, std::vector<Tried>{{0, 1, 3, 1}});
  EXPECT_EQ(s.choose(selector, 1)[0].cell, 3u);  // the end of the trajectory comes first
}

TEST(MctsSelector, PendingRolloutsCountAsALoss) {
  Fork f;
  const auto counts = tally(f.choose(f.selector, 300));
  EXPECT_NEAR(counts.at(1), counts.at(2), 1);
}

TEST(MctsSelector, PrefersRewardsAndStillTriesTheRest) {
  Fork f;
  std::map<uint32_t, int> counts;
  for (int i = 0; i < 600; ++i) {
    const uint32_t cell = f.next();
    ++counts[cell];
    f.pay(cell, cell == 2 ? 1.0f : 0.9f);
  }
  EXPECT_GT(counts[2], 400);
  EXPECT_GT(counts[1], 3);
  EXPECT_GT(counts[0], 3);
  EXPECT_LT(counts[1], 100);
}

TEST(MctsSelector, EqualRewardsAreSharedEqually) {
  Fork f;
  std::map<uint32_t, int> counts;
  for (int i = 0; i < 600; ++i) {
    const uint32_t cell = f.next();
    ++counts[cell];
    f.pay(cell, 0.5f);
  }
  EXPECT_NEAR(counts[1], counts[2], 2);
  EXPECT_GT(counts[1], 150);
  EXPECT_GT(counts[0], 150);
}

// The player walks at 16 studs/s, and a second has 60 ticks.
TEST(BeamSelector, TicksLeftAssumeAStraightWalkThroughTheWaypoints) {
  Scene s;
  EXPECT_FLOAT_EQ(BeamSelector(s.asked.problem()).ticksLeft(at({0, 0, -12})), 12 * 60 / 16.0f);
  s.asked.waypoints.push_back({boxAt({0, 2, -4}, {2, 4, 2}), -1});
  const BeamSelector selector(s.asked.problem());
  EXPECT_FLOAT_EQ(selector.ticksLeft(at({0, 0, -12}, 0, 1)), 12 * 60 / 16.0f);
  const float back = 7,
              there = geom::distance(s.asked.query.goal.region, {0, 2, -4}) - length(Vec3{1, 2, 1});
  EXPECT_FLOAT_EQ(selector.ticksLeft(at({0, 0, -12})), (back + there) * 60 / 16);
}

TEST(BeamSelector, MinimisesTicksSoFarPlusTicksLeft) {
  Scene s;
  BeamSelector selector(s.asked.problem());
  s.add(at({0, 0, -2}, 0));
  const uint32_t near = s.add(at({0, 0, -14}, 60)), late = s.add(at({0, 0, -15}, 900));
  const uint32_t second = s.add(at({0, 0, -13}, 60));
  const auto counts = tally(s.choose(selector, 8));
  EXPECT_EQ(counts, (std::map<uint32_t, int>{{near, 4}, {second, 4}}));
  EXPECT_EQ(counts.count(late), 0u);
}

TEST(BeamSelector, PassedWaypointsCount) {
  Scene s;
  s.asked.waypoints.push_back({boxAt({0, 2, -2}, {4, 4, 2}), -1});
  BeamSelector selector(s.asked.problem());
  s.add(at({0, 0, -16}, 10));
  const uint32_t behind = s.add(at({0, 0, -3}, 10, 1));
  EXPECT_EQ(tally(s.choose(selector, 4)), (std::map<uint32_t, int>{{behind, 4}}));
}

TEST(BeamSelector, NoCellStarves) {
  Scene s;
  BeamSelector selector(s.asked.problem());
  for (int i = 0; i < 50; ++i) s.add(at({0, 0, -float(i % 10)}, uint32_t(i) * 5));
  std::map<uint32_t, int> counts;
  for (int round = 0; round < 600; ++round) {
    for (const Choice& c : s.choose(selector, 4)) ++counts[c.cell];
  }
  EXPECT_EQ(counts.size(), 50u);
  EXPECT_GT(counts[9], counts[40]);
}

TEST(BeamSelector, FewCellsShareTheRound) {
  Scene s;
  BeamSelector selector(s.asked.problem());
  s.add(at({0, 0, -2}));
  EXPECT_EQ(tally(s.choose(selector, 32))[0], 32);
}

TEST(BeamSelector, SameChoicesForAnyNumberOfThreads) {
  std::vector<uint32_t> expected;
  for (const int threads : {1, 2, 3, 8}) {
    Scene s;
    BeamSelector selector(s.asked.problem());
    for (uint32_t i = 0; i < 20000; ++i) {
      s.add(at({float(i % 11), 0, -float(i * 7 % 29)}, i * 37 % 1009));
    }
    std::vector<uint32_t> cells;
    for (const Choice& c : s.choose(selector, 300, threads)) cells.push_back(c.cell);
    if (expected.empty()) expected = cells;
    EXPECT_EQ(cells, expected) << threads;
  }
}

}  // namespace
}  // namespace obby::solve
