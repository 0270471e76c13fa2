// Air jumps: each needs a new press of the key, and their number between two floors is limited.
#include <gtest/gtest.h>

#include "level/params.h"
#include "sim/play.h"

namespace obby::test {
namespace {

using sim::State;
using sim::World;

level::Level levelWith(int jumps) {
  return flatLevel([=](auto p) { p.setAirJumps(uint16_t(jumps)); });
}

// Presses the jump key for one tick every `every` ticks, `times` times.
Play& hop(Play& play, int times, int every = 16) {
  for (int i = 0; i < times; ++i) play.run(stand(true)).run(stand(), every - 1);
  return play;
}

float riseOf(const level::Level& level) {
  const Params& p = level.view().params;
  return riseOfLaunch(p, p.gravity, p.jumpSpeed);
}

TEST(AirJump, StartsFromTheCurrentHeight) {
  const auto level = levelWith(1);
  Play play(level);
  hop(play.settle(), 1);
  const float height = play.world.position.y;
  play.run(stand(true));
  EXPECT_EQ(play.world.state, State::jumping);
  EXPECT_GT(play.world.velocity.y, 50);
  EXPECT_EQ(play.world.jumps, 2);
  play.run(stand(), 60);
  EXPECT_NEAR(play.highest(), height + riseOf(level), 0.1f);
}

TEST(AirJump, AreLimitedBetweenTwoFloors) {
  for (const int many : {0, 1, 3}) {
    const auto level = levelWith(many);
    Play play(level);
    hop(play.settle(), 6, 4).run(stand(), 300);
    EXPECT_EQ(play.world.jumps, 1 + many);
    EXPECT_EQ(play.world.clockCount, 0) << "the floor gives them back";
    hop(play, 6, 4);
    EXPECT_EQ(play.world.jumps, 2 * (1 + many));
  }
}

TEST(AirJump, AHeldKeyDoesNotRepeatThem) {
  const auto level = levelWith(1);
  Play play(level);
  play.settle().run(stand(true), 30);
  EXPECT_EQ(play.world.jumps, 1);
  play.run(stand()).run(stand(true));
  EXPECT_EQ(play.world.jumps, 2);
}

TEST(AirJump, AWalkOffAnEdgeAllowsThemToo) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {8, 2, 8})
                         .physics([](auto p) { p.setAirJumps(1); })
                         .compile();
  Play play(level);
  play.settle();
  play.until(walk(kNorth), [](const World& w) { return w.state == State::freefall; });
  play.run(walk(kNorth, true)).run(walk(kNorth), 2);
  EXPECT_GT(play.world.velocity.y, 40);
  play.run(walk(kNorth, true), 5);
  EXPECT_EQ(play.world.jumps, 1);
}

TEST(AirJump, CanBeUnlimited) {
  const auto level = levelWith(kAnyAirJumps);
  Play play(level);
  hop(play.settle(), 150, 10);
  EXPECT_GT(play.world.position.y, 500);
}

TEST(AirJump, UseTheJumpSpeedOfABoost) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {200, 2, 200},
                                [](auto p) {
                                  p.initBoost().setJumpSpeed(1.5f);
                                  p.getBoost().setForever(true);
                                })
                         .physics([](auto p) { p.setAirJumps(1); })
                         .compile();
  Play play(level);
  hop(play.settle(), 1, 20).run(stand(true));
  EXPECT_NEAR(play.world.velocity.y, 79.5f, 3);
}

}  // namespace
}  // namespace obby::test
