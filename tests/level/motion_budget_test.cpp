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

}  // namespace
}  // namespace obby
