// SpawnLocations that are not checkpoints (other starts, lobbies, winners' lounges), and both ends
// of the course.
#include "import/spawns.h"

namespace obby::test {
namespace {

InstanceId teamSpawn(Scene& scene, const std::string& name, Vec3 position, int64_t color,
                     bool changes) {
  const auto id = spawn(scene, name, position);
  scene.set(id, "Neutral", false);
  scene.set(id, "AllowTeamChangeOnTouch", changes);
  scene.set(id, "TeamColor", color);
  return id;
}

void addTeam(Scene& scene, InstanceId teams, const std::string& name, int64_t color, bool joined) {
  const auto team = scene.add("Team", name, teams);
  scene.set(team, "TeamColor", color);
  scene.set(team, "AutoAssignable", joined);
}

void course(Scene& scene, float x, int count) {
  for (int n = 1; n <= count; ++n)
    scene.tag(scene.part("Checkpoint" + std::to_string(n), {x + 30.0f * float(n), 0, 0}),
              "Checkpoint");
}

void touch(Scene& scene, InstanceId part, const std::string& body) {
  scene.script(
      "script.Parent.Touched:Connect(function(hit)\n"
      " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
      " if player then " +
          body + " end\nend)",
      part);
}

TEST(SpawnRoles, ASecondNeutralSpawnIsAnotherStart) {
  Scene scene;
  spawn(scene, "Start", {});
  course(scene, 0, 2);
  const auto other = spawn(scene, "SpawnLocation", {60, 0, 60});
  EXPECT_EQ(order(scene.level()), (Names{"Start", "Checkpoint1", "Checkpoint2"}));
  EXPECT_FALSE(scene[other].goal);
  EXPECT_EQ(scene.evidence(other, "start"), "guessed: another SpawnLocation");
}

TEST(SpawnRoles, TheNeutralSpawnNearestTheCourseIsTheStart) {
  Scene scene;
  spawn(scene, "Lobby", {0, 0, 500});
  spawn(scene, "SpawnLocation", {0, 0, 0});
  course(scene, 0, 2);
  EXPECT_EQ(order(scene.level()), (Names{"SpawnLocation", "Checkpoint1", "Checkpoint2"}));
}

TEST(SpawnRoles, AnUntouchedTeamSpawnIsNotACheckpoint) {
  Scene scene;
  addTeam(scene, scene.add("Teams", "Teams", kNoInstance), "Admins", 23, false);
  spawn(scene, "SpawnLocation", {});
  teamSpawn(scene, "SpawnLocation", {90, 0, 0}, 23, false);
  EXPECT_EQ(scene.level().spawns.size(), 1u);
}

TEST(SpawnRoles, NeighbouringSpawnsOfAStageAreOneCheckpoint) {
  Scene scene;
  const auto stages = scene.add("Folder", "Stages", scene.workspace);
  for (const int n : {1, 2, 3}) {
    const auto stage = scene.add("Folder", std::to_string(n), stages);
    for (int i = 0; i < 3; ++i)
      spawn(scene, "SpawnLocation", {60.0f * float(n), 0, 8.0f * float(i)}, stage);
  }
  EXPECT_EQ(scene.level().spawns.size(), 3u);
}

TEST(SpawnRoles, ALastCheckpointNamedFinishIsTheGoal) {
  Scene scene;
  spawn(scene, "SpawnLocation", {});
  course(scene, 0, 2);
  const auto last = spawn(scene, "Finish", {90, 0, 0});
  touch(scene, last, "player.RespawnLocation = script.Parent");
  EXPECT_EQ(scene.level().spawns.size(), 3u);
  EXPECT_TRUE(scene[last].goal);
}

TEST(SpawnRoles, TheWinnersSpawnIsNotAStart) {
  Scene scene;
  const auto teams = scene.add("Teams", "Teams", kNoInstance);
  addTeam(scene, teams, "Winners", 24, true);
  addTeam(scene, teams, "Stage 2", 22, true);
  addTeam(scene, teams, "Stage 1", 21, true);
  teamSpawn(scene, "SpawnLocation", {300, 0, 0}, 24, true);
  teamSpawn(scene, "SpawnLocation", {30, 0, 0}, 22, true);
  teamSpawn(scene, "SpawnLocation", {0, 0, 0}, 21, true);
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 2u);
  EXPECT_FLOAT_EQ(level.spawns[0].position.x, 0);
  EXPECT_FLOAT_EQ(level.spawns[1].position.x, 30);
  EXPECT_TRUE(level.parts[0].goal);  // a player on it has won
}

TEST(SpawnRoles, ThePartLeadingToTheWinnersIsTheGoal) {
  const char* const leads[] = {"hit.Parent:PivotTo(CFrame.new(500, 4, 0))",
                               "player.Team = game.Teams.Winners",
                               "player.RespawnLocation = workspace.Winners"};
  for (const char* lead : leads) {
    Scene scene;
    addTeam(scene, scene.add("Teams", "Teams", kNoInstance), "Winners", 24, false);
    spawn(scene, "SpawnLocation", {});
    course(scene, 0, 2);
    const auto lounge = teamSpawn(scene, "Winners", {500, 0, 0}, 24, false);
    const auto last = scene.part("Golden", {90, 0, 0});
    touch(scene, last, lead);
    EXPECT_EQ(order(scene.level()), (Names{"SpawnLocation", "Checkpoint1", "Checkpoint2"})) << lead;
    EXPECT_TRUE(scene[last].goal) << lead;
    EXPECT_FALSE(scene[lounge].goal || scene[lounge].checkpoint) << lead;
  }
}

TEST(SpawnRoles, APadThatAwardsAWinIsTheGoal) {
  Scene scene;
  spawn(scene, "SpawnLocation", {});
  course(scene, 0, 2);
  scene.part("Winner Sign", {60, 9, 3});
  const auto last = scene.part("Golden", {90, 0, 0});
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " local stats = Instance.new('Folder') stats.Name = 'leaderstats' stats.Parent = player\n"
      " local wins = Instance.new('IntValue') wins.Name = 'Wins' wins.Parent = stats\nend)",
      scene.scripts);
  touch(scene, last, "player.leaderstats.Wins.Value += 1");
  const auto& level = scene.level();
  for (const PartDraft& part : level.parts) EXPECT_EQ(part.goal.has_value(), part.id == last);
}

TEST(SpawnRoles, ALobbyWithAPortalIsTheStart) {
  Scene scene;
  spawn(scene, "SpawnLocation", {-2000, 0, 0});
  touch(scene, scene.part("Portal", {-1980, 0, 0}), "hit.Parent:PivotTo(CFrame.new(10, 4, 0))");
  course(scene, 0, 3);
  EXPECT_EQ(order(scene.level()),
            (Names{"SpawnLocation", "Checkpoint1", "Checkpoint2", "Checkpoint3"}));
}

TEST(SpawnRoles, CoursesWithoutAPortalStartAtTheFirstCheckpoint) {
  Scene scene;
  spawn(scene, "SpawnLocation", {-2000, 0, 0});
  course(scene, 0, 3);
  EXPECT_EQ(order(scene.level()), (Names{"Checkpoint1", "Checkpoint2", "Checkpoint3"}));
}

TEST(SpawnRoles, APortalShortensTheRoute) {
  Scene scene;
  spawn(scene, "Start", {});
  for (const auto& [x, z] :
       {std::pair{30.0f, 0.0f}, std::pair{1000.0f, 0.0f}, std::pair{90.0f, 90.0f}})
    scene.tag(scene.part("Checkpoint", {x, 0, z}), "Checkpoint");
  touch(scene, scene.part("Portal", {32, 0, 0}), "hit.Parent:PivotTo(CFrame.new(1000, 4, 4))");
  const auto& level = scene.level();
  ASSERT_EQ(level.spawns.size(), 4u);
  EXPECT_FLOAT_EQ(level.spawns[2].position.x, 1000);
}

TEST(SpawnRoles, TheScriptedSpawnOfNewPlayersIsTheStart) {
  Scene scene;
  spawn(scene, "SpawnLocation", {0, 0, 400});
  course(scene, 0, 3);
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " player.CharacterAdded:Connect(function(character)\n"
      "  task.wait(0.2) character:PivotTo(workspace.Checkpoint1.CFrame + Vector3.new(0, 4, 0))\n"
      " end)\nend)",
      scene.scripts);
  EXPECT_EQ(order(scene.level()), (Names{"Checkpoint1", "Checkpoint2", "Checkpoint3"}));
}

TEST(SpawnRoles, TheNamedGoalNearestTheLastCheckpointWins) {
  Scene scene;
  spawn(scene, "Start", {});
  course(scene, 0, 3);
  const auto near = scene.part("WinPad", {110, 0, 0}), far = scene.part("Winner Hall", {900, 0, 0});
  scene.level();
  EXPECT_TRUE(scene[near].goal);
  EXPECT_FALSE(scene[far].goal);
}

TEST(SpawnRoles, AGoalNameFarFromTheCourseIsIgnored) {
  Scene scene;
  spawn(scene, "Start", {});
  course(scene, 0, 3);
  const auto far = scene.part("Winner Hall", {900, 0, 0});
  const auto& level = scene.level();
  EXPECT_FALSE(scene[far].goal);
  EXPECT_TRUE(level.parts[size_t(level.spawns.back().part)].goal);
}

}  // namespace
}  // namespace obby::test
