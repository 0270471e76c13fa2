// The memory of motion tables: equal spins are stored once, and a level's tables are bounded.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "level/spin_store.h"
#include "support/level_builder.h"

namespace obby {
namespace {

support::LevelBuilder spinners(int count, float firstSpeed, float step) {
  support::LevelBuilder b;
  for (int i = 0; i < count; ++i) {
    b.block({float(i) * 10, 0, 0}, {4, 1, 4}, [=](schema::Part::Builder p) {
      p.initMotion().initSpin().setSpeed(firstSpeed + float(i) * step);
    });
  }
  return b;
}

TEST(MotionBudget, parts_that_spin_alike_share_one_table) {
  const auto level = spinners(500, 1, 0).compile();
  const level::LevelView& v = level.view();
  ASSERT_EQ(v.moverCount, 500u);
  for (uint32_t i = 1; i < v.moverCount; ++i) EXPECT_EQ(v.movers[i].spins, v.movers[0].spins);
  EXPECT_GT(v.movers[0].spinCount, 0u);
}

TEST(MotionBudget, parts_that_spin_differently_do_not) {
  const auto level = spinners(2, 1, 1).compile();
  EXPECT_NE(level.view().movers[0].spins, level.view().movers[1].spins);
}

// If each table were as long as for a single part, these parts would need about 25 million rows.
TEST(MotionBudget, five_hundred_different_spins_get_shorter_tables) {
  const float first = 0.03f, step = 0.0003f;
  const auto level = spinners(500, first, step).tryCompile();
  ASSERT_TRUE(level) << level.error().text();
  const level::LevelView& v = level->view();
  ASSERT_EQ(v.moverCount, 500u);
  std::set<const Mat3*> tables;
  size_t rows = 0;
  for (uint32_t i = 0; i < v.moverCount; ++i) {
    tables.insert(v.movers[i].spins);
    rows += v.movers[i].spinCount + v.movers[i].keyCount;
    const double ticks = 2 * 3.14159265358979 / double(first + float(i) * step) * 60;
    const double turns = std::round(v.movers[i].spinCount / ticks);
    EXPECT_NEAR(v.movers[i].spinCount / turns, ticks, 0.51) << i;
  }
  EXPECT_EQ(tables.size(), 500u);
  EXPECT_LE(rows, 4000000u);
}

// Shorter tables are less exact. Therefore levels within the budget keep full tables.
TEST(MotionBudget, parts_within_the_budget_keep_full_tables) {
  const auto alone = spinners(1, 0.1f, 0).compile(), many = spinners(40, 0.1f, 0.01f).compile();
  EXPECT_EQ(many.view().movers[0].spinCount, alone.view().movers[0].spinCount);
  EXPECT_GT(alone.view().movers[0].spinCount, 3770u) << "several turns";
}

TEST(MotionBudget, equal_spins_are_stored_once) {
  level::SpinPlan plan;
  plan.speed = 1, plan.rows = 377;
  level::SpinStore store;
  const level::SpinTurns first = store.of(plan, true), again = store.of(plan, true);
  EXPECT_TRUE(first.upright);
  EXPECT_EQ(first.rows.size(), 377u);
  EXPECT_EQ(first.rows.data(), again.rows.data());
  EXPECT_EQ(store.rows(), 377u);
  plan.axis = {1, 0, 0};
  EXPECT_FALSE(store.of(plan, true).upright);
  EXPECT_EQ(store.rows(), 2 * 377u);
  store.of(plan, false);
  EXPECT_EQ(store.rows(), 2 * 377u) << "the same rows, as nothing was to be snapped";
  EXPECT_TRUE(store.of({}, true).upright) << "what does not turn stays as it is";
  const level::SpinStore moved = std::move(store);
  EXPECT_EQ(moved.rows(), 2 * 377u);
  EXPECT_FLOAT_EQ(first.rows[0].y.y, 1);
}

TEST(MotionBudget, a_level_with_too_many_different_motions_is_refused) {
  const auto level = spinners(2000, 0.01f, 0.0000371f).tryCompile();
  ASSERT_FALSE(level);
  EXPECT_NE(level.error().text().find("motions together need more than"), std::string::npos)
      << level.error().text();
}

// No player can touch these parts, wherever they move.
TEST(MotionBudget, scenery_needs_no_tables) {
  support::LevelBuilder b;
  b.block({0, 0, 0}, {4, 1, 4});
  for (int i = 0; i < 2000; ++i) {
    b.block({float(i) * 10, 9, 0}, {4, 1, 4}, [=](schema::Part::Builder p) {
      p.setSolid(false);
      p.initMotion().initSpin().setSpeed(0.01f + float(i) * 0.0000371f);
    });
  }
  const auto level = b.tryCompile();
  ASSERT_TRUE(level) << level.error().text();
  EXPECT_EQ(level->view().moverCount, 0u);
}

TEST(MotionBudget, ten_minutes_are_the_limit_at_any_rate) {
  const auto at = [](uint16_t rate, float speed) {
    support::LevelBuilder b = spinners(1, speed, 0);
    b.physics([=](schema::PhysicsParams::Builder p) { p.setControlRate(rate); });
    return b.tryCompile();
  };
  for (const uint16_t rate : {uint16_t(60), uint16_t(240), uint16_t(480)}) {
    const auto slow = at(rate, 0.02f);  // a turn takes 314 s
    EXPECT_TRUE(slow) << rate << ": " << slow.error().text();
    EXPECT_FALSE(at(rate, 0.005f)) << rate;
  }
}

TEST(MotionBudget, the_error_names_falls) {
  support::LevelBuilder b;
  for (int i = 0; i < 80; ++i) {
    b.block({float(i) * 10, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) {
      p.initFall().setDelay(1100);
      p.getFall().setSeconds(1);
    });
  }
  const auto level = b.tryCompile();
  ASSERT_FALSE(level);
  EXPECT_NE(level.error().path.find(".fall"), std::string::npos) << level.error().text();
}

}  // namespace
}  // namespace obby
