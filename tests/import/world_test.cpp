// World constants: which property applies, and which settings change the player.
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

TEST(World, JumpPowerAppliesByDefault) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "CharacterJumpPower", 60.0);
  scene.set(player, "CharacterJumpHeight", 100.0);
  EXPECT_FLOAT_EQ(scene.level().world.jumpSpeed, 1.06f * 60);
}

TEST(World, JumpHeightAppliesIfJumpPowerIsOff) {
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

TEST(World, AbilityRulesMayChooseTheControllerLibrary) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto rules = scene.add("AvatarAbilityRules", "AvatarAbilityRules",
                               scene.add("AvatarSettings", "AvatarSettings", player));
  scene.level();
  EXPECT_EQ(scene.unmodelled("Character Controller Library"), 0u);
  scene.set(rules, "CharacterControllerMode", EnumItem{1, {}});
  scene.level();
  EXPECT_EQ(scene.unmodelled("Character Controller Library"), 1u);
}

TEST(World, SettingsOfTheSimulationAreNamed) {
  Scene scene;
  EXPECT_EQ(scene.level().ignored.count("fixed simulation"), 0u);
  EXPECT_EQ(scene.unmodelled("server authority"), 0u);
  scene.set(scene.workspace, "AuthorityMode", EnumItem{0, {}});
  scene.set(scene.workspace, "UseFixedSimulation", EnumItem{2, {}});
  EXPECT_EQ(scene.level().ignored.count("fixed simulation"), 1u);
  EXPECT_EQ(scene.unmodelled("server authority"), 1u);
}

TEST(World, AScriptedSpeedForEachCharacterApplies) {
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

TEST(World, ScriptsInTheStarterCharacterGiveToEachCharacter) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto folder = scene.add("StarterCharacterScripts", "StarterCharacterScripts", player);
  scene.script("script.Parent:WaitForChild('Humanoid').JumpPower = 80", folder);
  scene.script("local h = script.Parent:FindFirstChild('Humanoid') if h then h.WalkSpeed = 20 end",
               folder);
  scene.script("script.Parent.Humanoid.WalkSpeed = 99",
               scene.add("StarterPlayerScripts", "StarterPlayerScripts", player));
  EXPECT_FLOAT_EQ(scene.level().world.jumpSpeed, 1.06f * 80);
  EXPECT_FLOAT_EQ(scene.level().world.walkSpeed, 20);
}

// Returns a new place, as Studio saves it, with a script for each new character.
Scene withJumpHeight(const std::string& forCharacter, const std::string& atStart = {}) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "CharacterUseJumpPower", false);
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      "  player.CharacterAdded:Connect(function(character)\n"
      "    local h = character:WaitForChild('Humanoid')\n" +
          forCharacter + "\nend) end)\n" + atStart,
      scene.scripts);
  return scene;
}

TEST(World, ScriptedJumpsUseTheActiveJumpSetting) {
  struct Case {
    const char *forCharacter, *atStart;
    float speed;
  };
  const float usual = std::sqrt(2 * 196.2f * 7.2f);
  const Case cases[] = {{"", "workspace.Gravity = 100", std::sqrt(2 * 100 * 7.2f)},
                        {"h.JumpPower = 100", "", usual},
                        {"h.JumpHeight = 20", "", std::sqrt(2 * 196.2f * 20)},
                        {"h.JumpPower = 100 h.UseJumpPower = true", "", 106},
                        {"h.UseJumpPower = true h.JumpHeight = 20", "", 53},
                        {"h.JumpHeight = 20", "workspace.Gravity = 100", std::sqrt(2 * 100 * 20.f)},
                        {"if h then h.JumpHeight = 20 end", "", std::sqrt(2 * 196.2f * 20)}};
  for (const Case& now : cases) {
    Scene scene = withJumpHeight(now.forCharacter, now.atStart);
    EXPECT_NEAR(scene.level().world.jumpSpeed, now.speed, 1e-3) << now.forCharacter << now.atStart;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << now.forCharacter;
  }
}

TEST(World, TheJumpDoesNotDependOnTheOrderOfScripts) {
  Scene scene = withJumpHeight("h.JumpHeight = 20");
  scene.script("workspace.Gravity = 100", scene.scripts);
  EXPECT_NEAR(scene.level().world.jumpSpeed, std::sqrt(2 * 100 * 20.f), 1e-3);
}

}  // namespace
}  // namespace obby::test
