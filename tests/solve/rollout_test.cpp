#include "solve/search/rollouts/rollout.h"
#include "solve/search/rollouts/fatal_fall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scenes.h"
#include "solve/search/methods/go_explore.h"
#include "solve/search/rollouts/surfaces.h"

namespace obby::solve {
namespace {

struct RolloutScene {
  explicit RolloutScene(LevelBuilder builder = steppingStones())
      : level(builder.compile()), asked(level), surfaces(level.view()) {}
  ExploreContext context(float aimShare = 0.5f) {
    const Problem p = asked.problem();
    return {p.level,          p.query,
            surfaces.view(),  jumpReach(p.level.params),
            {aimShare, 0.1f}, limitsJumps(p.query),
            fatalHeight(p)};
  }
  level::Level level;
  PlainQuery asked;
  Surfaces surfaces;
};

TEST(Rollout, TheSameSeedAndStreamGiveTheSameActionsAndState) {
  RolloutScene scene;
  const ExploreContext c = scene.context();
  for (uint64_t stream = 0; stream < 50; ++stream) {
    sim::World a = scene.asked.problem().start, b = a;
    const uint32_t ticks = runRollout(c, 7, stream, a, nullptr, 100, [](auto, auto&) {});
    // Plays half a rollout, then the whole one. The draws depend only on the arguments.
    runRollout(c, 7, stream, b, nullptr, ticks / 2, [](auto, auto&) {});
    b = scene.asked.problem().start;
    EXPECT_EQ(runRollout(c, 7, stream, b, nullptr, 100, [](auto, auto&) {}), ticks);
    EXPECT_EQ(sim::stateHash(a), sim::stateHash(b));
  }
}

TEST(Rollout, StreamsDiffer) {
  RolloutScene scene;
  const ExploreContext c = scene.context();
  std::set<uint64_t> ends;
  for (uint64_t stream = 0; stream < 50; ++stream) {
    sim::World w = scene.asked.problem().start;
    runRollout(c, 7, stream, w, nullptr, 60, [](auto, auto&) {});
    ends.insert(sim::stateHash(w));
  }
  EXPECT_GT(ends.size(), 45u);
}

TEST(Rollout, StopsAtTheEndOfTheTrajectory) {
  RolloutScene scene;
  scene.asked.avoid.push_back(boxAt({0, 2, -8}, {100, 40, 1}));
  const ExploreContext c = scene.context();
  int avoided = 0;
  for (uint64_t stream = 0; stream < 100; ++stream) {
    sim::World w = scene.asked.problem().start;
    const uint32_t ticks = runRollout(c, 1, stream, w, nullptr, 300, [](auto, auto&) {});
    if (w.outcome != sim::Outcome::avoided) continue;
    ++avoided;
    EXPECT_LT(ticks, 300u);
    EXPECT_EQ(w.tick, ticks);
  }
  EXPECT_GT(avoided, 10);
}

TEST(Rollout, NeverJumpsBeyondALimit) {
  RolloutScene scene;
  scene.asked.query.maxJumps = 1;
  const ExploreContext c = scene.context();
  bool jumped = false;
  for (uint64_t stream = 0; stream < 100; ++stream) {
    sim::World w = scene.asked.problem().start;
    runRollout(c, 1, stream, w, nullptr, 300, [](auto, auto&) {});
    EXPECT_LE(w.jumps, 1);
    EXPECT_NE(w.outcome, sim::Outcome::jumps);
    jumped = jumped || w.jumps == 1;
  }
  EXPECT_TRUE(jumped);
}

TEST(Rollout, AimedMacrosCrossAGapMoreOftenThanRandomOnes) {
  RolloutScene scene;
  const auto crossings = [&](float aimShare) {
    const ExploreContext c = scene.context(aimShare);
    int count = 0;
    for (uint64_t stream = 0; stream < 400; ++stream) {
      sim::World w = scene.asked.problem().start;
      bool across = false;
      runRollout(c, 3, stream, w, nullptr, 90, [&](auto, const sim::World& now) {
        across = across || (grounded(now) && now.position.z < -12);
      });
      count += across;
    }
    return count;
  };
  EXPECT_GT(crossings(1.0f), 3 * std::max(crossings(0.0f), 1));
}

TEST(RandomMacro, HoldsForTwentyTicksOnAverage) {
  Random random(1, 1);
  double sum = 0;
  for (int i = 0; i < 20000; ++i) sum += drawHoldTicks(random);
  EXPECT_NEAR(sum / 20000, 20, 0.6);
}

TEST(Surfaces, AreStandablePlacesExceptOnKillParts) {
  LevelBuilder b = steppingStones();
  b.block({30, 0, 0}, {6, 1, 6}, [](schema::Part::Builder p) { p.initKill(); });
  b.block({60, 0, 0}, {6, 1, 6}, [](schema::Part::Builder p) { p.setSolid(false); });
  b.block({90, 5, 0}, {6, 2, 6});
  const level::Level level = b.compile();
  const Surfaces surfaces(level.view());
  bool high = false;
  for (const SurfacePoint& p : surfaces.points()) {
    EXPECT_TRUE(p.position.x < 20 || p.position.x > 80) << p.position.x;
    if (p.position.x > 80) {
      EXPECT_NEAR(p.position.y, 6, 1e-4);
      high = true;
    }
  }
  EXPECT_TRUE(high);
}

// Aims lie along the whole height of a truss, at most a jump apart.
TEST(Surfaces, CoverTheWholeHeightOfATruss) {
  LevelBuilder b = steppingStones();
  b.block({50, 20, 0}, {2, 40, 2},
          [](schema::Part::Builder p) { p.setShape(schema::Shape::TRUSS); });
  const level::Level level = b.compile();
  const Surfaces surfaces(level.view());
  const float rise = jumpReach(level.view().params).height;
  for (float y = 0; y < 40 - rise; y += 1) {
    const auto above = [&](const SurfacePoint& p) {
      return p.position.x > 20 && p.position.y > y && p.position.y < y + rise;
    };
    EXPECT_TRUE(std::any_of(surfaces.points().begin(), surfaces.points().end(), above)) << y;
  }
}

TEST(Surfaces, FollowThePoseOfAMovingPart) {
  LevelBuilder b = steppingStones();
  b.block({50, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) {
    auto keys = p.initMotion().initKeys(2);
    support::set(keys[0].initPosition(), {50, 0, 0});
    support::set(keys[1].initPosition(), {50, 20, 0});
    keys[1].setTime(2);
  });
  const level::Level level = b.compile();
  const Surfaces surfaces(level.view());
  const SurfacePoint moving = surfaces.points().back();
  ASSERT_NE(moving.mover, level::kNone);
  sim::World w{};
  EXPECT_NEAR(positionIn(level.view(), moving, w).y, 0.5f, 0.3f);
  w.tick = 100;
  EXPECT_GT(positionIn(level.view(), moving, w).y, 10);
  Random random(1, 1);
  EXPECT_NE(pickPoint(surfaces.view(), {50, 15, 0}, 5, 5, 5, random), level::kNone);
  EXPECT_EQ(pickPoint(surfaces.view(), {50, 15, 900}, 5, 5, 5, random),
            pickPoint(surfaces.view(), {50, 15, 900}, 5, 5, 5, random));
}

}  // namespace
}  // namespace obby::solve
