// Stages by evidence in the file: tags, values in pads, names, folders.
#include "import/spawns.h"

namespace obby::test {
namespace {

TEST(StageNames, TagsWithNumbers) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const auto& [tag, x] : {std::pair{"Checkpoint_2", 30.0f}, std::pair{"Checkpoint_10", 60.0f},
                               std::pair{"Checkpoint_1", 90.0f}})
    scene.tag(scene.part(tag, {x, 0, 0}), tag);
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Checkpoint_1", "Checkpoint_2", "Checkpoint_10"}));
}

TEST(StageNames, ATagOnAWholeStageMakesNoCheckpoints) {
  Scene scene;
  spawn(scene, "Start", {});
  for (int i = 0; i < 3; ++i) scene.tag(scene.part("Block", {20.0f * float(i), 0, 0}), "Stage1");
  EXPECT_EQ(scene.level().spawns.size(), 1u);
}

TEST(StageNames, AValueInEachPadGivesItsNumber) {
  for (const char* name : {"Stage", "Checkpoint", "StageNumber"}) {
    Scene scene;
    spawn(scene, "Start", {});
    for (const int n : {3, 1, 2})
      scene.value("IntValue", name, int64_t{n}, scene.part("Part", {30.0f * float(n), 0, 0}));
    const auto& level = scene.level();
    ASSERT_EQ(level.spawns.size(), 4u) << name;
    for (size_t i = 1; i < 4; ++i) EXPECT_FLOAT_EQ(level.spawns[i].position.x, 30.0f * float(i));
  }
}

TEST(StageNames, AValueSharedByManyPartsMakesNoCheckpoints) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const int n : {1, 1, 2, 2, 3})
    scene.value("IntValue", "Stage", int64_t{n}, scene.part("Door", {30.0f * float(n), 0, 0}));
  EXPECT_EQ(scene.level().spawns.size(), 1u);
}

TEST(StageNames, AStagesFolderCanHoldNumberedParts) {
  Scene scene;
  spawn(scene, "SpawnLocation", {0, 0, 8});
  const auto folder = scene.add("Folder", "Stages", scene.workspace);
  for (const int n : {2, 1, 4, 5})
    scene.part("Stage" + std::to_string(n), {0, 0, -14.0f * float(n)}, folder);
  scene.part("Sign", {9, 0, 0}, folder);
  const auto& level = scene.level();
  EXPECT_EQ(checkpoints(level), (Names{"Stage1", "Stage2", "Stage4", "Stage5"}));
  EXPECT_TRUE(level.unmodelled.empty());  // a missing number is not a loss
}

TEST(StageNames, AStagesFolderCanHoldModels) {
  Scene scene;
  spawn(scene, "SpawnLocation", {});
  const auto folder = scene.add("Folder", "Stages", scene.workspace);
  for (const int n : {1, 2, 3}) {
    const auto model = scene.add("Model", "Stage" + std::to_string(n), folder);
    for (int i = 0; i < 6; ++i)
      scene.part("Block", {40.0f * float(n) + 6.0f * float(5 - i), 0, 0}, model);
    if (n == 2) scene.part("Checkpoint", {100, 0, 0}, model);
  }
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 4u);
  EXPECT_EQ(level.spawns[2].name, "Checkpoint");
  EXPECT_FLOAT_EQ(level.spawns[3].position.x, 120);  // start of the third stage
}

TEST(StageNames, ACheckpointModelOfManyPartsIsOneCheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const int n : {1, 2}) {
    const auto model = scene.add("Model", "Checkpoint", scene.workspace);
    for (int i = 1; i < 4; ++i)
      scene.part("Part" + std::to_string(i), {40.0f * float(n), float(i), 0}, model);
  }
  EXPECT_EQ(scene.level().spawns.size(), 3u);
}

TEST(StageNames, WaypointsOfAMovingPlatformAreNotCheckpoints) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto mover = scene.add("Model", "Ferry", scene.workspace);
  scene.tag(mover, "MovingPlatform");
  scene.part("Platform", {30, 0, 0}, mover);
  const auto points = scene.add("Folder", "Checkpoints", mover);
  for (const int n : {1, 2})
    scene.part("Checkpoint" + std::to_string(n), {30.0f * float(n), 0, 0}, points);
  EXPECT_EQ(scene.level().spawns.size(), 1u);
}

TEST(StageNames, ATouchedPartUsesTheNumberOfItsModel) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const int n : {3, 1, 2}) {
    const auto model = scene.add("Model", "Flag " + std::to_string(n), scene.workspace);
    scene.script(
        "script.Parent.Touched:Connect(function(hit)\n"
        " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
        " if player then player.RespawnLocation = script.Parent end\nend)",
        scene.part("Hitbox", {120.0f - 30.0f * float(n), 0, 0}, model, "SpawnLocation"));
  }
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 4u);
  EXPECT_FLOAT_EQ(level.spawns[1].position.x, 90);
  EXPECT_FLOAT_EQ(level.spawns[3].position.x, 30);
}

TEST(StageNames, AnUnnumberedPartIsInsertedAtTheSmallestDetour) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const auto& [name, x] : {std::pair{"Checkpoint2", 60.0f}, std::pair{"Checkpoint", 30.0f},
                                std::pair{"Checkpoint3", 90.0f}})
    scene.tag(scene.part(name, {x, 0, 0}), "Checkpoint");
  EXPECT_EQ(checkpoints(scene.level()), (Names{"Checkpoint", "Checkpoint2", "Checkpoint3"}));
}

}  // namespace
}  // namespace obby::test
