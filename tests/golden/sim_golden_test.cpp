// Committed state hashes: every compiler, optimisation level, instruction set and thread count must
// give these bits (docs/determinism.md). A change of physics moves them on purpose: then the change
// log says *hash*, and the table is replaced by what the failing test prints.
#include <gtest/gtest.h>

#include <functional>

#include "base/hash.h"
#include "golden/scenes.h"
#include "sim/batch.h"
#include "sim/simulator.h"

namespace obby {
namespace {

using namespace golden;

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
    {"balls", [] { return crowdOf(schema::Shape::BALL); }, 0x6ffbeeae1e196078},
    {"cylinders", [] { return crowdOf(schema::Shape::CYLINDER); }, 0x8186c9db0554ede7},
    {"wedges", [] { return crowdOf(schema::Shape::WEDGE); }, 0x5979a01cf10804e6},
    {"corner wedges", [] { return crowdOf(schema::Shape::CORNER_WEDGE); }, 0x7ce7a44566946cdb},
    {"hulls", hulls, 0x32924da28105269c},
    {"spinners", spinners, 0xae2d35e5d872e84b},
    {"extremes", extremes, 0x1ff27ba8eb7c0b93},
    {"stairs", stairs, 0xb797ad3b66e20dac},
    {"slopes", slopes, 0xadfaa612b58bb749},
    {"pads", pads, 0xaccbd02980951379},
    {"vanishing", vanishing, 0x40593e38b5225205},
    {"killers", killers, 0xb06f9088f09cbd6c},
    {"moving arena", [] { return support::movingArena(40, 12, 8); }, 0xecb53d6af1a8b828},
    {"moving arena, 120 Hz",
     [] {
       return support::movingArena(40, 12, 9).physics([](auto p) {
         p.setControlRate(120);
         p.setSubsteps(2);
       });
     },
     0x3952a2b4a872f904},
    {"clocks", clocks, 0x41391e43be50588b},
    {"places", places, 0xafed111d6072db9f},
    {"loose bodies", looseBodies, 0},
    {"loose stack on a carrying platform", looseStack, 0},
    {"loose arena", [] { return support::looseArena(16, false, 3); }, 0},
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
    std::vector<sim::LooseBody> loose = sim::makeLoose(level.view());
    for (uint32_t t = 0; t < kTicks; ++t) {
      sim::advance(w, loose.data(), level.view(), nullptr, scripted(i, w));
    }
    const uint64_t state = sim::stateHash(w, loose);
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
