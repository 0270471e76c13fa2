// Parts that kill a player and let the player respawn further ahead.
#include <gtest/gtest.h>

#include "import/scene.h"
#include "import/spawns.h"

namespace obby::test {
namespace {

const std::string kPlayerOf =
    "script.Parent.Touched:Connect(function(hit)\n"
    " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n if not player then return "
    "end\n";

// Expects a door that kills and sets the RespawnLocation 300 studs away to be a portal.
void expectLeadsToNext(Scene& scene) {
  spawn(scene, "Start", {});
  const InstanceId door = scene.part("Door", {20, 3, 0});
  spawn(scene, "Next", {300, 0, 0});
  scene.script(
      kPlayerOf + " player.RespawnLocation = workspace.Next\n hit.Parent.Humanoid.Health = 0\nend)",
      door);
  scene.level();
  EXPECT_FALSE(scene[door].kill);
  EXPECT_FALSE(scene[door].checkpoint);
  ASSERT_TRUE(scene[door].teleport);
  EXPECT_NEAR(scene[door].teleport->position.x, 300, 3);
}

TEST(Portal, KillsThatSetTheRespawnLocationArePortals) {
  Scene scene;
  expectLeadsToNext(scene);
}

TEST(Portal, AKillThatRaisesTheStageIsAPortal) {
  Scene scene;
  spawn(scene, "Start", {});
  const InstanceId door = scene.part("Door", {20, 3, 0});
  scene.part("Stage2", {0, 0, 400});
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " local stats = Instance.new('Folder') stats.Name = 'leaderstats' stats.Parent = player\n"
      " local stage = Instance.new('IntValue') stage.Name = 'Stage' stage.Value = 1\n"
      " stage.Parent = stats\n"
      " player.CharacterAdded:Connect(function(character) task.wait()\n"
      "  if stage.Value == 2 then character:MoveTo(workspace.Stage2.Position) end\n"
      " end)\nend)",
      scene.scripts);
  scene.script(kPlayerOf + " player.leaderstats.Stage.Value = 2\n hit.Parent:BreakJoints()\nend)",
               door);
  scene.level();
  EXPECT_FALSE(scene[door].kill);
  ASSERT_TRUE(scene[door].teleport);
  EXPECT_NEAR(scene[door].teleport->position.z, 400, 3);
}

TEST(Portal, ALongRespawnTimeIsAwaited) {
  Scene scene;
  scene.set(scene.add("Players", "Players", kNoInstance), "RespawnTime", 15.0f);
  expectLeadsToNext(scene);
}

// The script also counts deaths, but the player respawns at the old location.
TEST(Portal, AKillThatCountsDeathsStaysAKill) {
  Scene scene;
  spawn(scene, "Start", {});
  const InstanceId lava = scene.part("Lava", {20, 0, 0});
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " local stats = Instance.new('Folder') stats.Name = 'leaderstats' stats.Parent = player\n"
      " local deaths = Instance.new('IntValue') deaths.Name = 'Deaths' deaths.Parent = stats\n"
      " player.CharacterAdded:Connect(function(character)\n"
      "  character:WaitForChild('Humanoid').Died:Connect(function() deaths.Value += 1 end)\n"
      " end)\nend)",
      scene.scripts);
  scene.script(kPlayerOf + " hit.Parent.Humanoid.Health = 0\nend)", lava);
  scene.level();
  EXPECT_TRUE(scene[lava].kill);
  EXPECT_FALSE(scene[lava].teleport);
}

}  // namespace
}  // namespace obby::test
