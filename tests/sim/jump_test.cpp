// Jumping and falling. Each test checks a published fact (docs/physics.md).
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using sim::State;

TEST(Jump, flat_air_time_is_0_54_seconds) {
  const auto level = flatLevel();
  Play play(level);
  play.settle().run(stand(true), 1);
  const int ticks =
      play.until(stand(), [](const sim::World& w) { return w.state == State::landed; });
  // The legs sense the floor 1.1 studs before the feet reach it, so up to two ticks early.
  EXPECT_NEAR(float(ticks + 1) * kTick, 2 * 53.0f / 196.2f, 2.1f * kTick);
}

TEST(Jump, walking_jump_covers_8_64_studs) {
  const auto level = flatLevel();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  const float from = play.world.position.z;
  play.run(walk(kNorth, true), 1);
  play.until(walk(kNorth),
             [](const sim::World& w) { return w.velocity.y <= 0 && w.position.y < 0.05f; });
  EXPECT_NEAR(from - play.world.position.z, 16 * 2 * 53.0f / 196.2f, 0.3f);
}

// The player starts to walk in the tick of the jump. The test reads the speed after it and four
// ticks later.
TEST(Jump, keys_do_nothing_while_jumping_unless_the_engine_heeds_them) {
  for (const float accel : {0.0f, 120.0f}) {
    const auto level = flatLevel([&](auto p) { p.setJumpAccel(accel); });
    Play play(level);
    play.settle().run(walk(kNorth, true), 1);
    EXPECT_EQ(play.world.state, State::jumping);
    EXPECT_NEAR(-play.world.velocity.z, accel * kTick, 1e-3f);
    play.run(walk(kNorth), 4);
    EXPECT_NE(play.world.state, State::jumping);
    EXPECT_GT(-play.world.velocity.z, 4);
  }
}

TEST(Jump, is_not_possible_in_the_air_without_coyote_time) {
  const auto level = flatLevel();
  Play play(level, {0, 30, 0});
  play.run(stand(true), 20);
  EXPECT_EQ(play.world.jumps, 0);
  EXPECT_LT(play.world.velocity.y, 0);
}

TEST(Jump, held_jump_repeats_0_05_seconds_after_landing) {
  const auto level = flatLevel();
  Play play(level);
  play.settle();
  play.until(stand(true), [](const sim::World& w) { return w.jumps == 1; });
  play.until(stand(true), [](const sim::World& w) { return w.state == State::landed; });
  const int ticks = play.until(stand(true), [](const sim::World& w) { return w.jumps == 2; });
  EXPECT_GE(ticks, 3);  // 0.05 s at 60 Hz
  EXPECT_LE(ticks, 4);
}

TEST(Jump, without_landing_time_the_tick_after_the_landing_jumps) {
  const auto level = flatLevel([](auto p) { p.setLandedTime(0); });
  Play play(level);
  play.settle();
  play.until(stand(true), [](const sim::World& w) { return w.state == State::freefall; });
  play.until(stand(true), [](const sim::World& w) { return w.state != State::freefall; });
  EXPECT_EQ(play.world.state, State::running);
  EXPECT_EQ(play.world.jumps, 1);
  play.run(stand(true), 1);
  EXPECT_EQ(play.world.jumps, 2);
}

TEST(Jump, coyote_jump_works_until_0_113_seconds_off_the_ledge) {
  const auto level = support::LevelBuilder().block({0, -1, 0}, {10, 2, 10}).compile();
  const auto jumpsAfter = [&](int ticksOff) {
    Play play(level);
    play.settle();
    const auto floorless = [](const sim::World& w) { return w.floorlessSteps > 0; };
    play.until(walk(kNorth), floorless);
    play.run(walk(kNorth), ticksOff - 1).run(walk(kNorth, true));
    return play.world.jumps;
  };
  EXPECT_EQ(jumpsAfter(1), 1);
  EXPECT_EQ(jumpsAfter(5), 1);
  EXPECT_EQ(jumpsAfter(6), 0);  // 7 ticks since the floor was last sensed = 0.117 s
}

// A standing player stays Running and jumps. The tick after the last floor contact is too late.
TEST(Jump, coyote_and_grace_times_of_0_end_with_the_floor) {
  struct Times {
    float coyote, grace;
  };
  for (const Times& times : {Times{0, 0.125f}, Times{0.13f, 0}, Times{0, 0}}) {
    const auto set = [&](auto p) {
      p.setCoyoteTime(times.coyote);
      p.setOffFloorGrace(times.grace);
    };
    const auto level = flatLevel(set);
    Play play(level);
    play.settle();
    for (int i = 0; i < 60; ++i) {
      play.run(walk(kNorth));
      ASSERT_EQ(play.world.state, State::running) << "tick " << i;
    }
    play.run(stand(true));
    EXPECT_EQ(play.world.jumps, 1) << times.coyote << ", " << times.grace;
    const auto ledge =
        support::LevelBuilder().block({0, -1, 0}, {10, 2, 10}).physics(set).compile();
    Play late(ledge);
    late.settle();
    late.until(walk(kNorth), [](const sim::World& w) { return w.floorlessSteps > 0; });
    late.run(walk(kNorth, true));
    EXPECT_EQ(late.world.jumps, 0) << times.coyote << ", " << times.grace;
  }
}

TEST(Jump, rising_through_the_floor_rays_does_not_land) {
  const auto level = flatLevel();
  Play play(level);
  play.settle().run(stand(true), 1);
  for (int i = 0; i < 10; ++i) {
    play.run(stand(true));
    EXPECT_NE(play.world.state, State::landed);
  }
  EXPECT_EQ(play.world.jumps, 1);
}

TEST(Jump, ceiling_stops_the_rise) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {40, 2, 40})
                         .block({0, 9, 0}, {40, 2, 40})
                         .compile();
  Play play(level);
  play.settle().run(stand(true), 1).run(stand(), 60);
  EXPECT_LE(play.highest() + 5, 8.1f);  // the head stays below the ceiling
  EXPECT_EQ(play.world.state, State::running);
  EXPECT_NEAR(play.world.position.y, 0, 0.05f);
}

TEST(Fall, lands_on_thin_parts_at_any_fall_speed) {
  for (const float height : {5.0f, 40.0f, 150.0f, 600.0f}) {
    const auto level = support::LevelBuilder().block({0, -0.025f, 0}, {20, 0.05f, 20}).compile();
    Play play(level, {0, height, 0});
    play.run(stand(), 600);
    EXPECT_NEAR(play.world.position.y, 0, 0.05f) << "from " << height;
    EXPECT_EQ(play.world.state, State::running) << "from " << height;
  }
}

TEST(Fall, below_the_fallen_parts_height_ends_the_playthrough) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {4, 2, 4})
                         .physics([](auto p) { p.setFallenPartsHeight(-50); })
                         .compile();
  Play play(level, {30, 0, 0});
  play.run(stand(), 120);
  EXPECT_EQ(play.world.outcome, sim::Outcome::fell);
  const uint32_t tick = play.world.tick;
  play.run(stand(), 5);
  EXPECT_EQ(play.world.tick, tick) << "an ended trajectory stands still";
}

}  // namespace
}  // namespace obby::test
