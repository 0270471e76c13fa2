// Committed state hashes: every compiler, optimisation level, instruction set and thread count must
// give these bits (docs/determinism.md). A change of physics moves them on purpose: then the change
// log says *hash*, and the table is replaced by what the failing test prints.
#include <gtest/gtest.h>

#include <functional>

#include "base/hash.h"
#include "sim/batch.h"
#include "sim/simulator.h"
#include "support/level_builder.h"

namespace obby {
namespace {

using schema::Part;
using support::LevelBuilder;

void key(schema::MotionKey::Builder k, float time, Vec3 at) {
  k.setTime(time);
  support::set(k.initPosition(), at);
}

LevelBuilder floorWith(const LevelBuilder::PartSetter& more) {
  return LevelBuilder().block({0, -1, 0}, {60, 2, 60}, more).spawn({0, 3, 0});
}

LevelBuilder shapes() {
  LevelBuilder b = floorWith({});
  Random random(5, 0);
  for (int i = 0; i < 60; ++i) {
    const float x = 50 * random.unit() - 25, y = 6 * random.unit(), z = 50 * random.unit() - 25;
    const Vec3 size{1 + 5 * random.unit(), 1 + 5 * random.unit(), 1 + 5 * random.unit()};
    const float yaw = 6 * random.unit(), pitch = i % 3 == 0 ? 0 : 3 * random.unit();
    b.block({x, y, z}, size, [=](Part::Builder p) {
      p.setShape(schema::Shape(i % 5));
      support::setRotation(p.initRotation(), yaw, pitch);
    });
  }
  return b;
}

LevelBuilder movers(bool carries) {
  LevelBuilder b = floorWith([](Part::Builder p) { p.initKill().setDamage(1); });
  for (int i = 0; i < 12; ++i) {
    const Vec3 at{float(i % 4) * 8 - 12, 1 + float(i / 4) * 3, float(i / 4) * 9 - 9};
    b.block(at, {5, 1, 5}, [=](Part::Builder p) {
      auto motion = p.initMotion();
      motion.setCarries(carries);
      motion.setRepeat(i % 2 == 0 ? schema::Repeat::PING_PONG : schema::Repeat::LOOP);
      auto keys = motion.initKeys(2);
      key(keys[0], 0, at);
      key(keys[1], 1.3f + float(i) * 0.37f, at + Vec3{6, float(i % 3), -4});
      keys[1].setEasing(schema::Easing(i % 11));
      if (i % 3 == 0) motion.initSpin().setSpeed(0.7f * float(i + 1));
    });
  }
  return b;
}

LevelBuilder roles() {
  LevelBuilder b = floorWith([](Part::Builder p) {
    support::set(p.initConveyor().initVelocity(), {3, 0, 1});
  });
  b.block({6, 0.5f, 0}, {4, 1, 4}, [](Part::Builder p) {
    support::set(p.initJumpPad().initVelocity(), {5, 80, 0});
  });
  b.block({-6, 2, 0}, {4, 1, 4}, [](Part::Builder p) { p.initVanish().setDelay(0.4f); });
  b.block({0, 2, 8}, {4, 1, 4}, [](Part::Builder p) {
    p.initVanish().setTrigger(schema::VanishTrigger::TIMER);
    p.getVanish().setDelay(1);
  });
  b.block({0, 4, -8}, {6, 8, 1}, [](Part::Builder p) {
    p.setSolid(false);
    p.initKill().setDamage(20);
    p.getKill().setCooldown(0.5f);
  });
  b.block({12, 1, 12}, {10, 2, 10}, [](Part::Builder p) { p.setFriction(0.02f); });
  return b;
}

// Trusses to run into all over the place: upright, turned, tilted, hanging, riding, short-lived.
LevelBuilder trusses() {
  LevelBuilder b = floorWith({});
  Random random(12, 0);
  for (int i = 0; i < 40; ++i) {
    const float x = 40 * random.unit() - 20, z = 40 * random.unit() - 20;
    const float height = 4 + 12 * random.unit(), bottom = i % 4 == 3 ? 6.0f : 0.0f;
    const float yaw = 6 * random.unit(), pitch = i % 5 == 4 ? 0.4f : 0.0f;
    const Vec3 at{x, bottom + height / 2, z};
    b.block(at, {2, height, 2}, [=](Part::Builder p) {
      p.setShape(schema::Shape::TRUSS);
      support::setRotation(p.initRotation(), yaw, pitch);
      if (i % 10 == 1) p.initVanish().setDelay(1);
      if (i % 10 != 2) return;
      auto motion = p.initMotion();
      motion.setCarries(true);
      motion.setRepeat(schema::Repeat::PING_PONG);
      auto keys = motion.initKeys(2);
      key(keys[0], 0, at);
      key(keys[1], 3, at + Vec3{3, 2, -2});
    });
  }
  return b;
}

struct Scene {
  const char* name;
  std::function<LevelBuilder()> build;
  uint64_t hash;
};

const Scene kScenes[] = {
    {"arena20", [] { return support::boxArena(20, 1); }, 0x59f08102ca786f17},
    {"arena100", [] { return support::boxArena(100, 2); }, 0xb48d47b0fab4adfa},
    {"arena300", [] { return support::boxArena(300, 3); }, 0xa591d0de4a77c1fb},
    {"course", [] { return support::platformCourse(40, 4); }, 0x3b8d6399c66034c9},
    {"shapes", shapes, 0xf82fccb00464a993},
    {"carriers", [] { return movers(true); }, 0x11e040e87f7fdc16},
    {"scripted movers", [] { return movers(false); }, 0xd86da7cce9918f77},
    {"roles", roles, 0x2d9fc39fad8c4b73},
    {"trusses", trusses, 0x74aed15e7a3fba4a},
    {"low gravity, fast walk",
     [] {
       return support::platformCourse(40, 6).physics([](auto p) {
         p.setGravity(80);
         p.setWalkSpeed(54);
       });
     },
     0x8c5d0960adc3e448},
    {"30 Hz control, 8 substeps",
     [] {
       return support::boxArena(60, 7).physics([](auto p) {
         p.setControlRate(30);
         p.setSubsteps(8);
       });
     },
     0x80f719c644c5868},
};

constexpr size_t kWorlds = 64;
constexpr uint32_t kTicks = 600;

sim::Action scripted(size_t i, const sim::World& w) {
  Random random(11, i * 1000000 + w.tick / 15);
  return {Turns(random.next()), random.below(8) != 0, random.below(3) == 0};
}

uint64_t hashOf(const Scene& scene, int threads) {
  const level::Level level = scene.build().compile();
  ThreadPool pool(threads);
  sim::Batch batch(level.view(), level.spawns()[0], kWorlds);
  batch.step(pool, nullptr, kTicks, scripted);
  return batch.hash();
}

// The same worlds one by one: the batch runs them in SIMD lanes.
uint64_t singlyHashOf(const Scene& scene) {
  const level::Level level = scene.build().compile();
  uint64_t h = 0;
  for (size_t i = 0; i < kWorlds; ++i) {
    sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
    for (uint32_t t = 0; t < kTicks; ++t) {
      sim::advance(w, level.view(), nullptr, scripted(i, w));
    }
    const uint64_t state = sim::stateHash(w);
    h = hashBytes(&state, sizeof state, h);
  }
  return h;
}

class Golden : public testing::TestWithParam<Scene> {};

TEST_P(Golden, state_hash_is_the_committed_one) {
  const Scene& scene = GetParam();
  for (const int threads : {1, 3}) {
    const uint64_t hash = hashOf(scene, threads);
    EXPECT_EQ(hash, scene.hash) << "\"" << scene.name << "\" with " << threads
                                << " threads gives 0x" << std::hex << hash;
  }
  EXPECT_EQ(singlyHashOf(scene), scene.hash) << "by the scalar tick";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(kScenes),
                         [](const auto& scene) { return "scene" + std::to_string(scene.index); });

}  // namespace
}  // namespace obby
