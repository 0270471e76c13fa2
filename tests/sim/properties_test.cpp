// Properties of any level, checked with random levels and random play (rapidcheck). The seed is
// fixed. RC_PARAMS="seed=7 max_success=100000" searches further.
#include <gtest/gtest.h>

#if __has_include(<rapidcheck.h>)
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <numeric>

#include "random_level.h"
#include "sim/batch.h"
#include "sim/host_device.h"
#include "sim/tick.h"
#include "sim/wide_tick.h"

namespace obby::sim {
namespace {

using namespace obby::test;
using support::LevelBuilder;

// rapidcheck reads the variable at the first property, so it is set here.
const int kSeeded = setenv("RC_PARAMS", "seed=20 max_success=400", 0);

constexpr int kThrows = 20;  // throws per level, since compiling a level takes longer
constexpr float kSide = 100;

// Adds a far part that raises the level's limit of sideways speed to 774 studs/s.
void admitSpeed(LevelBuilder& b) {
  b.block({45, 0.1f, 45}, {4, 0.2f, 4}, [](auto p) {
    support::set(p.initJumpPad().initVelocity(), {500, 0, 0});
  });
}

struct Throw {
  Vec3 feet, velocity;
  float yaw;
  uint64_t seed;
};

// Fails unless `holds` is true for two seconds of random play.
template <class Holds>
void staysWhere(const level::LevelView& level, const Throw& thrown, const Holds& holds) {
  World w = makeWorld(level, {thrown.feet, thrown.yaw, 0});
  w.velocity = thrown.velocity;
  for (uint32_t t = 0; t < 120; ++t) {
    tick(w, nullptr, level, actionAt(thrown.seed, t));
    if (!holds(w)) RC_FAIL("passed through in tick " + std::to_string(t));
  }
}

Throw throwOf(const rc::Gen<Vec3>& velocities) {
  return {{}, *velocities, *between(0, 6.28f), *rc::gen::inRange<uint64_t>(0, 100000)};
}

rc::Gen<Vec3> velocityOf(const rc::Gen<float>& x, const rc::Gen<float>& y) {
  return rc::gen::build<Vec3>(rc::gen::set(&Vec3::x, x), rc::gen::set(&Vec3::y, y),
                              rc::gen::set(&Vec3::z, between(-24, 24)));
}

// Returns the root's centre, which decides on which side of a part the player is.
Vec3 rootOf(const World& w) { return w.position + Vec3{0, 3, 0}; }

RC_GTEST_PROP(Properties, NoFallPassesAFloor, ()) {
  const float thick = *extentBetween(0.05f, 2), yaw = *between(0, 6.28f),
              tilt = *between(-0.5f, 0.5f);
  const level::Level level =
      LevelBuilder()
          .block({0, 0, 0}, {kSide, thick, kSide},
                 [=](auto p) { support::setRotation(p.initRotation(), yaw, tilt); })
          .compile();
  const Vec3 up = level.view().colliders[0].pose.rotation.y;
  for (int i = 0; i < kThrows; ++i) {
    Throw thrown = throwOf(velocityOf(between(-24, 24), between(-480, 53)));
    thrown.feet = {0, thick / up.y + *between(0, 60), 0};
    staysWhere(level.view(), thrown, [&](const World& w) {
      return dot(rootOf(w), up) > 0 || length(w.position) > kSide * 0.4f;
    });
  }
}

// Throws players at up to `fastest` studs/s at a wall. The level's jump pads would allow 774.
void throwAtWalls(float fastest) {
  const float thick = *extentBetween(0.05f, 2);
  LevelBuilder b;
  b.block({0, -1, 0}, {kSide, 2, kSide}).block({0, 10, 0}, {thick, 20, kSide});
  admitSpeed(b);
  const level::Level level = b.compile();
  for (int i = 0; i < kThrows; ++i) {
    Throw thrown = throwOf(velocityOf(between(0, fastest), between(-100, 50)));
    thrown.feet = {-thick * 0.5f - *between(1.2f, 8), *between(0, 10), 0};
    staysWhere(level.view(), thrown, [](const World& w) { return w.position.x < 0; });
  }
}

RC_GTEST_PROP(Properties, NoThrowUpTo120StudsASecondPassesAWall, ()) { throwAtWalls(120); }

RC_GTEST_PROP(Properties, NoThrowThatTheLevelAdmitsPassesAWall, ()) { throwAtWalls(774); }

void throwAtCeilings(float fastest) {
  const float thick = *extentBetween(0.05f, 2), height = *between(6, 30);
  const level::Level level = LevelBuilder()
                                 .block({0, -1, 0}, {kSide, 2, kSide})
                                 .block({0, height + thick * 0.5f, 0}, {kSide, thick, kSide})
                                 .compile();
  for (int i = 0; i < kThrows; ++i) {
    Throw thrown = throwOf(velocityOf(between(-24, 24), between(0, fastest)));
    staysWhere(level.view(), thrown,
               [&](const World& w) { return rootOf(w).y < height + thick * 0.5f; });
  }
}

RC_GTEST_PROP(Properties, NoThrowUpTo480StudsASecondPassesACeiling, ()) { throwAtCeilings(480); }

level::Level randomLevel() {
  const auto specs = *rc::gen::container<std::vector<PartSpec>>(partSpecs());
  auto level = compile(specs);
  if (!level) RC_FAIL(level.error().text());
  return *std::move(level);
}

// Returns worlds all over the level, each with its own seed.
std::vector<World> startsIn(const level::Level& level, uint32_t count) {
  Random random(31, count);
  std::vector<World> worlds;
  for (uint32_t i = 0; i < count; ++i) {
    const auto at = [&] { return 40 * random.unit() - 20; };
    worlds.push_back(makeWorld(level.view(), {{at(), at(), at()}, random.unit() * 6, 0}));
  }
  return worlds;
}

RC_GTEST_PROP(Properties, EveryStateIsFinite, ()) {
  const level::Level level = randomLevel();
  const uint64_t seed = *rc::gen::inRange<uint64_t>(0, 100000);
  std::vector<World> worlds = startsIn(level, 16);
  for (uint32_t t = 0; t < 200; ++t) {
    for (size_t i = 0; i < worlds.size(); ++i) {
      tick(worlds[i], nullptr, level.view(), actionAt(seed + i, t));
      RC_ASSERT(isFinite(worlds[i]));
      RC_ASSERT(absf(worlds[i].velocity.y) < 2000);
    }
  }
}

RC_GTEST_PROP(Properties, ARestoredSnapshotGoesOnAsBefore, ()) {
  const level::Level level = randomLevel();
  const uint64_t seed = *rc::gen::inRange<uint64_t>(0, 100000);
  const uint32_t before = *rc::gen::inRange<uint32_t>(0, 200);
  ThreadPool pool(2);
  const auto batch = *makeCpuBatch(courseOf(level.view(), level.spawns()[0]), 8, pool);
  RC_ASSERT(bool(batch->step(before, Actions::walker(seed))));
  const std::vector<World> snapshots = *batch->worlds();
  RC_ASSERT(bool(batch->step(100, Actions::walker(seed))));
  const uint64_t first = *batch->hash();
  RC_ASSERT(bool(batch->restore(0, snapshots)));
  RC_ASSERT(bool(batch->step(100, Actions::walker(seed))));
  RC_ASSERT(*batch->hash() == first);
}

// The GPU's kernel reads tables in its own memory.
RC_GTEST_PROP(Properties, TheKernelGivesTheBitsOfTheLanes, ()) {
  const level::Level level = randomLevel();
  const uint64_t seed = *rc::gen::inRange<uint64_t>(0, 100000);
  ThreadPool pool(2);
  HostDevice device(pool);
  const Course course = courseOf(level.view(), level.spawns()[0]);
  const auto lanes = *makeCpuBatch(course, 8, pool);
  const auto kernel = *makeKernelBatch(course, 8, device);
  RC_ASSERT(bool(lanes->step(200, Actions::walker(seed))));
  RC_ASSERT(bool(kernel->step(200, Actions::walker(seed))));
  RC_ASSERT(*lanes->hash() == *kernel->hash());
}

RC_GTEST_PROP(Properties, TheOrderOfWorldsDoesNotMatter, ()) {
  const level::Level level = randomLevel();
  const uint64_t seed = *rc::gen::inRange<uint64_t>(0, 100000);
  constexpr uint32_t kWorlds = 37;
  std::vector<World> inOrder = startsIn(level, kWorlds), shuffled = inOrder;
  std::vector<uint32_t> order(kWorlds);
  std::iota(order.begin(), order.end(), 0u);
  Random random(seed, 1);
  for (uint32_t i = kWorlds; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::vector<World*> first, second;
  for (uint32_t i = 0; i < kWorlds; ++i) {
    first.push_back(&inOrder[i]);
    second.push_back(&shuffled[order[i]]);
  }
  std::vector<Action> firstActions(kWorlds), secondActions(kWorlds);
  for (uint32_t t = 0; t < 150; ++t) {
    for (uint32_t i = 0; i < kWorlds; ++i) {
      firstActions[i] = actionAt(seed + i, t);
      secondActions[i] = actionAt(seed + order[i], t);
    }
    tickAll(level.view(), first.data(), nullptr, firstActions.data(), kWorlds);
    tickAll(level.view(), second.data(), nullptr, secondActions.data(), kWorlds);
  }
  for (uint32_t i = 0; i < kWorlds; ++i) {
    RC_ASSERT(stateHash(inOrder[i]) == stateHash(shuffled[i]));
  }
}

}  // namespace
}  // namespace obby::sim

#else
TEST(Properties, WantRapidcheck) {
  GTEST_SKIP() << "built without librapidcheck-dev (scripts/setup test)";
}
#endif
