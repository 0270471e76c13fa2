// The wide tick equals the scalar tick bit for bit in every world, whatever is near the player.
#include "sim/wide_tick.h"

#include <gtest/gtest.h>

#include <vector>

#include "golden/scenes.h"
#include "sim/simulator.h"
#include "sim/tick.h"
#include "support/level_builder.h"
#include "support/walker.h"

namespace obby::sim {
namespace {

using support::LevelBuilder;
using support::Walker;

struct Scene {
  const char* name;
  level::Level (*build)();
  double minContact;           // share of ticks with a part to collide with
  double maxSingle;            // share of ticks that may fall back to the scalar tick
  uint16_t tricks = 0;         // Params::tricks
  uint16_t directionStep = 0;  // Params::directionStep
};

level::Level arena() { return support::boxArena(60, 5).compile(); }
level::Level moving() { return support::movingArena(30, 14, 4).compile(); }
level::Level course() { return support::platformCourse(30, 2).compile(); }

LevelBuilder everything() {
  LevelBuilder b = support::boxArena(40, 9);
  b.block({0, 0.25f, 10}, {6, 0.5f, 6}, [](auto p) { p.initKill().setDamage(30); });
  b.block({10, 0.25f, 0}, {4, 0.5f, 4}, [](auto p) {
    support::set(p.initJumpPad().initVelocity(), {0, 80, 0});
  });
  b.block({-10, 0.25f, 0}, {8, 0.5f, 8}, [](auto p) {
    support::set(p.initConveyor().initVelocity(), {9, 0, 0});
  });
  b.part([](auto p) {
    support::set(p.initPosition(), {5, 2, 5});
    support::set(p.initSize(), {5, 5, 5});
    p.setShape(schema::Shape::BALL);
  });
  b.part([](auto p) {
    support::set(p.initPosition(), {-6, 1, 6});
    support::set(p.initSize(), {4, 2, 8});
    p.setShape(schema::Shape::WEDGE);
  });
  return b;
}
// Returns a level with posts that only limbs can touch, walls, and a conveyor faster than any walk.
level::Level hazards() {
  LevelBuilder b = support::boxArena(40, 11);
  for (int i = 0; i < 49; ++i) {
    const Vec3 at{float(i % 7 - 3) * 7, 2, float(i / 7 - 3) * 7};
    b.block(at, {0.5f, 4, 0.5f}, [](auto p) { p.initKill().setDamage(1); });
  }
  b.block({0, 0.5f, 14}, {60, 1, 5}, [](auto p) {
    support::set(p.initConveyor().initVelocity(), {90, 0, 0});
  });
  return b.compile();
}
level::Level mixed() { return everything().compile(); }
level::Level touched() { return golden::clocks().compile(); }
level::Level held() { return golden::places().compile(); }

// Returns start worlds all over the level, so that some fall out, land on edges or begin inside
// parts.
std::vector<World> startsOver(const level::Level& level, uint32_t count) {
  Random random(3, count);
  std::vector<World> worlds;
  for (uint32_t i = 0; i < count; ++i) {
    level::StartPose start = level.spawns()[0];
    const float side = 60;
    start.feet +=
        Vec3{(random.unit() - 0.5f) * side, random.unit() * 8 - 4, (random.unit() - 0.5f) * side};
    start.yaw = random.unit() * 6;
    worlds.push_back(makeWorld(level.view(), start));
    worlds.back().health = 20 + 80 * random.unit();
  }
  return worlds;
}

class WideTick : public testing::TestWithParam<Scene> {};

// 100 worlds do not fill all lanes. 700 ticks cover walks, falls, pushes and deaths.
TEST_P(WideTick, EqualsTheScalarTickBitForBit) {
  const level::Level level = GetParam().build();
  level::LevelView view = level.view();
  view.params.tricks = GetParam().tricks;
  view.params.directionStep = GetParam().directionStep;
  view.params.directionFrom = 1234;
  for (const uint32_t count : {1u, 5u, 100u, 300u}) {
    std::vector<World> wide = startsOver(level, count), single = wide;
    std::vector<World*> pointers;
    for (World& w : wide) pointers.push_back(&w);
    std::vector<Walker> walkers;
    for (uint32_t i = 0; i < count; ++i) walkers.push_back({Random(7, i), {}, 0});
    std::vector<Action> actions(count);
    WideCounts counts;
    for (int t = 0; t < 700; ++t) {
      for (uint32_t i = 0; i < count; ++i) actions[i] = walkers[i].next();
      tickAll(view, pointers.data(), nullptr, actions.data(), count, &counts);
      for (uint32_t i = 0; i < count; ++i) {
        tick(single[i], nullptr, view, actions[i]);
        ASSERT_EQ(stateHash(wide[i]), stateHash(single[i])) << "world " << i << ", tick " << t;
      }
    }
    EXPECT_EQ(counts.ticks, 700u * count);
    if (count < 100) continue;
    EXPECT_GE(double(counts.contact), double(counts.ticks) * GetParam().minContact);
    EXPECT_LE(double(counts.single), double(counts.ticks) * GetParam().maxSingle);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, WideTick,
    testing::Values(Scene{"arena", arena, 0.1, 0.05}, Scene{"course", course, 0, 0.05},
                    Scene{"keyboard", course, 0, 0.05, 0, 8192}, Scene{"moving", moving, 0.1, 0.05},
                    Scene{"hazards", hazards, 0.1, 0.3}, Scene{"mixed", mixed, 0.02, 0.7},
                    Scene{"touched", touched, 0, 1}, Scene{"held", held, 0, 1},
                    Scene{"arena_with_tricks", arena, 0.1, 0.05, kAllTricks},
                    Scene{"mixed_with_tricks", mixed, 0.02, 0.7, kAllTricks}),
    [](const auto& scene) { return std::string(scene.param.name); });

TEST(WideTick, LeavesEndedWorldsAlone) {
  const level::Level level = arena();
  World ended = makeWorld(level.view(), level.spawns()[0]), running = ended;
  ended.outcome = Outcome::goal;
  const uint64_t before = stateHash(ended);
  World* worlds[] = {&ended, &running};
  const Action actions[2] = {};
  tickAll(level.view(), worlds, nullptr, actions, 2);
  EXPECT_EQ(stateHash(ended), before);
  EXPECT_EQ(running.tick, 1u);
}

// With a sleep time of 0, a body that is slow falls asleep at once. In the air the body stays
// awake, both when it begins to fall and at the apex of a throw.
TEST(WideTick, LetsDynamicBodiesSleepOnlyAtRest) {
  const level::Level level = LevelBuilder()
                                 .block({0, -1, 0}, {200, 2, 200})
                                 .block({0, 20, 0}, {4, 4, 4}, [](auto p) { p.setAnchored(false); })
                                 .spawn({0, 0, 60})
                                 .physics([](auto p) { p.setSleepTime(0); })
                                 .compile();
  for (const float up :
       {0.0f, 196.2f / 6}) {  // in the second throw the body has no speed after ten ticks
    World wide = makeWorld(level.view(), level.spawns()[0]), single = wide;
    std::vector<RigidBody> wideBodies = makeBodies(level.view());
    wideBodies[0].velocity.y = up;
    std::vector<RigidBody> singleBodies = wideBodies;
    World* worlds[] = {&wide};
    RigidBody* bodies[] = {wideBodies.data()};
    const Action action{};
    WideCounts counts;
    for (int t = 0; t < 120; ++t) {
      tickAll(level.view(), worlds, bodies, &action, 1, &counts);
      tick(single, singleBodies.data(), level.view(), action);
      ASSERT_EQ(stateHash(wide, wideBodies), stateHash(single, singleBodies))
          << up << ", tick " << t;
    }
    EXPECT_NEAR(wideBodies[0].position.y, 2, 0.03f) << up;
    EXPECT_EQ(wideBodies[0].state, RigidBodyState::asleep) << up;
    EXPECT_GT(counts.bodiesInLanes, 0u);
  }
}

// Compares one tick by both functions. `single` is the number of worlds that tickAll() leaves to
// the scalar tick. The default action stands still.
World expectAlike(const level::Level& level, World wide, uint32_t single, Action action = {}) {
  World alone = wide;
  World* worlds[] = {&wide};
  WideCounts counts;
  tickAll(level.view(), worlds, nullptr, &action, 1, &counts);
  tick(alone, nullptr, level.view(), action);
  EXPECT_EQ(counts.single, single);
  EXPECT_EQ(stateHash(wide), stateHash(alone));
  return wide;
}

// Lanes do not support the Climbing state: a climber takes the scalar tick even if its truss is out
// of reach.
TEST(WideTick, LeavesClimbersToTheScalarTick) {
  const level::Level level = arena();
  World wide = makeWorld(level.view(), level.spawns()[0]);
  wide.state = State::climbing;
  EXPECT_EQ(expectAlike(level, wide, 1).state, State::freefall);
}

// One conveyor moves upwards, and one turns on a moving part.
TEST(WideTick, StandsOnBeltsAsTheScalarTickDoes) {
  const level::Level up = LevelBuilder()
                              .block({0, 9, 0}, {40, 2, 40},
                                     [](auto p) {
                                       support::set(p.initConveyor().initVelocity(), {0, 8, 0});
                                     })
                              .spawn({0, 10, 0})
                              .compile();
  const level::Level turning = LevelBuilder()
                                   .block({0, -1, 0}, {60, 2, 60},
                                          [](auto p) {
                                            support::set(p.initConveyor().initAngular(), {0, 2, 0});
                                            auto keys = p.initMotion().initKeys(2);
                                            support::set(keys[0].initPosition(), {0, -1, 0});
                                            support::set(keys[1].initPosition(), {60, -1, 0});
                                            keys[1].setTime(10);
                                          })
                                   .spawn({12, 0, 0})
                                   .compile();
  for (const level::Level* level : {&up, &turning}) {
    World w = makeWorld(level->view(), level->spawns()[0]);
    for (int t = 0; t < 30; ++t) w = expectAlike(*level, w, 0);
  }
}

TEST(WideTick, SaturatesTheJumpCount) {
  const level::Level level =
      LevelBuilder().block({0, -1, 0}, {20, 2, 20}).spawn({0, 0, 0}).compile();
  World w = makeWorld(level.view(), level.spawns()[0]);
  w.state = State::running;
  w.floorlessSteps = 0;
  for (const uint16_t before : {uint16_t(0xfffe), uint16_t(0xffff)}) {
    w.jumps = before;
    EXPECT_EQ(expectAlike(level, w, 0, {0, false, true}).jumps, 0xffff) << before;
  }
}

// The scalar tick first checks whether any floor is below. This check must find floors at the very
// end of the rays.
TEST(WideTick, SensesFloorsAtTheEndOfTheRays) {
  const level::Level edge = LevelBuilder()
                                .block({0, 2.7817647457f, 0}, {20, 2, 20})
                                .spawn({0, 4.781764984f, 0})
                                .compile();
  World w = makeWorld(edge.view(), edge.spawns()[0]);
  w.velocity.y = 10;
  w.state = State::jumping;
  w.flags |= kFloorSensed;
  expectAlike(edge, w, 0);
  const level::Level far = LevelBuilder()
                               .block({0, -1, 0}, {20, 2, 20})
                               .spawn({0, 0.5f, 0})
                               .physics([](auto p) {
                                 p.setFloorKeep(1);
                                 p.setFloorAcquire(1.4f);
                               })
                               .compile();
  expectAlike(far, makeWorld(far.view(), far.spawns()[0]), 0);
}

}  // namespace
}  // namespace obby::sim
