// Walking, stepping, turning, walls and slopes.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using sim::State;

TEST(Walk, standing_settles_at_the_floor) {
  const auto level = flatLevel();
  Play play(level, {0, 1, 0});
  play.settle().run(stand(), 30);
  EXPECT_NEAR(play.world.position.y, 0, 0.01f);
  EXPECT_NEAR(length(play.world.velocity), 0, 0.01f);
}

TEST(Walk, body_turns_to_the_heading) {
  const auto level = flatLevel();
  Play play(level);
  play.settle().run(walk(0x7000), 120);
  EXPECT_EQ(play.world.yaw, 0x7000);
}

TEST(Walk, steps_onto_ledges_up_to_the_leg_length_without_a_jump) {
  for (const float height : {0.5f, 1.0f, 1.9f}) {
    const auto level = support::LevelBuilder()
                           .block({0, -1, 0}, {40, 2, 40})
                           .block({0, height / 2, -15}, {20, height, 10})
                           .compile();
    Play play(level);
    play.settle().run(walk(kNorth), 50).run(stand(), 30);
    EXPECT_NEAR(play.world.position.y, height, 0.05f);
    EXPECT_EQ(play.world.jumps, 0);
  }
}

TEST(Walk, is_stopped_by_a_ledge_higher_than_the_legs) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {40, 2, 40})
                         .block({0, 1.5f, -15}, {20, 3, 10})
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 90);
  EXPECT_NEAR(play.world.position.z, -10 + 0.5f, 0.1f);
  EXPECT_NEAR(play.world.position.y, 0, 0.05f);
}

TEST(Walk, jump_reaches_a_ledge_of_7_studs) {
  const auto tryLedge = [](float height) {
    const auto level = support::LevelBuilder()
                           .block({0, -1, 0}, {40, 2, 80})
                           .block({0, height / 2, -25}, {20, height, 30})
                           .compile();
    Play play(level);
    play.settle().run(walk(kNorth), 40).run(walk(kNorth, true), 1).run(walk(kNorth), 60);
    return play.world.position.y;
  };
  EXPECT_NEAR(tryLedge(7.0f), 7.0f, 0.1f);
  EXPECT_LT(tryLedge(12.0f), 1.0f);
}

TEST(Walk, thin_walls_are_not_walked_through) {
  for (const float speed : {16.0f, 54.0f, 100.0f}) {
    const auto level = support::LevelBuilder()
                           .block({0, -1, 0}, {400, 2, 400})
                           .block({0, 5, -30}, {40, 10, 0.2f})
                           .physics([speed](auto p) { p.setWalkSpeed(speed); })
                           .compile();
    Play play(level);
    play.settle().run(walk(kNorth), 180);
    EXPECT_GT(play.world.position.z, -30) << "at " << speed;
  }
}

TEST(Walk, beam_half_a_stud_wide_carries) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {10, 2, 10})
                         .block({0, -0.25f, -25}, {0.5f, 0.5f, 40})
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 110);
  EXPECT_LT(play.world.position.z, -25);
  EXPECT_NEAR(play.world.position.y, 0, 0.1f);
}

TEST(Walk, overhang_of_0_8_studs_sideways_still_stands) {
  const auto level = support::LevelBuilder().block({0, -1, 0}, {10, 2, 10}).compile();
  Play inside(level, {5.7f, 0, 0});
  inside.run(stand(), 60);
  EXPECT_EQ(inside.world.state, State::running);
  Play outside(level, {5.9f, 0, 0});
  outside.run(stand(), 60);
  EXPECT_EQ(outside.world.state, State::freefall);
}

TEST(Walk, wedge_is_walked_up) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {60, 2, 60})
                         .part([](auto p) {
                           p.setShape(schema::Shape::WEDGE);
                           support::set(p.initPosition(), {0, 3, -12});
                           support::set(p.initSize(), {10, 6, 14});
                           support::setRotation(p.initRotation(), 3.14159265f);  // rises toward -Z
                         })
                         .compile();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  EXPECT_GT(play.world.position.y, 3);
}

TEST(Walk, floor_steeper_than_max_slope_slides_the_player_down) {
  const auto build = [](float maxSlope) {
    return support::LevelBuilder()
        .block({0, 0, 0}, {40, 2, 40},
               [](auto p) { support::setRotation(p.initRotation(), 0, 0.9f); })
        .physics([maxSlope](auto p) { p.setMaxSlope(maxSlope); })
        .compile();
  };
  const auto steep = build(0.7f), walkable = build(1.5f);
  Play slides(steep, {0, 2, 0}), stands(walkable, {0, 2, 0});
  slides.run(stand(), 90);
  stands.run(stand(), 90);
  EXPECT_GT(length(slides.world.position - Vec3{0, 2, 0}), 5);
  EXPECT_LT(length(stands.world.position - Vec3{0, 2, 0}), 2.5f);
}

}  // namespace
}  // namespace obby::test
