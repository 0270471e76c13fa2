// Climbing of trusses. Each test checks a fact of docs/physics.md.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::State;
using support::LevelBuilder;

constexpr Turns kSouth = 0x8000;  // +Z
constexpr float kFace = -4;       // z of the +Z face of the trusses below
constexpr float kClimb = 0.7f * 16;

void asTruss(Part::Builder p) { p.setShape(schema::Shape::TRUSS); }

// Returns a floor at height 0, and a truss from `bottom` to `top`.
LevelBuilder tower(float top, const LevelBuilder::PartSetter& more = asTruss, float bottom = 0) {
  return LevelBuilder()
      .block({0, -1, 0}, {400, 2, 400})
      .block({0, 0.5f * (top + bottom), kFace - 1}, {2, top - bottom, 2}, more);
}

bool climbs(const sim::World& w) { return w.state == State::climbing; }
bool runs(const sim::World& w) { return w.state == State::running; }

int entries(const Play& play) {
  int count = 0;
  for (size_t i = 1; i < play.history.size(); ++i) {
    count += climbs(play.history[i]) && !climbs(play.history[i - 1]);
  }
  return count;
}

// Lets the player climb to `height` studs.
void hang(Play& play, float height = 10) {
  play.settle();
  const auto there = [&](const sim::World& w) { return climbs(w) && w.position.y > height; };
  ASSERT_GE(play.until(walk(kNorth), there), 0);
  play.run(stand(), 20);
}

TEST(Climb, is_at_0_7_of_the_walk_speed) {
  const auto level = tower(40).compile();
  Play play(level);
  play.settle();
  ASSERT_GT(play.until(walk(kNorth), climbs), 0);
  const float from = play.run(walk(kNorth), 10).world.position.y;
  play.run(walk(kNorth), 60);
  EXPECT_NEAR(play.world.position.y - from, kClimb, 0.01f);
}

TEST(Climb, starts_where_the_face_is_within_reach_of_the_root_centre) {
  const auto level = tower(40).compile();
  for (const float distance : {1.1f, 1.19f, 1.21f, 1.3f}) {
    Play play(level, {0, 8, kFace + distance});
    play.run(walk(kNorth));
    EXPECT_EQ(climbs(play.world), distance < 1.2f) << distance;
  }
}

TEST(Climb, holds_still_without_a_key) {
  const auto level = tower(40).compile();
  Play play(level);
  hang(play);
  const Vec3 from = play.world.position;
  play.run(stand(), 60);
  EXPECT_EQ(play.world.state, State::climbing);
  EXPECT_EQ(play.world.position, from);
}

TEST(Climb, goes_down_when_backing_and_walks_off_at_the_floor) {
  const auto level = tower(40).compile();
  Play play(level);
  hang(play);
  const float from = play.world.position.y;
  play.run(walk(kSouth), 30);
  EXPECT_NEAR(from - play.world.position.y, kClimb / 2, 0.04f);
  EXPECT_LT(play.world.yaw, 46);  // still facing the truss
  ASSERT_GT(play.until(walk(kSouth), runs), 0);
  EXPECT_NEAR(play.world.position.y, 0, 1.1f);
  play.run(walk(kSouth), 30);
  EXPECT_EQ(play.world.state, State::running);
  EXPECT_NEAR(play.world.position.y, 0, 0.01f);
  EXPECT_GT(play.world.position.z, kFace + 4);
  EXPECT_EQ(play.world.jumps, 0);
}

TEST(Climb, turns_the_player_to_the_face) {
  const auto level = tower(40).compile();
  Play play(level, {-0.8f, 0, kFace + 1.5f}, -0.6f);  // looks at the truss from the left
  play.settle();
  const Turns oblique = turnsFromRadians(-0.6f);
  ASSERT_GE(play.until(walk(oblique), climbs, 60), 0);
  play.run(walk(oblique), 40);
  EXPECT_EQ(play.world.state, State::climbing);
  EXPECT_EQ(play.world.yaw, kNorth);
  EXPECT_GT(play.world.position.y, 6);
}

// The forward key alone leads over the edge, without a fall back, a second grip or a jump.
TEST(Climb, holding_forward_ends_on_top_of_20_studs) {
  for (const float speed : {4.0f, 10.0f, 16.0f, 20.0f}) {
    for (const float top : {3.0f, 6.0f, 20.0f, 20.3f, 20.6f}) {
      const auto level = tower(top).physics([=](auto p) { p.setWalkSpeed(speed); }).compile();
      Play play(level);
      play.settle();
      const auto onTop = [=](const sim::World& w) { return runs(w) && w.position.y > top - 0.4f; };
      ASSERT_GE(play.until(walk(kNorth), onTop, 900), 0) << speed << ", " << top;
      EXPECT_EQ(entries(play), 1) << speed << ", " << top;
      EXPECT_LT(play.highest(), top + 0.1f) << speed << ", " << top;
      play.run(stand(), 60);
      EXPECT_NEAR(play.world.position.y, top, 0.01f) << speed << ", " << top;
      EXPECT_EQ(play.world.state, State::running);
      EXPECT_EQ(play.world.jumps, 0);
    }
  }
}

TEST(Climb, leads_past_the_top_onto_the_floor_beyond) {
  const auto level = tower(20).block({0, 19, kFace - 10}, {16, 2, 16}).compile();
  Play play(level);
  play.settle();
  play.run(walk(kNorth), 170);
  EXPECT_EQ(play.world.state, State::running);
  EXPECT_NEAR(play.world.position.y, 20, 0.01f);
  EXPECT_LT(play.world.position.z, kFace - 2);
}

TEST(Climb, jump_leaves_the_truss_and_counts_once) {
  const auto level = tower(60).compile();
  Play play(level);
  hang(play);
  const float from = play.world.position.y;
  play.run(walk(kSouth, true));
  EXPECT_EQ(play.world.state, State::jumping);
  EXPECT_NEAR(play.world.velocity.y, 53, 4);
  play.until(walk(kSouth), runs);
  EXPECT_EQ(play.world.jumps, 1);
  EXPECT_NEAR(play.highest() - from, 7.27f, 0.02f);
  EXPECT_GT(play.world.position.z, kFace + 6);
}

// The gain is 150/s, so each step leaves 1 - 150 / 240 of the difference in velocity.
TEST(Climb, grips_a_falling_player_within_a_few_steps) {
  const auto level = tower(60).compile();
  Play falls(level, {0, 40, kFace + 1});
  falls.run(stand(), 20);
  const float before = falls.world.velocity.y;
  falls.run(walk(kNorth));
  EXPECT_NEAR(falls.world.velocity.y - kClimb, (before - kClimb) * std::pow(0.375f, 4), 0.01f);
}

// A player who holds the key towards the truss grips it, even during the fast rise of a jump from
// the floor.
TEST(Climb, grips_while_rising) {
  const auto level = tower(60).compile();
  Play play(level, {0, 0, kFace + 2});
  play.settle().run(walk(kNorth, true), 1);
  ASSERT_GE(play.until(walk(kNorth), climbs, 20), 0);
  EXPECT_GT(play.history[play.history.size() - 2].velocity.y, 1.5f * kClimb);
}

TEST(Climb, grips_again_only_where_the_jump_has_slowed_down) {
  const auto level = tower(60).compile();
  Play play(level);
  hang(play);
  const float from = play.world.position.y;
  play.run(walk(kNorth, true));
  const int ticks = play.until(walk(kNorth), climbs);
  EXPECT_EQ(play.world.jumps, 1);
  EXPECT_NEAR(float(ticks), (53 - kClimb) / 196.2f * 60, 2);
  EXPECT_NEAR(play.world.position.y - from, 7.1f, 0.3f);
}

TEST(Climb, catches_a_falling_player_who_holds_toward_the_truss) {
  const auto level = tower(60).compile();
  Play falls(level, {0, 40, kFace + 1});
  falls.run(stand(), 20);
  EXPECT_EQ(falls.world.state, State::freefall) << "without a key";
  falls.run(walk(kNorth));
  EXPECT_EQ(falls.world.state, State::climbing);
  falls.run(walk(kNorth), 3);
  EXPECT_NEAR(falls.world.velocity.y, kClimb, 0.01f);
}

TEST(Climb, is_not_entered_when_walking_away_or_along) {
  const auto level = tower(40).compile();
  for (const Turns heading : {kSouth, kEast}) {
    Play play(level, {0, 8, kFace + 1});
    play.run(walk(heading));
    EXPECT_EQ(play.world.state, State::freefall);
  }
}

TEST(Climb, needs_a_solid_truss_with_nothing_before_it) {
  const auto grip = [](const level::Level& level) {
    Play play(level);
    play.settle().run(walk(kNorth), 120);
    return entries(play) > 0;
  };
  EXPECT_TRUE(grip(tower(20).compile()));
  EXPECT_FALSE(grip(tower(20, [](Part::Builder) {}).compile())) << "a plain block";
  const auto ghost = [](Part::Builder p) {
    asTruss(p);
    p.setSolid(false);
    p.initKill().setDamage(0);
  };
  EXPECT_FALSE(grip(tower(20, ghost).compile())) << "not solid";
  EXPECT_FALSE(grip(tower(20).block({0, 10, kFace + 0.25f}, {4, 20, 0.5f}).compile())) << "hidden";
  EXPECT_TRUE(grip(tower(20).block({0, 10, kFace - 2}, {8, 20, 4}).compile())) << "flush";
}

TEST(Climb, falls_past_the_lower_end) {
  const auto level = tower(40, asTruss, 20).compile();
  Play play(level, {0, 24, kFace + 1});
  play.run(walk(kNorth));
  ASSERT_EQ(play.world.state, State::climbing);
  ASSERT_GT(play.until(walk(kSouth), [](const auto& w) { return !climbs(w); }), 0);
  EXPECT_EQ(play.world.state, State::freefall);
  EXPECT_NEAR(play.world.position.y, 15.8f, 0.3f) << "the torso's top at the truss's end";
}

TEST(Climb, ends_where_the_truss_vanishes) {
  const auto level = tower(40, [](Part::Builder p) {
                       asTruss(p);
                       p.initVanish().setTrigger(schema::VanishTrigger::TIMER);
                       p.getVanish().setDelay(2);
                     }).compile();
  Play play(level, {0, 10, kFace + 1});
  play.run(walk(kNorth), 60);
  EXPECT_EQ(play.world.state, State::climbing);
  play.run(stand(), 65);
  EXPECT_EQ(play.world.state, State::freefall);
}

TEST(Climb, is_taken_along_by_a_truss_that_carries_only) {
  for (const bool carries : {true, false}) {
    const auto level =
        tower(20, [=](Part::Builder p) {
          asTruss(p);
          auto motion = p.initMotion();
          motion.setCarries(carries);
          motion.initKeys(2);
          for (uint32_t i = 0; i < 2; ++i) {
            motion.getKeys()[i].setTime(10 * float(i));
            support::set(motion.getKeys()[i].initPosition(), {0, 10 + 30 * float(i), kFace - 1});
          }
        }).compile();
    Play play(level, {0, 8, kFace + 1});
    play.run(walk(kNorth)).run(stand());
    const float from = play.world.position.y;
    play.run(stand(), 60);
    EXPECT_EQ(play.world.state, State::climbing);
    EXPECT_NEAR(play.world.position.y - from, carries ? 3 : 0, 0.01f);
  }
}

TEST(Climb, a_floor_of_trusses_is_walked_and_landed_on) {
  LevelBuilder b;
  for (int i = 0; i < 30; ++i) b.block({0, -1, -2.0f * float(i)}, {40, 2, 2}, asTruss);
  const auto level = b.compile();
  Play play(level);
  play.settle();
  for (int i = 0; i < 6; ++i) play.run(walk(kNorth, i % 2 == 1), 30);
  EXPECT_EQ(entries(play), 0);
  EXPECT_GE(play.world.jumps, 2);
}

// Returns a level with rungs 0.3 studs thick and `gap` studs apart, up to 20 studs, in front of a
// wall with a floor on top.
level::Level ladder(float gap, bool climbable) {
  LevelBuilder b;
  b.block({0, -1, 0}, {60, 2, 60}).spawn({0, 0, 0});
  for (float y = gap + 0.15f; y < 20; y += gap + 0.3f) {
    b.block({0, y, -4}, {4, 0.3f, 0.5f}, [=](auto p) { p.setClimbable(climbable); });
  }
  b.block({0, 10, -9}, {12, 20, 9.2f});
  return b.compile();
}

TEST(Climbing, LaddersOfThinRungsAreClimbedToTheTop) {
  for (const float gap : {0.5f, 1.0f, 1.7f, 2.5f}) {
    const auto level = ladder(gap, true);
    Play play(level);
    play.settle();
    const int ticks = play.until(walk(kNorth), [](const sim::World& w) {
      return w.position.y > 19.9f && w.state == sim::State::running;
    });
    EXPECT_GE(ticks, 60) << gap;
    EXPECT_EQ(play.world.jumps, 0) << gap;
  }
}

TEST(Climbing, PartsThatAreNotClimbableStop) {
  const auto level = ladder(1.0f, false);
  Play play(level);
  play.settle().run(walk(kNorth), 300);
  EXPECT_LT(play.highest(), 3);
}

}  // namespace
}  // namespace obby::test
