// Compares the state hashes of hashes.h with every method of simulation that this machine supports.
#include <gtest/gtest.h>

#include "base/hash.h"
#include "golden/hashes.h"
#include "sim/batch.h"
#include "sim/host_device.h"
#include "sim/simulator.h"

namespace obby {
namespace {

using namespace golden;

uint64_t playedHash(sim::Batch& batch) {
  EXPECT_TRUE(batch.step(kTicks, sim::Actions::walker(kSeed)));
  return *batch.hash();
}

// Returns the hash from SIMD lanes.
uint64_t lanesHash(const level::Level& level, int threads) {
  ThreadPool pool(threads);
  const auto course = sim::courseOf(level.view(), level.spawns()[0]);
  return playedHash(**sim::makeCpuBatch(course, kWorlds, pool));
}

// Returns the hash from the GPU's kernel, which runs on the CPU here.
uint64_t kernelHash(const level::Level& level) {
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  const auto course = sim::courseOf(level.view(), level.spawns()[0]);
  return playedHash(**sim::makeKernelBatch(course, kWorlds, device));
}

// Returns the hash from one world at a time.
uint64_t singlyHash(const level::Level& level) {
  uint64_t h = 0;
  for (uint32_t i = 0; i < kWorlds; ++i) {
    sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
    std::vector<sim::RigidBody> bodies = sim::startBodies(level.view());
    for (uint32_t t = 0; t < kTicks; ++t) {
      sim::advance(w, bodies.data(), level.view(), nullptr, sim::walkerAction(kSeed, i, 0, w.tick));
    }
    const uint64_t state = sim::stateHash(w, bodies);
    h = hashBytes(&state, sizeof state, h);
  }
  return h;
}

class Golden : public testing::TestWithParam<Scene> {};

TEST_P(Golden, state_hash_is_the_committed_one) {
  const Scene& scene = GetParam();
  const level::Level level = scene.build().compile();
  for (const int threads : {1, 3}) {
    const uint64_t hash = lanesHash(level, threads);
    EXPECT_EQ(hash, scene.hash) << "\"" << scene.name << "\" with " << threads
                                << " threads gives 0x" << std::hex << hash;
  }
  EXPECT_EQ(singlyHash(level), scene.hash) << "by the scalar tick";
  EXPECT_EQ(kernelHash(level), scene.hash) << "by the kernel";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(kScenes),
                         [](const auto& scene) { return "scene" + std::to_string(scene.index); });

}  // namespace
}  // namespace obby
