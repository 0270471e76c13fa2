// The bound on what a player can reach contains everything that players do, and excludes what is
// well beyond a jump.
#include "solve/proof/reach_bound.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "golden/hashes.h"
#include "scenes.h"
#include "solve/search/methods/go_explore.h"

namespace obby::solve {
namespace {

Problem problemOf(const level::Level& level, const level::QueryView& query = {}) {
  const level::StartPose start = level.spawns().empty() ? level::StartPose{} : level.spawns()[0];
  return {level.view(),
          query,
          sim::makeWorld(level.view(), start),
          sim::startBodies(level.view()),
          level.bounds(),
          level.hasMotion()};
}

// Plays at random, and restarts after each end. Fails at the first position outside the bound.
void expectHeld(const level::Level& level, const char* name, int worlds, int ticks) {
  if (unboundedPart(level.view()) != nullptr) return;
  const Problem problem = problemOf(level);
  const ReachBound bound(problem, true);
  for (int i = 0; i < worlds; ++i) {
    sim::World w = problem.start;
    for (int t = 0; t < ticks; ++t) {
      if (w.outcome != sim::Outcome::running) w = problem.start;
      Random random(uint64_t(i), uint64_t(t / (5 + i % 36)));
      const sim::Action action{Turns(random.next()), random.below(10) != 0, random.below(3) == 0};
      sim::advance(w, nullptr, level.view(), nullptr, action);
      ASSERT_TRUE(bound.holds(w.position))
          << name << ", world " << i << ", tick " << t << ": (" << w.position.x << ", "
          << w.position.y << ", " << w.position.z << ") in state " << int(w.state);
    }
  }
}

TEST(ReachBound, HoldsRandomPlayInEveryGoldenScene) {
  for (const golden::Scene& scene : golden::kScenes) {
    expectHeld(scene.build().compile(), scene.name, 24, 600);
  }
}

// A search goes further than random play. The bound must contain every state in its archive.
TEST(ReachBound, HoldsEveryCellOfASearch) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const level::Level level =
        (seed % 2 == 0 ? support::movingArena(30, 8, seed) : support::boxArena(30, seed)).compile();
    level::QueryView query;
    query.goal.region = {{{0, 5000, 0}, {}}, {1, 1, 1}};
    const Problem problem = problemOf(level, query);
    const ReachBound bound(problem, true);
    ThreadPool pool(2);
    GoExplore search(problem, seed, {}, {pool});
    for (int round = 0; round < 60; ++round) search.round();
    for (uint32_t c = 0; c < search.archive().cellCount(); ++c) {
      const Vec3 at = search.archive().world(c).position;
      ASSERT_TRUE(bound.holds(at)) << seed << ": " << at.x << ", " << at.y << ", " << at.z;
    }
  }
}

// Returns two platforms, `gap` studs apart, the second `rise` studs higher.
level::Level platforms(float gap, float rise,
                       std::function<void(schema::Part::Builder)> more = {}) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}, more).spawn({0, 0, 0});
  b.block({0, -0.5f + rise, -8 - gap}, {8, 1, 8});
  return b.compile();
}

uint32_t jumpsAcross(const level::Level& level, bool mayJump = true) {
  level::QueryView query;
  const Vec3 second = level.view().colliders[1].pose.position;
  query.goal.region = {{second + Vec3{0, 3, 0}, {}}, {4, 2, 4}};
  const Problem problem = problemOf(level, query);
  return ReachBound(problem, mayJump).jumpsTo(query.goal);
}

// A search finds solutions for gaps of up to 11.5 studs and rises of up to 8.8 (docs/physics.md).
TEST(ReachBound, AdmitsStepsThatPlayersCanMake) {
  EXPECT_EQ(jumpsAcross(platforms(9.5f, 0)), 1u);
  EXPECT_EQ(jumpsAcross(platforms(11.5f, 0)), 1u);
  EXPECT_EQ(jumpsAcross(platforms(1, 8.8f)), 1u);
  EXPECT_EQ(jumpsAcross(platforms(1, 0)), 0u) << "a gap to walk across";
  EXPECT_EQ(jumpsAcross(platforms(6, -20)), 0u) << "falls far enough";
}

TEST(ReachBound, RefusesStepsFarBeyondAJump) {
  EXPECT_EQ(jumpsAcross(platforms(17, 0)), ReachBound::kNever);
  EXPECT_EQ(jumpsAcross(platforms(1, 15)), ReachBound::kNever);
  EXPECT_EQ(jumpsAcross(platforms(11, 0), false), ReachBound::kNever);
}

TEST(ReachBound, BoostsPadsAndBeltsReachFurther) {
  const auto boost = [](schema::Part::Builder p) { p.initBoost().setWalkSpeed(3); };
  EXPECT_NE(jumpsAcross(platforms(30, 0, boost)), ReachBound::kNever);
  const auto light = [](schema::Part::Builder p) { p.initBoost().setGravity(0.4f); };
  EXPECT_NE(jumpsAcross(platforms(20, 0, light)), ReachBound::kNever);
  EXPECT_NE(jumpsAcross(platforms(1, 17, light)), ReachBound::kNever);
  EXPECT_EQ(jumpsAcross(platforms(1, 26, light)), ReachBound::kNever);
  const auto belt = [](schema::Part::Builder p) {
    support::set(p.initConveyor().initVelocity(), {0, 0, -40});
  };
  EXPECT_NE(jumpsAcross(platforms(17, 0, belt)), ReachBound::kNever);
  const auto pad = [](schema::Part::Builder p) {
    support::set(p.initJumpPad().initVelocity(), {0, 100, 0});
  };
  EXPECT_EQ(jumpsAcross(platforms(1, 24, pad)), 0u) << "thrown, not jumped";
  const auto gate = [](schema::Part::Builder p) {
    support::set(p.initTeleport().initPosition(), {0, 60, -70});
  };
  EXPECT_EQ(jumpsAcross(platforms(60, 55, gate)), 0u);
}

TEST(ReachBound, MovingPartsCountAlongTheirWholeMotion) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8}).spawn({0, 0, 0});
  b.block({0, 39.5f, -20}, {8, 1, 8});
  b.block({0, -0.5f, -10}, {4, 1, 4}, [](schema::Part::Builder p) {
    auto keys = p.initMotion().initKeys(2);
    support::set(keys[0].initPosition(), {0, -0.5f, -10});
    support::set(keys[1].initPosition(), {0, 36, -10});
    keys[1].setTime(20);
    p.getMotion().setRepeat(schema::Repeat::PING_PONG);
  });
  EXPECT_NE(jumpsAcross(b.compile()), ReachBound::kNever);
  EXPECT_EQ(jumpsAcross(platforms(12, 40)), ReachBound::kNever) << "without it";
}

// Runs up a slope with the key held, and jumps at tick `jumpAt` unless that is kNever.
void expectRunHeld(float degrees, float walkSpeed, uint32_t jumpAt) {
  SCOPED_TRACE(fmt::format("{} degrees, {} studs/s, jump at tick {}", degrees, walkSpeed, jumpAt));
  const bool jumps = jumpAt != ReachBound::kNever;
  constexpr float kHigh = 10;
  const float run = kHigh / std::tan(degrees * kPi / 180);
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 40}).spawn({0, 0, 15});
  b.part([=](schema::Part::Builder p) {
    support::set(p.initPosition(), {0, kHigh / 2, -20 - run / 2});
    support::set(p.initSize(), {8, kHigh, run});
    support::setRotation(p.initRotation(), kPi);
    p.setShape(schema::Shape::WEDGE);
  });
  b.physics([=](schema::PhysicsParams::Builder p) { p.setWalkSpeed(walkSpeed); });
  const level::Level level = b.compile();
  const Problem problem = problemOf(level);
  const ReachBound bound(problem, jumps);
  sim::World w = problem.start;
  for (uint32_t t = 0; t < 300 && w.outcome == sim::Outcome::running; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {0, true, t == jumpAt});
    ASSERT_TRUE(bound.holds(w.position)) << "tick " << t << ", height " << w.position.y;
  }
}

TEST(ReachBound, HoldsForFastPlayersOnARamp) {
  for (const float degrees : {20.0f, 30.0f, 40.0f, 45.0f, 50.0f, 60.0f, 70.0f, 80.0f}) {
    for (const float speed : {16.0f, 32.0f, 64.0f, 100.0f, 200.0f, 400.0f}) {
      expectRunHeld(degrees, speed, ReachBound::kNever);
      for (uint32_t t = 0; t < 160; t += 2) expectRunHeld(degrees, speed, t);
    }
  }
}

// A slab slides away while the button's signal lasts, and then returns at once. A player who has
// moved to its place is then inside the slab.
TEST(ReachBound, HoldsForDepenetrationByAReturningSlab) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 60}).spawn({0, 0, 20});
  b.block({0, 0.1f, 20}, {4, 0.2f, 4}, [](schema::Part::Builder p) {
    p.setSolid(false);
    auto button = p.initButton();
    button.setSignal("go");
    button.setSeconds(2);
  });
  b.block({0, 3, 0}, {20, 6, 20}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 3, 0});
    support::set(keys[1].initPosition(), {30, 3, 0});
    keys[1].setTime(1);
    motion.setRepeat(schema::Repeat::ONCE);
    motion.setTrigger(schema::MotionTrigger::SIGNAL);
    motion.setSignal("go");
  });
  const level::Level level = b.compile();
  const Problem problem = problemOf(level);
  const ReachBound bound(problem, false);
  sim::World w = problem.start;
  float highest = 0;
  for (uint32_t t = 0; t < 400; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {0, t < 72, false});
    highest = std::max(highest, w.position.y);
    ASSERT_TRUE(bound.holds(w.position)) << "tick " << t << ", height " << w.position.y;
  }
  EXPECT_GT(highest, 5) << "no player was lifted";
}

// A player who is tripped at the top slides down the slope, because the legs do not hold.
TEST(ReachBound, HoldsForATrippedSlide) {
  constexpr float kYaw = kPi / 4;  // diagonal, because the bound limits the speed on each axis
  const Vec3 ahead{-std::sin(kYaw), 0, -std::cos(kYaw)};
  const auto turned = [](schema::Part::Builder p) { support::setRotation(p.initRotation(), kYaw); };
  LevelBuilder b;
  b.block({0, 150, 0}, {12, 1, 12}, turned).spawn({0, 150.5f, 0});
  b.block(Vec3{0, 146.5f, 0} + ahead * 21, {12, 8, 30}, [&](schema::Part::Builder p) {
    turned(p);
    p.setShape(schema::Shape::WEDGE);
  });
  b.block(Vec3{0, 151.5f, 0} + ahead * 5.5f, {12, 2, 0.5f}, [&](schema::Part::Builder p) {
    turned(p);
    p.setSolid(false);
    p.initTrip();
  });
  const level::Level level = b.compile();
  const Problem problem = problemOf(level);
  const ReachBound bound(problem, true);
  float fastest = 0;
  for (int aside = -8; aside <= 8; ++aside) {
    sim::World w = problem.start;
    const Turns direction = Turns(turnsFromRadians(kYaw) + Turns(aside * 200));
    for (uint32_t t = 0; t < 500 && w.outcome == sim::Outcome::running; ++t) {
      sim::advance(w, nullptr, level.view(), nullptr, {direction, true, false});
      fastest = std::max(fastest, length(Vec3{w.velocity.x, 0, w.velocity.z}));
      ASSERT_TRUE(bound.holds(w.position)) << "aside " << aside << ", tick " << t;
    }
  }
  EXPECT_GT(fastest, 30) << "no player slid";
}

TEST(ReachBound, CountsTheFewestJumps) {
  LevelBuilder b;
  b.spawn({0, 0, 0});
  for (int i = 0; i < 5; ++i) b.block({0, -0.5f, -19.0f * float(i)}, {8, 1, 8});
  const level::Level level = b.compile();
  level::QueryView query;
  const Problem problem = problemOf(level, query);
  const ReachBound bound(problem, true);
  for (int i = 0; i < 5; ++i) {
    const level::TargetView stone = boxAt({0, 2, -19.0f * float(i)}, {4, 2, 4});
    EXPECT_EQ(bound.jumpsTo(stone), uint32_t(i));
  }
}

// A search over all pairs of these stones would take too long.
TEST(ReachBound, CountsTheFewestJumpsAmongMany) {
  LevelBuilder b;
  b.spawn({0, 0, 0});
  for (int i = 0; i < 100; ++i) b.block({0, -0.5f, -19.0f * float(i)}, {8, 1, 8});
  for (int i = 0; i < 100; ++i) b.block({40, -0.5f, -19.0f * float(i)}, {8, 1, 8});
  const level::Level level = b.compile();
  const Problem problem = problemOf(level);
  const ReachBound bound(problem, true);
  for (const int i : {0, 1, 50, 99}) {
    EXPECT_EQ(bound.jumpsTo(boxAt({0, 2, -19.0f * float(i)}, {4, 2, 4})), uint32_t(i));
    EXPECT_EQ(bound.jumpsTo(boxAt({40, 2, -19.0f * float(i)}, {4, 2, 4})), ReachBound::kNever);
  }
}

TEST(ReachBound, NamesTheSmallestMissingStep) {
  const level::Level level = platforms(1, 16);
  const Problem problem = problemOf(level);
  const Missing m = ReachBound(problem, true).missing(boxAt({0, 30, -9}, {4, 4, 4}));
  EXPECT_EQ(level.view().colliders[m.from].part, 0u);
  EXPECT_EQ(level.view().colliders[m.to].part, 1u);
  EXPECT_GT(m.rise, 2) << "of the 16 studs 9 can be done";
  EXPECT_LT(m.rise, 7);
  EXPECT_EQ(m.gap, 0);
}

TEST(ReachBound, ReportsUnboundedParts) {
  EXPECT_EQ(unboundedPart(platforms(1, 1).view()), nullptr);
  EXPECT_NE(unboundedPart(platforms(1, 1, [](auto p) { p.setAnchored(false); }).view()), nullptr);
  const auto pad = [](schema::Part::Builder p) {
    support::set(p.initJumpPad().initVelocity(), {40, 40, 0});
    p.getJumpPad().setKeepSideways(true);
  };
  EXPECT_NE(unboundedPart(platforms(1, 1, pad).view()), nullptr);
}

}  // namespace
}  // namespace obby::solve
