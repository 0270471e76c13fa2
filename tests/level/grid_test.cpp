// For any position of the feet, the grid lists every collider that the player can touch from there.
#include "level/grid_build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sim/candidates.h"
#include "support/level_builder.h"

namespace obby::level {
namespace {

using support::LevelBuilder;

struct Dice {
  Random random;
  float between(float lo, float hi) { return lo + (hi - lo) * random.unit(); }
  Vec3 vec(Vec3 size) {
    return {between(-size.x, size.x), between(-size.y, size.y), between(-size.z, size.z)};
  }
};

std::vector<uint32_t> listAt(const Grid& grid, Vec3 feet) {
  const int32_t cell = sim::cellOf<float>(grid, feet);
  if (cell < 0) return {};
  const uint32_t* list = grid.lists + grid.cells[cell];
  return {list + 1, list + 1 + list[0]};
}

// Expects the grid to list every collider that meets the player's reach, at any position and speed.
void expectComplete(const Level& level, Dice& dice, int rounds, const Params& player) {
  const LevelView& v = level.view();
  const Box all = grow(level.bounds(), {5, 5, 5});
  size_t met = 0;
  for (int i = 0; i < rounds; ++i) {
    sim::World w{};
    w.position = {dice.between(all.lo.x, all.hi.x), dice.between(all.lo.y, all.hi.y),
                  dice.between(all.lo.z, all.hi.z)};
    if (i % 2) {  // close to a part, where the grid could miss colliders
      const Box b = v.bounds[dice.random.below(v.colliderCount)].box();
      w.position = (b.lo + b.hi) * 0.5f + dice.vec((b.hi - b.lo) * 0.5f + Vec3{8, 12, 8});
    }
    w.velocity = dice.vec({v.maxSideSpeed, v.params.maxFallSpeed, v.maxSideSpeed});
    const Box reach = sim::tickBounds<float>(w.position, w.velocity, player);
    const std::vector<uint32_t> list = listAt(v.grid, w.position);
    ASSERT_TRUE(std::is_sorted(list.begin(), list.end()));
    for (uint32_t c = 0; c < v.colliderCount; ++c) {
      if (!overlaps(v.bounds[c].box(), reach)) continue;
      ++met;
      ASSERT_TRUE(std::binary_search(list.begin(), list.end(), c)) << "round " << i << ", " << c;
    }
  }
  EXPECT_GT(met, 100u);
}
void expectComplete(const Level& level, Dice& dice, int rounds) {
  expectComplete(level, dice, rounds, level.view().params);
}

LevelBuilder scattered(int parts, Vec3 spread, Dice& dice) {
  LevelBuilder b;
  for (int i = 0; i < parts; ++i) {
    const Vec3 size{dice.between(0.5f, 12), dice.between(0.2f, 12), dice.between(0.5f, 12)};
    const float yaw = dice.between(0, 6), pitch = dice.between(-1, 1);
    b.block(dice.vec(spread), size,
            [=](auto p) { support::setRotation(p.initRotation(), yaw, pitch); });
  }
  return b;
}

TEST(Grid, ListsEverythingThePlayerCanMeet) {
  for (uint64_t seed = 0; seed < 6; ++seed) {
    Dice dice{Random(50, seed)};
    const float s = seed % 2 ? 20.0f : 150.0f;
    expectComplete(scattered(120, {s, s / 2, s}, dice).compile(), dice, 1500);
  }
}

TEST(Grid, ListsMovingPartsAlongTheirWholeMotion) {
  Dice dice{Random(51, 0)};
  LevelBuilder b = scattered(30, {60, 20, 60}, dice);
  for (int i = 0; i < 20; ++i) {
    const Vec3 from = dice.vec({60, 20, 60}), to = dice.vec({60, 20, 60});
    b.block(from, {6, 1, 2}, [=](auto p) {
      auto motion = p.initMotion();
      auto keys = motion.initKeys(2);
      support::set(keys[0].initPosition(), from);
      support::set(keys[1].initPosition(), to);
      keys[1].setTime(3);
      motion.initSpin().setSpeed(i % 2 ? 2.0f : 0.0f);
      support::set(motion.getSpin().initPivot(), {4, 0, 0});
    });
  }
  const Level level = b.compile();
  const LevelView& v = level.view();
  expectComplete(level, dice, 1500);
  for (uint32_t c = 0; c < v.colliderCount; ++c) {
    if (!(v.bounds[c].flags & kMoving)) continue;
    for (uint32_t tick = 0; tick < 1000; tick += 3) {
      const Pose pose = moverPose(v.movers[v.colliders[c].mover], tick);
      const Box now = boundsOf(pose, v.colliders[c].shape.half),
                swept = grow(v.bounds[c].box(), {1e-3f, 1e-3f, 1e-3f});
      ASSERT_TRUE(max(now.hi, swept.hi) == swept.hi && min(now.lo, swept.lo) == swept.lo);
    }
  }
}

TEST(Grid, HoldsForFastPlayersAndBigBodies) {
  Dice dice{Random(52, 0)};
  LevelBuilder b = scattered(80, {60, 30, 60}, dice);
  b.physics([](schema::PhysicsParams::Builder p) {
    p.setWalkSpeed(300);
    p.setArmSpan(10);
    p.setBodyTop(9);
    p.setJumpSpeed(400);
    p.setMaxFallSpeed(2000);
    p.setControlRate(30);
  });
  expectComplete(b.compile(), dice, 1500);
}

// A boosted player reaches farther: boosts and triggered movers make the grid's lists longer.
TEST(Grid, HoldsForBoostedPlayers) {
  Dice dice{Random(54, 0)};
  LevelBuilder b = scattered(80, {60, 30, 60}, dice);
  b.block({0, 0, 0}, {4, 1, 4}, [](auto p) {
    p.initBoost().setWalkSpeed(8);
    p.getBoost().setJumpSpeed(6);
    p.getBoost().setJumpMore(30);
  });
  const Level plain = scattered(80, {60, 30, 60}, dice).compile(), level = b.compile();
  EXPECT_GT(level.view().maxSideSpeed, 7 * plain.view().maxSideSpeed);
  sim::World w{};
  w.clocks[0] = {level.view().clockCount - 1, 0};
  w.clockCount = 1;
  const Params boosted = sim::boosted(w, level.view());
  EXPECT_FLOAT_EQ(boosted.walkSpeed, 8 * 16);
  EXPECT_FLOAT_EQ(boosted.jumpSpeed, 6 * 53 + 30);
  expectComplete(level, dice, 1500, boosted);
}

TEST(Grid, StaysSmallWhenPartsAreFarFlung) {
  Dice dice{Random(53, 0)};
  for (const float spread : {5e4f, 9e5f}) {
    const Level level = scattered(60, {spread, spread, spread}, dice).compile();
    const Grid& g = level.view().grid;
    EXPECT_LE(int64_t(g.nx) * g.ny * g.nz, 1 << 21);
    expectComplete(level, dice, 1500);
  }
}

TEST(Grid, IsEmptyFarFromEverything) {
  const Level level = LevelBuilder().block({0, 0, 0}, {4, 1, 4}).compile();
  const Grid& g = level.view().grid;
  for (const Vec3 feet :
       {Vec3{1000, 0, 0}, Vec3{0, -1000, 0}, Vec3{0, 0, 1e6f}, Vec3{-1e6f, 0, 0}}) {
    EXPECT_EQ(sim::cellOf<float>(g, feet), -1);
  }
  EXPECT_EQ(listAt(g, {0, 1, 0}).size(), 1u);
}

TEST(Grid, KeepsEqualListsOnce) {
  const Level level = LevelBuilder().block({0, 0, 0}, {2000, 1, 2000}).compile();
  const Grid& g = level.view().grid;
  std::vector<uint32_t> starts(g.cells, g.cells + size_t(g.nx) * size_t(g.ny) * size_t(g.nz));
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  EXPECT_LE(starts.size(), 2u);
}

}  // namespace
}  // namespace obby::level
