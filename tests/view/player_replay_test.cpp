// A trajectory of a player with another frame rate is replayed in the player's ticks and reported
// in the level's ticks.
#include "view/player_replay.h"

#include <gtest/gtest.h>

#include "support/level_builder.h"
#include "view/report.h"

namespace obby::view {
namespace {

LevelEntry floorLevel() {
  support::LevelBuilder b;
  b.block({0, -0.5f, -20}, {8, 1, 44});
  io::RecordBuilder record;
  record.root().setLevel(b.record());
  return {io::Record(std::move(record)), std::make_shared<const level::Level>(b.compile())};
}

// Returns a trajectory that walks along -Z for a second, with a jump halfway.
io::RecordBuilder walk(uint32_t rate) {
  io::RecordBuilder record;
  auto t = record.root().initTrajectory();
  t.setFrameRate(uint16_t(rate));
  t.setStartTick(2 * rate);
  t.setTicks(rate);
  auto actions = t.initActions(2);
  for (auto run : actions) {
    run.setWalk(true);
    run.setTicks(rate / 2);
  }
  actions[1].setJump(true);
  return record;
}

PlayerReplays::Replayed told(uint32_t rate) {
  PlayerReplays players;
  const LevelEntry level = floorLevel();
  const QueryEntry query;
  const io::RecordBuilder record = walk(rate);
  auto result = players.play(level, 0, query, record.reader().getTrajectory());
  EXPECT_TRUE(result) << result.error().text();
  return *std::move(result);
}

TEST(PlayerReplay, IsReportedInTheLevelsTicks) {
  for (const uint32_t rate : {30u, 144u, 240u}) {
    const PlayerReplays::Replayed t = told(rate);
    EXPECT_EQ(t.playback.ticks(), 60u) << rate;
    ASSERT_EQ(t.playback.jumps(), 1u);
    EXPECT_NEAR(t.playback.jumpTicks[0], 31, 1) << rate;
    EXPECT_NEAR(t.playback.feet.back().z, -16, 1) << rate;
    EXPECT_EQ(t.playback.yaw.size(), 61u);
    ASSERT_TRUE(t.record);
    const auto record = t.record->reader().getTrajectory();
    EXPECT_EQ(record.getStartTick(), 120u);
    EXPECT_EQ(record.getTicks(), 60u);
    EXPECT_EQ(record.getActions()[0].getTicks(), 30u);
  }
}

TEST(PlayerReplay, EqualsTheRecordAtTheLevelsOwnRate) {
  const PlayerReplays::Replayed t = told(60);
  EXPECT_FALSE(t.record);
  EXPECT_EQ(t.playback.ticks(), 60u);
}

TEST(PlayerReplay, AnUnknownPlayerIsAnError) {
  PlayerReplays players;
  io::RecordBuilder record = walk(60);
  record.root().getTrajectory().setBody("r7");
  const auto result = players.play(floorLevel(), 0, {}, record.reader().getTrajectory());
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().path, "body");
}

}  // namespace
}  // namespace obby::view
