// Memory of motion tables: equal spins are stored once, and a level's tables have a bound.
#include <gtest/gtest.h>

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

TEST(MotionBudget, a_level_with_too_many_different_motions_is_refused) {
  const auto level = spinners(2000, 0.01f, 0.0000371f).tryCompile();
  ASSERT_FALSE(level);
  EXPECT_NE(level.error().text().find("all motions together"), std::string::npos)
      << level.error().text();
}

// Nobody meets it, wherever it is.
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

TEST(MotionBudget, ten_minutes_are_ten_minutes_at_any_rate) {
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

TEST(MotionBudget, what_falls_is_named_as_such) {
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
