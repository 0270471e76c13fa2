// Tests the start, the order of checkpoints, and the goal.
#include <algorithm>
#include <chrono>

#include "import/records/queries.h"
#include "import/spawns.h"

namespace obby::test {
namespace {

TEST(Stages, SpawnsStandOnThePadFacingItsFront) {
  Scene scene;
  const auto id = spawn(scene, "Start", {1, 5, 2});
  scene.set(id, "Size", Vec3{6, 2, 6});
  scene.set(id, "CFrame", CFrame{{1, 5, 2}, {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}});
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 1u);
  EXPECT_EQ(level.spawns[0].position, (Vec3{1, 6, 2}));
  EXPECT_NEAR(level.spawns[0].yaw, 1.5707963f, 1e-5f);
  EXPECT_EQ(level.spawns[0].part, 0);
  EXPECT_EQ(level.spawns[0].stage, 0);
}

TEST(Stages, NumberedCheckpointsCountUpFromOne) {
  Scene scene;
  const auto folder = scene.add("Folder", "Checkpoints", scene.workspace);
  scene.part("3", {30, 0, 0}, folder);
  scene.part("10", {100, 0, 0}, folder);
  scene.part("2", {20, 0, 0}, folder);
  spawn(scene, "SpawnLocation", {0, 0, 0});
  const auto& level = scene.level();
  EXPECT_EQ(order(level), (Names{"SpawnLocation", "2", "3", "10"}));
  EXPECT_EQ(level.spawns[3].stage, 3);
  EXPECT_EQ(*level.parts[size_t(level.spawns[3].part)].goal, 0);  // the last spawn is the end
}

TEST(Stages, TagsTakeTheirNumberFromAttributesNamesOrFolders) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto a = scene.part("A", {30, 0, 0});
  scene.attribute(a, "Stage", int64_t{2});
  scene.tag(a, "Checkpoint");
  scene.tag(scene.part("Checkpoint1", {90, 0, 0}), "Checkpoint");
  const auto folder = scene.add("Folder", "3", scene.workspace);
  scene.tag(spawn(scene, "Pad", {10, 0, 0}, folder), "Checkpoint");
  const auto& level = scene.level();
  EXPECT_EQ(order(level), (Names{"Start", "Checkpoint1", "A", "Pad"}));
}

TEST(Stages, ATaggedModelIsTouchedAtItsTouchPart) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto model = scene.add("Model", "Checkpoint7", scene.workspace);
  scene.tag(model, "Checkpoint");
  scene.part("Flag", {20, 4, 0}, model);
  const auto touch = scene.part("Touch", {20, 0, 0}, model);
  scene.level();
  EXPECT_EQ(*scene[touch].checkpoint, 1);
}

TEST(Stages, UnnumberedCheckpointsFollowTheDistanceAndReportIt) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto far = scene.part("Checkpoint", {80, 0, 0}),
             near = scene.part("Checkpoint", {20, 0, 0}),
             middle = scene.part("Checkpoint", {50, 0, 0});
  for (const auto id : {far, near, middle}) scene.tag(id, "Checkpoint");
  scene.level();
  EXPECT_EQ(*scene[near].checkpoint, 1);
  EXPECT_EQ(*scene[middle].checkpoint, 2);
  EXPECT_EQ(*scene[far].checkpoint, 3);
  EXPECT_TRUE(scene[near].evidence.back().guessed);
}

TEST(Stages, TeamsDistinguishTheStartFromCheckpoints) {
  Scene scene;
  const auto teams = scene.add("Teams", "Teams", kNoInstance);
  const auto first = scene.add("Team", "Start here", teams);
  scene.set(first, "TeamColor", int64_t{21});
  const auto second = scene.add("Team", "Down The Stairs", teams);
  scene.set(second, "TeamColor", int64_t{23});
  scene.set(second, "AutoAssignable", false);
  const auto later = spawn(scene, "Down The Stairs", {60, 0, 0});
  const auto start = spawn(scene, "Begin", {0, 0, 0});
  for (const auto& [id, color] : {std::pair{later, 23}, std::pair{start, 21}}) {
    scene.set(id, "Neutral", false);
    scene.set(id, "AllowTeamChangeOnTouch", true);
    scene.set(id, "TeamColor", int64_t{color});
  }
  EXPECT_EQ(order(scene.level()), (Names{"Begin", "Down The Stairs"}));
}

TEST(Stages, SpawnsInNumberedFoldersAreStages) {
  Scene scene;
  const auto stages = scene.add("Folder", "Stages", scene.workspace);
  for (const int n : {2, 1, 3}) {
    const auto stage = scene.add("Model", std::to_string(n), stages);
    spawn(scene, "SpawnLocation", {float(n) * 40, 0, 0}, stage);
  }
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 3u);
  EXPECT_FLOAT_EQ(level.spawns[0].position.x, 40);
  EXPECT_FLOAT_EQ(level.spawns[1].position.x, 80);
  EXPECT_FLOAT_EQ(level.spawns[2].position.x, 120);
}

TEST(Stages, NeighbouringPadsAreOneStart) {
  Scene scene;
  for (int i = 0; i < 3; ++i) spawn(scene, "SpawnLocation", {float(i) * 8, 0, 0});
  EXPECT_EQ(scene.level().spawns.size(), 1u);
}

TEST(Stages, DisabledSpawnsDoNotCount) {
  Scene scene;
  scene.set(spawn(scene, "Off", {}), "Enabled", false);
  spawn(scene, "On", {90, 0, 0});
  EXPECT_EQ(order(scene.level()), (Names{"On"}));
}

TEST(Stages, TemplateCheckpointScriptMakesACheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto part = scene.part("Plate", {20, 0, 0});
  scene.script(R"(local spawn = script.Parent
spawn.Touched:connect(function(hit)
  if hit and hit.Parent and hit.Parent:FindFirstChild("Humanoid") then
    local player = game.Players:GetPlayerFromCharacter(hit.Parent)
    local checkpointData = game.ServerStorage:FindFirstChild("CheckpointData")
    if not checkpointData then
      checkpointData = Instance.new("Model", game.ServerStorage)
      checkpointData.Name = "CheckpointData"
    end
    local checkpoint = checkpointData:FindFirstChild(tostring(player.userId))
    if not checkpoint then
      checkpoint = Instance.new("ObjectValue", checkpointData)
    end
    checkpoint.Value = spawn
  end
end))",
               part, "CheckpointScript");
  scene.level();
  EXPECT_EQ(*scene[part].checkpoint, 1);
  EXPECT_EQ(scene.evidence(part, "checkpoint"),
            "script CheckpointScript line 14: checkpoint.Value = spawn");
}

TEST(Stages, LeaderstatsGiveTheOrder) {
  Scene scene;
  spawn(scene, "Start", {});
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " local stats = Instance.new('Folder', player) stats.Name = 'leaderstats'\n"
      " Instance.new('IntValue', stats).Name = 'Stage'\nend)",
      scene.scripts);
  const auto pad = [&](int stage, float z) {
    const auto part = scene.part("Plate", {0, 0, z});
    scene.script(
        "script.Parent.Touched:Connect(function(hit)\n"
        " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
        " if player then player.leaderstats.Stage.Value = " +
            std::to_string(stage) + " end\nend)",
        part);
    return part;
  };
  const auto second = pad(2, 20), first = pad(1, 40);
  scene.level();
  EXPECT_EQ(*scene[first].checkpoint, 1);
  EXPECT_EQ(*scene[second].checkpoint, 2);
}

TEST(Stages, StartPartOrFirstCheckpointReplacesAMissingSpawn) {
  {
    Scene scene;
    scene.part("START", {3, 0, 0});
    const auto& level = scene.level();
    EXPECT_EQ(order(level), (Names{"START"}));
    EXPECT_TRUE(level.parts[0].evidence[0].guessed);
  }
  Scene scene;
  const auto folder = scene.add("Folder", "Checkpoints", scene.workspace);
  scene.part("1", {}, folder);
  scene.part("2", {30, 0, 0}, folder);
  EXPECT_EQ(order(scene.level()), (Names{"1", "2"}));
}

TEST(Stages, GoalByTagBeatsGoalsByName) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto tagged = scene.part("Gate", {60, 0, 0}), named = scene.part("WinPad", {90, 0, 0});
  scene.tag(tagged, "Goal");
  scene.level();
  EXPECT_TRUE(scene[tagged].goal);
  EXPECT_FALSE(scene[named].goal);
}

TEST(Stages, ATaggedModelIsOneGoal) {
  for (const char* name : {"Touch", "Goal"}) {
    Scene scene;
    spawn(scene, "Start", {});
    const auto model = scene.add("Model", "Gate", scene.workspace);
    scene.tag(model, "Goal");
    scene.part("Arch", {60, 8, 0}, model);
    const auto touch = scene.part(name, {60, 0, 0}, model);
    scene.part("Post", {64, 4, 0}, model);
    const auto& level = scene.level();
    for (const PartDraft& part : level.parts)
      EXPECT_EQ(part.goal.has_value(), part.id == touch) << name;
    EXPECT_EQ(importer::stageQueries(level, importer::Tree(scene.document)).size(), 1u);
  }
}

TEST(Stages, ATaggedFolderHoldsGoalsSideBySide) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto folder = scene.add("Folder", "Ends", scene.workspace);
  scene.tag(folder, "Goal");
  const auto left = scene.part("Left", {60, 0, 0}, folder),
             right = scene.part("Right", {60, 0, 20}, folder);
  scene.level();
  EXPECT_TRUE(scene[left].goal);
  EXPECT_TRUE(scene[right].goal);
}

TEST(Stages, AModelOfManyPartsIsOneCheckpoint) {
  Scene scene;
  spawn(scene, "Start", {});
  const auto model = scene.add("Model", "Checkpoint 1", scene.workspace);
  for (int i = 0; i < 10000; ++i) scene.part("Block", {float(i % 100), 0, float(i / 100)}, model);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(order(scene.level()), (Names{"Start", "Block"}));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Stages, GoalNamesMatchInAnyForm) {
  for (const char* name : {"WinPad", "Finish Line", "End", "The End", "EndPad", "End_Part",
                           "GoalPart", "BaseChegada"}) {
    Scene scene;
    const auto goal = scene.part(name, {60, 0, 0}), window = scene.part("Window"),
               bend = scene.part("Bend");
    scene.level();
    EXPECT_TRUE(scene[goal].goal) << name;
    EXPECT_FALSE(scene[window].goal);
    EXPECT_FALSE(scene[bend].goal);
  }
}

TEST(Stages, TheGuessedGoalNearestTheStartIsKept) {
  Scene scene;
  const auto one = scene.add("Model", "One", scene.workspace),
             two = scene.add("Model", "Two", scene.workspace);
  scene.part("End", {90, 0, 0}, two);
  scene.part("Start", {}, one);
  const auto goal = scene.part("End", {20, 0, 0}, one);
  const auto& level = scene.level();
  EXPECT_TRUE(scene[goal].goal);
  EXPECT_EQ(std::count_if(level.parts.begin(), level.parts.end(),
                          [](const auto& p) { return p.goal.has_value(); }),
            1);
}

}  // namespace
}  // namespace obby::test
