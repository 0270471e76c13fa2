// World constants: which property applies, and what changes the player.
#include <cmath>

#include "import/scene.h"

namespace obby::test {
namespace {

TEST(World, ModelFileKeepsTheDefaults) {
  Scene scene = Scene::model();
  scene.part("Base", {}, kNoInstance);
  const auto& world = scene.level().world;
  EXPECT_FLOAT_EQ(world.gravity, 196.2f);
  EXPECT_FLOAT_EQ(world.walkSpeed, 16);
  EXPECT_FLOAT_EQ(world.jumpSpeed, 53);
  EXPECT_FLOAT_EQ(world.fallenPartsHeight, -500);
}

TEST(World, JumpPowerAppliesWhenNothingSaysOtherwise) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "CharacterJumpPower", 60.0);
  scene.set(player, "CharacterJumpHeight", 100.0);
  EXPECT_FLOAT_EQ(scene.level().world.jumpSpeed, 1.06f * 60);
}

TEST(World, JumpHeightAppliesWhenJumpPowerIsSwitchedOff) {
  Scene scene;
  scene.set(scene.workspace, "Gravity", 80.0);
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "CharacterUseJumpPower", false);
  scene.set(player, "CharacterJumpHeight", 12.0);
  scene.set(player, "CharacterWalkSpeed", 54.0);
  scene.set(player, "CharacterMaxSlopeAngle", 45.0);
  const auto& world = scene.level().world;
  EXPECT_FLOAT_EQ(world.gravity, 80);
  EXPECT_FLOAT_EQ(world.walkSpeed, 54);
  EXPECT_FLOAT_EQ(world.jumpSpeed, std::sqrt(2.0f * 80 * 12));
  EXPECT_NEAR(world.maxSlope, 0.785398f, 1e-6f);
}

TEST(World, StarterHumanoidReplacesTheStarterPlayerSettings) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "CharacterWalkSpeed", 10.0);
  const auto humanoid = scene.add("Humanoid", "StarterHumanoid", player);
  scene.set(humanoid, "WalkSpeed", 30.0);
  scene.set(humanoid, "MaxHealth", 50.0);
  const auto& world = scene.level().world;
  EXPECT_FLOAT_EQ(world.walkSpeed, 30);
  EXPECT_FLOAT_EQ(world.maxHealth, 50);
}

TEST(World, AnEmptyHealthScriptStopsRegeneration) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto folder = scene.add("StarterCharacterScripts", "StarterCharacterScripts", player);
  EXPECT_FLOAT_EQ(scene.level().world.healthRegeneration, 0.01f);
  scene.script("-- nothing", folder, "Health");
  EXPECT_FLOAT_EQ(scene.level().world.healthRegeneration, 0);
}

TEST(World, CharacterControllerLibraryIsNamedAsUnmodelled) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "LuaCharacterController", EnumItem{0, {}});
  scene.level();
  EXPECT_EQ(scene.unmodelled("Character Controller Library"), 0u);
  scene.set(player, "LuaCharacterController", EnumItem{3, {}});
  scene.level();
  EXPECT_EQ(scene.unmodelled("Character Controller Library"), 1u);
}

TEST(World, ScriptThatGivesEachCharacterASpeedCounts) {
  Scene scene;
  scene.script(R"(
game.Players.PlayerAdded:Connect(function(player)
  player.CharacterAdded:Connect(function(character)
    character:WaitForChild("Humanoid").WalkSpeed = 22
  end)
end)
workspace.Gravity = 100
)",
               scene.scripts);
  const auto& world = scene.level().world;
  EXPECT_FLOAT_EQ(world.walkSpeed, 22);
  EXPECT_FLOAT_EQ(world.gravity, 100);
}

}  // namespace
}  // namespace obby::test
