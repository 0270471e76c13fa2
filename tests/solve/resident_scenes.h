// Shared helpers of the resident search's tests.
#pragma once

#include <gtest/gtest.h>

#include "golden/dynamic_scenes.h"
#include "scenes.h"
#include "solve/search/resident/resident_explore.h"

namespace obby::solve {

inline ResidentSettings smallRounds(uint32_t rollouts = 256) {
  ResidentSettings s;
  s.explore.rollouts = rollouts;
  s.explore.maxRollouts = 4 * rollouts;
  return s;
}

// A level and a query for it.
struct ResidentScene {
  explicit ResidentScene(LevelBuilder builder) : level(builder.compile()), asked(level) {
    asked.query.goal = boxAt({0, 500, 0}, {2, 2, 2});  // out of reach
  }
  level::Level level;
  PlainQuery asked;
  uint32_t rollouts = 256;  // rollouts per round
  uint32_t replayed = 1;    // the test replays every `replayed`-th cell
};

// Returns levels whose cells differ in many ways: moving parts, jumps, waypoints, dynamic bodies.
inline std::vector<std::pair<const char*, std::unique_ptr<ResidentScene>>> residentScenes() {
  std::vector<std::pair<const char*, std::unique_ptr<ResidentScene>>> all;
  all.emplace_back("stones", std::make_unique<ResidentScene>(steppingStones()));
  all.emplace_back("moving", std::make_unique<ResidentScene>(support::movingArena(40, 8, 3)));
  all.emplace_back("jumps", std::make_unique<ResidentScene>(support::boxArena(40, 5)));
  all.back().second->asked.query.maxJumps = 3;
  all.emplace_back("waypoints", std::make_unique<ResidentScene>(steppingStones()));
  PlainQuery& q = all.back().second->asked;
  q.waypoints = {{boxAt({3, 2, -18}, {2, 4, 2})}, {boxAt({-3, 2, -1}, {2, 4, 2})}};
  q.query.goal = boxAt({0, 2, -28}, {8, 4, 8});
  all.emplace_back("loose", std::make_unique<ResidentScene>(golden::dynamicBodies()));
  all.back().second->rollouts = 24;  // dynamic bodies are slow
  all.back().second->replayed = 7;
  return all;
}

inline void expectSameArchive(const ResidentExplore& a, const ResidentExplore& b,
                              const std::string& name) {
  const std::vector<ArchivedCell> left = a.cells(), right = b.cells();
  ASSERT_EQ(left.size(), right.size()) << name;
  ASSERT_EQ(left.size(), a.cellCount()) << name;
  for (size_t c = 0; c < left.size(); ++c) {
    ASSERT_EQ(sim::stateHash(left[c].world, left[c].bodies),
              sim::stateHash(right[c].world, right[c].bodies))
        << name << ", cell " << c;
    ASSERT_EQ(left[c].node, right[c].node) << name << ", cell " << c;
    ASSERT_EQ(left[c].seen, right[c].seen) << name << ", cell " << c;
  }
  EXPECT_EQ(a.singletons(), b.singletons()) << name;
  const Statistics &s = a.statistics(), &t = b.statistics();
  EXPECT_EQ(s.steps, t.steps) << name;
  EXPECT_EQ(s.idleRollouts, t.idleRollouts) << name;
  EXPECT_EQ(s.closest.distance, t.closest.distance) << name;
  EXPECT_EQ(s.closest.node.rollout, t.closest.node.rollout) << name;
}

}  // namespace obby::solve
