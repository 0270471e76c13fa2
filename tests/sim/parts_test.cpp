// Effects of parts on a player: kill, damage, conveyors, pads, vanishing, motion and spin.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::Outcome;
using sim::State;
using support::LevelBuilder;

void key(schema::MotionKey::Builder k, float time, Vec3 at) {
  k.setTime(time);
  support::set(k.initPosition(), at);
}

TEST(Kill, standing_on_a_kill_part_kills_and_names_it) {
  const auto level =
      floorLevel().block({0, 0.5f, -10}, {10, 1, 4}, [](auto p) { p.initKill(); }).compile();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  EXPECT_EQ(play.world.outcome, Outcome::killed);
  EXPECT_EQ(play.world.part, 1u);
}

TEST(Kill, walking_past_at_three_studs_is_safe_and_arms_touch_at_one_and_a_half) {
  const auto outcome = [](float x) {
    const auto level =
        floorLevel().block({x + 0.5f, 5, -10}, {1, 10, 4}, [](auto p) { p.initKill(); }).compile();
    Play play(level);
    play.settle().run(walk(kNorth), 90);
    return play.world.outcome;
  };
  EXPECT_EQ(outcome(3.0f), Outcome::running);
  EXPECT_EQ(outcome(1.5f), Outcome::killed);
}

TEST(Kill, touch_only_parts_kill_without_stopping) {
  const auto level = floorLevel()
                         .block({0, 2, -10}, {10, 4, 1},
                                [](auto p) {
                                  p.initKill();
                                  p.setSolid(false);
                                })
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  EXPECT_EQ(play.world.outcome, Outcome::killed);
}

// Returns true if a part of this shape, which begins at x = 10, kills a player who stands at `x`.
bool killedByRoot(float x, schema::Shape shape = schema::Shape::BLOCK, float height = 3) {
  const auto level = floorLevel()
                         .block({14, height, 0}, {8, 4, 8},
                                [=](schema::Part::Builder p) {
                                  p.initKill(), p.setByRoot(true), p.setSolid(false),
                                      p.setShape(shape);
                                })
                         .compile();
  Play play(level, {x, 0, 0});
  play.run(stand(), 30);
  return play.world.outcome == sim::Outcome::killed;
}

TEST(Kill, by_the_root_counts_its_centre_and_no_limb) {
  EXPECT_FALSE(killedByRoot(9.9f)) << "arms and torso are inside";
  EXPECT_TRUE(killedByRoot(10.1f));
  EXPECT_TRUE(killedByRoot(10.1f, schema::Shape::BLOCK, 4.9f)) << "the root's centre is at 3";
  EXPECT_FALSE(killedByRoot(10.1f, schema::Shape::BLOCK, 5.1f)) << "the head is inside";
  EXPECT_FALSE(killedByRoot(11, schema::Shape::BALL)) << "a ball of radius 2";
  EXPECT_TRUE(killedByRoot(12.1f, schema::Shape::BALL));
}

TEST(Kill, by_the_root_ignores_a_floor_that_kills) {
  const auto level = LevelBuilder()
                         .block({0, -1, 0}, {20, 2, 20},
                                [](schema::Part::Builder p) { p.initKill(), p.setByRoot(true); })
                         .compile();
  Play play(level);
  play.run(stand(), 60);
  EXPECT_EQ(play.world.outcome, sim::Outcome::running);
}

TEST(Kill, parts_without_touch_do_not_kill) {
  const auto level = floorLevel()
                         .block({0, 0.5f, -10}, {10, 1, 4},
                                [](auto p) {
                                  p.initKill();
                                  p.setTouch(false);
                                })
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  EXPECT_EQ(play.world.outcome, Outcome::running);
}

TEST(Kill, damage_parts_hurt_once_a_cooldown_and_health_comes_back) {
  const auto level = floorLevel()
                         .block({0, 2, 0}, {10, 4, 10},
                                [](auto p) {
                                  p.initKill().setDamage(30);
                                  p.getKill().setCooldown(1);
                                  p.setSolid(false);
                                })
                         .compile();
  Play play(level);
  play.run(stand(), 30);
  EXPECT_NEAR(play.world.health, 70, 1);
  play.run(stand(), 60);
  EXPECT_NEAR(play.world.health, 41, 1.5f);
  play.run(stand(), 120);
  EXPECT_EQ(play.world.outcome, Outcome::killed);
}

TEST(Conveyor, carries_a_standing_player_at_its_speed) {
  const auto level = LevelBuilder()
                         .block({0, -1, 0}, {200, 2, 200},
                                [](auto p) {
                                  support::set(p.initConveyor().initVelocity(), {10, 0, 0});
                                })
                         .compile();
  Play play(level);
  play.settle();
  const float from = play.world.position.x;
  play.run(stand(), 60);
  EXPECT_NEAR(play.world.position.x - from, 10, 0.2f);
}

TEST(JumpPad, throws_a_player_who_lands_on_it) {
  const auto level = floorLevel()
                         .block({0, 0.5f, -10}, {6, 1, 6},
                                [](auto p) {
                                  support::set(p.initJumpPad().initVelocity(), {0, 100, 0});
                                })
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 100);
  EXPECT_NEAR(play.highest(), 1 + 100 * 100 / (2 * 196.2f), 1.5f);
  EXPECT_EQ(play.world.jumps, 0) << "a pad is no jump";
}

TEST(Vanish, touched_part_stays_for_its_delay_is_away_and_comes_back) {
  const auto level = LevelBuilder()
                         .block({0, -1, 0}, {6, 2, 6},
                                [](auto p) {
                                  p.initVanish().setDelay(0.5f);
                                  p.getVanish().setAway(2);
                                })
                         .block({0, -21, 0}, {40, 2, 40})
                         .compile();
  Play play(level);
  const int fell = play.until(stand(), [](const sim::World& w) { return w.position.y < -1; });
  EXPECT_GT(float(fell) * kTick, 0.5f);
  EXPECT_LT(float(fell) * kTick, 0.85f);
  EXPECT_EQ(play.world.clockCount, 1);
  play.run(stand(), 150);
  EXPECT_EQ(play.world.clockCount, 0) << "back after its time";
}

TEST(Vanish, timer_part_is_solid_in_its_phase_only) {
  const auto level = LevelBuilder()
                         .block({0, -1, 0}, {6, 2, 6},
                                [](auto p) {
                                  auto v = p.initVanish();
                                  v.setTrigger(schema::VanishTrigger::TIMER);
                                  v.setDelay(2);
                                  v.setAway(1);
                                })
                         .compile();
  Play play(level);
  play.run(stand(), 115);
  EXPECT_NEAR(play.world.position.y, 0, 0.05f);
  play.run(stand(), 30);
  EXPECT_LT(play.world.position.y, -1);
}

LevelBuilder blinking(float phase) {
  return LevelBuilder().block({0, -1, 0}, {6, 2, 6}, [=](Part::Builder p) {
    auto v = p.initVanish();
    v.setTrigger(schema::VanishTrigger::TIMER);
    v.setDelay(2);
    v.setAway(1);
    v.setPhase(phase);
  });
}

TEST(Vanish, a_negative_phase_counts_back_from_the_end_of_the_period) {
  const uint64_t expected = blinking(2.5f).compile().hash();
  for (const float phase : {-0.5f, -3.5f, -6.5f}) {
    EXPECT_EQ(blinking(phase).compile().hash(), expected) << phase;
  }
  EXPECT_EQ(blinking(-3).compile().hash(), blinking(0).compile().hash());
  const auto level = blinking(-0.5f).compile();
  Play play(level);
  play.run(stand(), 25);
  EXPECT_LT(play.world.position.y, -1) << "away for half a second";
}

LevelBuilder platform(bool carries, Vec3 to) {
  return LevelBuilder().block({0, -1, 0}, {8, 2, 8}, [=](Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(carries);
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    key(keys[0], 0, {0, -1, 0});
    key(keys[1], 4, to);
  });
}

TEST(Motion, carrying_platform_takes_the_player_along) {
  const auto level = platform(true, {20, -1, 0}).compile();
  Play play(level);
  play.run(stand(), 200);
  EXPECT_NEAR(play.world.position.x, 20 * 200 / 240.0f, 1.0f);
  EXPECT_EQ(play.world.state, State::running);
}

TEST(Motion, platform_moved_by_script_slides_away_under_the_player) {
  const auto level = platform(false, {20, -1, 0}).compile();
  Play play(level);
  play.run(stand(), 150);
  EXPECT_LT(absf(play.world.position.x), 0.5f);
  EXPECT_LT(play.world.position.y, -1) << "left behind, falls";
}

TEST(Motion, rising_platform_lifts_the_player_either_way) {
  for (const bool carries : {false, true}) {
    const auto level = platform(carries, {0, 19, 0}).compile();
    Play play(level);
    play.run(stand(), 120);
    EXPECT_NEAR(play.world.position.y, 10, 0.5f) << carries;
  }
}

TEST(Motion, moving_wall_pushes_the_player) {
  const auto level = floorLevel()
                         .block({-10, 5, 0}, {2, 10, 10},
                                [](auto p) {
                                  auto keys = p.initMotion().initKeys(2);
                                  key(keys[0], 0, {-10, 5, 0});
                                  key(keys[1], 4, {10, 5, 0});
                                  p.getMotion().setRepeat(schema::Repeat::ONCE);
                                })
                         .compile();
  Play play(level);
  play.run(stand(), 300);
  EXPECT_GT(play.world.position.x, 11);
}

TEST(Motion, spinning_carrier_turns_the_player_with_it) {
  const auto level = LevelBuilder()
                         .block({0, -1, 0}, {30, 2, 30},
                                [](auto p) {
                                  p.initMotion().initSpin().setSpeed(1);
                                  p.getMotion().setCarries(true);
                                })
                         .compile();
  Play play(level, {5, 0, 0});
  play.run(stand(), 60);
  const Vec3 at = play.world.position;
  EXPECT_NEAR(sqrtf32(at.x * at.x + at.z * at.z), 5, 0.5f);
  EXPECT_NEAR(radiansFromTurns(play.world.yaw), 1, 0.15f);
  EXPECT_LT(at.z, -3) << "counter-clockwise from above: +X goes toward -Z";
}

// Expects a player on a floor that turns at `speed` rad/s about the origin to keep the floor's
// speed and go round once.
void expectToTurnAlong(const level::Level& level, float radius, float speed, float drift) {
  Play play(level, {radius, 0, 0});
  play.world.velocity = {0, 0, -speed * radius};
  const int ticks = int(2 * kPi / speed * 60 + 0.5f);
  for (int i = 0; i < ticks; ++i) {
    play.run(stand());
    const Vec3 v = play.world.velocity, at = play.world.position;
    ASSERT_EQ(play.world.floorlessSteps, 0) << "tick " << i;
    if (i < 10) continue;  // still landing
    ASSERT_GT(length(Vec3{v.x, 0, v.z}), 0.97f * speed * length(Vec3{at.x, 0, at.z})) << i;
  }
  EXPECT_NEAR(play.world.position.x, radius, drift);
  EXPECT_NEAR(play.world.position.z, 0, 2);
}

void setSpin(Part::Builder p, float speed, Vec3 pivot = {}) {
  p.initMotion().setCarries(true);
  p.getMotion().initSpin().setSpeed(speed);
  support::set(p.getMotion().getSpin().initPivot(), pivot);
}

// The drive follows a turning floor with a lag: the player drifts outwards by about a stud a turn.
TEST(Motion, carriers_that_turn_fast_take_the_player_round) {
  const auto disc =
      LevelBuilder().block({0, -1, 0}, {40, 2, 40}, [](auto p) { setSpin(p, 3); }).compile();
  expectToTurnAlong(disc, 12, 3, 2);
}

TEST(Motion, carriers_about_a_far_pivot_take_the_player_round) {
  const auto arm = LevelBuilder()
                       .block({20, -1, 0}, {8, 2, 8},
                              [](auto p) {
                                setSpin(p, 2, {-20, 0, 0});
                              })
                       .compile();
  expectToTurnAlong(arm, 20, 2, 2);
}

// Within a tick, a conveyor moves the player straight on, without turning the motion.
TEST(Conveyor, a_fast_turning_conveyor_carries_the_player_round) {
  const auto disc = LevelBuilder()
                        .block({0, -1, 0}, {40, 2, 40},
                               [](auto p) {
                                 support::set(p.initConveyor().initAngular(), {0, 3, 0});
                               })
                        .compile();
  expectToTurnAlong(disc, 12, 3, 4.5f);
}

TEST(Motion, spinning_bar_of_kill_parts_hits_a_player_who_stands_in_its_way) {
  const auto level = floorLevel()
                         .block({0, 2, -8}, {30, 1, 1},
                                [](auto p) {
                                  p.initMotion().initSpin().setSpeed(2);
                                  p.initKill();
                                })
                         .compile();
  Play play(level);
  play.run(stand(), 200);
  EXPECT_EQ(play.world.outcome, Outcome::killed);
}

}  // namespace
}  // namespace obby::test
