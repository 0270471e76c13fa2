// Tests which parts are in sight, for any number and size of parts.
#include "policy/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "policy/policy.h"
#include "sim/simulator.h"
#include "support/level_builder.h"
#include "support/onlooker.h"

namespace obby::policy {
namespace {

using support::LevelBuilder;

// Returns a start that ends at z = -4, and more ground from z = -9 to -17.
LevelBuilder surroundingsGap() {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {8, 1, 8});
  b.block({0, 0, -13}, {8, 1, 8});
  return b;
}

// A level's parts under a roof of plates of the maximum size, which are too high to be seen.
// Squares of 8 studs would list the plates 132 million times. The level must outlive this object.
struct Roofed {
  explicit Roofed(const level::Level& level) : view(level.view()) {
    bounds.assign(view.bounds, view.bounds + view.colliderCount);
    const Box plate{{-1024, 600, -1024}, {1024, 601, 1024}};
    for (int i = 0; i < 2000; ++i)
      bounds.push_back(level::makeBounds(plate, level::kSolid, uint32_t(bounds.size()), false));
    view.bounds = bounds.data();
    view.colliderCount = uint32_t(bounds.size());
  }
  std::vector<level::Bounds> bounds;
  level::LevelView view;
};

TEST(Surroundings, ManyHugePartsTakeBoundedMemory) {
  const level::Level level = surroundingsGap().compile();
  const Roofed roofed(level);
  const Surroundings around(roofed.view, kSight);
  const SurroundingsView s = around.view();
  EXPECT_LE(s.entryCount, 1u << 24);
  EXPECT_EQ(s.entryCount, s.starts[s.nx * s.nz]);
  EXPECT_LT(s.inverseCell, 1 / 16.0f) << "wider squares";
}

TEST(Surroundings, FewPartsHaveSquaresOfEightStuds) {
  const level::Level level = surroundingsGap().compile();
  const Surroundings around(level.view(), kSight);
  const SurroundingsView s = around.view();
  EXPECT_EQ(s.inverseCell, 1 / 8.0f);
  EXPECT_EQ(s.nx, 5);
  EXPECT_EQ(s.nz, 7);
  EXPECT_EQ(s.entryCount, 5u * 6 + 5u * 5) << "the start, and the ground after the gap";
}

// Returns a policy's observation of a level in these surroundings.
std::vector<float> seenIn(const level::LevelView& level, const Surroundings& around,
                          const sim::World& world) {
  level::QueryView query;
  query.goal.region = {{{0, 0, -30}, {}}, {2, 2, 2}};
  const SurroundingsView squares = around.view();
  std::vector<float> inputs(kInputs);
  observe({level, query, squares}, world, nullptr, inputs.data());
  return inputs;
}

TEST(Surroundings, TheObservationDoesNotDependOnTheSquares) {
  const level::Level level = support::boxArena(60, 7).compile();
  const Roofed roofed(level);
  const Surroundings narrow(level.view(), kSight), wide(roofed.view, kSight);
  sim::World world = sim::makeWorld(level.view(), {});
  Random random(3, 3);
  for (int n = 0; n < 200; ++n) {
    world.position = {60 * random.unit() - 30, 8 * random.unit(), 60 * random.unit() - 30};
    world.yaw = Turns(random.next());
    EXPECT_EQ(seenIn(roofed.view, wide, world), seenIn(level.view(), narrow, world)) << n;
  }
}

TEST(Surroundings, ListAPartInEverySquareThatSeesIt) {
  const level::Level level = support::boxArena(60, 7).compile();
  const level::LevelView view = level.view();
  const Surroundings around(view, kSight);
  const SurroundingsView s = around.view();
  Random random(2, 2);
  for (int n = 0; n < 500; ++n) {
    const Vec3 feet{60 * random.unit() - 30, 2, 60 * random.unit() - 30};
    const float cx = (feet.x - s.origin.x) * s.inverseCell,
                cz = (feet.z - s.origin.z) * s.inverseCell;
    ASSERT_TRUE(cx >= 0 && cz >= 0 && cx < float(s.nx) && cz < float(s.nz));
    const uint32_t cell = uint32_t(cz) * uint32_t(s.nx) + uint32_t(cx);
    const std::vector<uint32_t> listed(s.entries + s.starts[cell], s.entries + s.starts[cell + 1]);
    for (uint32_t i = 0; i < view.colliderCount; ++i) {
      if (!inSight(view.bounds[i].box(), feet)) continue;
      EXPECT_EQ(std::count(listed.begin(), listed.end(), i), 1) << i;
    }
  }
}

// The observation skips all parts from the first overhead one on.
TEST(Surroundings, ListLowerPartsFirst) {
  const level::Level level = support::boxArena(60, 7).compile();
  const level::LevelView view = level.view();
  const Surroundings around(view, kSight);
  const SurroundingsView s = around.view();
  uint32_t pairs = 0;
  for (int cell = 0; cell < s.nx * s.nz; ++cell) {
    for (uint32_t e = s.starts[cell] + 1; e < s.starts[cell + 1]; ++e, ++pairs) {
      EXPECT_LE(view.bounds[s.entries[e - 1]].box().lo.y, view.bounds[s.entries[e]].box().lo.y);
    }
  }
  EXPECT_GT(pairs, 100u);
}

TEST(Surroundings, AreSearchedToTheLastPartInSight) {
  const level::Level levels[] = {support::boxArena(60, 7).compile(),
                                 support::movingArena(60, 14, 2).compile()};
  Random random(4, 4);
  uint32_t overhead = 0;
  for (const level::Level& level : levels) {
    const level::LevelView& view = level.view();
    support::Onlooker look(level);
    for (int n = 0; n < 200; ++n) {
      const Vec3 feet{60 * random.unit() - 30, 8 * random.unit() - 4, 60 * random.unit() - 30};
      look.world.position = feet;
      look.world.tick = random.below(1000);
      std::vector<uint32_t> seen, expected;
      lookAround(look.scene, look.world, nullptr,
                 [&](const Sight& sight) { seen.push_back(sight.collider); });
      std::sort(seen.begin(), seen.end());  // moving parts are listed twice
      seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
      for (uint32_t i = 0; i < view.colliderCount; ++i) {
        if (inSight(view.bounds[i].box(), feet)) expected.push_back(i);
        overhead += isOverhead(view.bounds[i].box(), feet);
      }
      ASSERT_EQ(seen, expected) << n;
    }
  }
  EXPECT_GT(overhead, 100u);
}

}  // namespace
}  // namespace obby::policy
