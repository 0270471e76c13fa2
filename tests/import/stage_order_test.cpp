// The order of checkpoints: numbers of folders and teams, and checkpoints without a number.
#include "import/spawns.h"

namespace obby::test {
namespace {

TEST(Stages, SpawnsInStageFoldersFollowTheirNumbers) {
  Scene scene;
  for (const int n : {3, 1, 2}) {
    const auto stage = scene.add("Folder", "Stage " + std::to_string(n) + " Lava", scene.workspace);
    spawn(scene, "Pad" + std::string(1, char('a' + n)), {n == 2 ? 120.0f : 30.0f * float(n), 0, 0},
          stage);
  }
  // The second stage is further away than the third.
  EXPECT_EQ(order(scene.level()), (Names{"Padb", "Padc", "Padd"}));
}

TEST(Stages, SpawnsFollowTheNumbersOfTheirTeams) {
  Scene scene;
  const auto teams = scene.add("Teams", "Teams", kNoInstance);
  for (const int n : {1, 2, 3}) {
    const auto team = scene.add("Team", "Stage " + std::to_string(n), teams);
    scene.set(team, "TeamColor", int64_t{20 + n});
    scene.set(team, "AutoAssignable", n == 1);
  }
  for (const auto& [n, x] : {std::pair{3, 30.0f}, std::pair{2, 60.0f}, std::pair{1, 0.0f}}) {
    const auto id = spawn(scene, "SpawnLocation", {x, 0, 0});
    scene.set(id, "Neutral", false);
    scene.set(id, "AllowTeamChangeOnTouch", true);
    scene.set(id, "TeamColor", int64_t{20 + n});
  }
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 3u);
  EXPECT_FLOAT_EQ(level.spawns[0].position.x, 0);
  EXPECT_FLOAT_EQ(level.spawns[1].position.x, 60);
  EXPECT_FLOAT_EQ(level.spawns[2].position.x, 30);
}

TEST(Stages, OneNumberedTeamAmongManyGivesNoOrder) {
  Scene scene;
  const auto teams = scene.add("Teams", "Teams", kNoInstance);
  int color = 20;
  for (const char* name : {"Start", "Down The Stairs", "Lava", "4 Way Jump"}) {
    const auto team = scene.add("Team", name, teams);
    scene.set(team, "TeamColor", int64_t{color});
    scene.set(team, "AutoAssignable", color == 20);
    const auto id = spawn(scene, "SpawnLocation", {30.0f * float(color - 20), 0, 0});
    scene.set(id, "Neutral", false);
    scene.set(id, "AllowTeamChangeOnTouch", true);
    scene.set(id, "TeamColor", int64_t{color});
    ++color;
  }
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 4u);
  for (size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(level.spawns[i].position.x, 30.0f * float(i));
}

TEST(Stages, ATeamWithoutAColourUsesTheClassDefault) {
  Scene scene;
  scene.add("Team", "Visitors", scene.add("Teams", "Teams", kNoInstance));
  for (const auto& [name, color] : {std::pair{"Later", 23}, std::pair{"First", 1}}) {
    const auto id = spawn(scene, name, {float(color) * 10, 0, 0});
    scene.set(id, "Neutral", false);
    scene.set(id, "AllowTeamChangeOnTouch", true);
    scene.set(id, "TeamColor", int64_t{color});
  }
  EXPECT_EQ(order(scene.level()), (Names{"First", "Later"}));
}

TEST(Stages, CheckpointsOfOneNumberFollowTheDistance) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto far = scene.part("Checkpoint 1", {80, 0, 0}),
             near = scene.part("Checkpoint 1", {20, 0, 0}),
             next = scene.part("Checkpoint 2", {10, 0, 0});
  for (const auto id : {far, near, next}) scene.tag(id, "Checkpoint");
  scene.level();
  EXPECT_EQ(*scene[near].checkpoint, 1);
  EXPECT_EQ(*scene[far].checkpoint, 2);
  EXPECT_EQ(*scene[next].checkpoint, 3);
  EXPECT_EQ(scene[near].evidence.back().reason,
            "ordered by distance: other checkpoints have the same number");
  EXPECT_FALSE(scene[next].evidence.front().guessed);
}

TEST(Stages, TooManyEqualCheckpointsKeepTheFileOrder) {
  Scene scene;
  spawn(scene, "Start", {});
  std::vector<InstanceId> all;
  for (int i = 0; i <= 10000; ++i) {
    const float x = 1030.0f - 0.1f * float(i);  // the last spawn is the nearest
    all.push_back(scene.part("Checkpoint " + std::to_string(1 + i % 2), {x, 0, 0}));
    scene.tag(all.back(), "Checkpoint");
  }
  scene.level();
  EXPECT_EQ(*scene[all.front()].checkpoint, 1);
}

TEST(Stages, CheckpointNamesMatchInAnySpelling) {
  for (const char* name : {"CheckPoint2", "Check Point 2", "checkpoint_2", "CHECKPOINT2"}) {
    Scene scene;
    spawn(scene, "Start", {});
    const auto part = scene.part(name, {20, 0, 0});
    const auto model = scene.add("Model", name, scene.workspace);
    const auto touch = scene.part("Touch", {40, 0, 0}, model), flag = scene.part("Flag", {}, model);
    const auto folder = scene.add("Folder", "CheckPoints", scene.workspace);
    const auto numbered = scene.part("3", {60, 0, 0}, folder);
    scene.level();
    for (const auto id : {part, touch, numbered}) EXPECT_TRUE(scene[id].checkpoint) << name;
    EXPECT_FALSE(scene[flag].checkpoint) << name;
  }
}

TEST(Stages, ATaggedFolderHoldsCheckpointsSideBySide) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto folder = scene.add("Folder", "Way", scene.workspace);
  scene.tag(folder, "Checkpoints");
  scene.part("2", {20, 0, 0}, folder);
  scene.part("1", {40, 0, 0}, folder);
  const auto model = scene.add("Model", "3", folder);
  scene.part("Flag", {60, 4, 0}, model);
  scene.part("Touch", {60, 0, 0}, model);
  scene.script("print('3')", folder);
  EXPECT_EQ(order(scene.level()), (Names{"Start", "1", "2", "Touch"}));
}

TEST(Stages, AFolderTaggedAsAStageIsOneCheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const int n : {1, 2}) {
    const auto stage = scene.add("Folder", "Stage " + std::to_string(n), scene.workspace);
    scene.tag(stage, "Stage");
    for (int i = 0; i < 3; ++i) scene.part("Block", {40.0f * float(n), 0, 8.0f * float(i)}, stage);
    scene.part("Pad", {40.0f * float(n), 0, 30}, stage);
  }
  EXPECT_EQ(order(scene.level()), (Names{"Start", "Pad", "Pad"}));
}

TEST(Stages, NeighbouringPadsOfOneStageAreOneStart) {
  Scene scene;
  const auto stage = scene.add("Model", "1", scene.add("Folder", "Stages", scene.workspace));
  for (int i = 0; i < 3; ++i) spawn(scene, "SpawnLocation", {float(i) * 8, 0, 0}, stage);
  EXPECT_EQ(scene.level().spawns.size(), 1u);
}

}  // namespace
}  // namespace obby::test
