// Keys, mouse buttons, screen buttons, chat and drags that scripts listen to.
#include "import/player_script.h"

namespace obby::test {
namespace {

void keyScript(Scene& scene, const std::string& source) {
  playerScript(scene, "StarterPlayerScripts",
               "local player = game.Players.LocalPlayer\n"
               "local function human() return player.Character:WaitForChild('Humanoid') end\n" +
                   source);
}

float walkSpeedWith(const std::string& source) {
  Scene scene;
  keyScript(scene, source);
  return scene.level().world.walkSpeed;
}

TEST(Keys, ABoundActionIsAnAbility) {
  EXPECT_FLOAT_EQ(walkSpeedWith(R"(game.ContextActionService:BindAction('Sprint', function(_, state)
  human().WalkSpeed = state == Enum.UserInputState.Begin and 40 or 16
end, false, Enum.KeyCode.LeftShift))"),
                  40);
}

TEST(Keys, APolledKeyIsAnAbility) {
  EXPECT_FLOAT_EQ(walkSpeedWith(R"(local input = game:GetService('UserInputService')
game:GetService('RunService').RenderStepped:Connect(function()
  human().WalkSpeed = input:IsKeyDown(Enum.KeyCode.LeftAlt) and 40 or 16
end))"),
                  40);
}

TEST(Keys, AKeyThatAHandlerChecksIsPressed) {
  EXPECT_FLOAT_EQ(walkSpeedWith(R"(local input = game:GetService('UserInputService')
input.InputBegan:Connect(function(key) if key.KeyCode == Enum.KeyCode.Z then human().WalkSpeed = 40 end end)
input.InputEnded:Connect(function(key) if key.KeyCode == Enum.KeyCode.Z then human().WalkSpeed = 16 end end))"),
                  40);
}

TEST(Keys, AMouseButtonIsPressed) {
  EXPECT_FLOAT_EQ(walkSpeedWith("player:GetMouse().Button1Down:Connect(function() "
                                "human().WalkSpeed = 40 end)"),
                  40);
}

TEST(Keys, AnActionThatReplacesTheJumpIsTheJump) {
  Scene scene;
  keyScript(scene, R"(game.ContextActionService:BindAction('Super', function(_, state)
  if state == Enum.UserInputState.Begin then
    player.Character.HumanoidRootPart.AssemblyLinearVelocity = Vector3.new(0, 120, 0)
  end
  return Enum.ContextActionResult.Sink
end, false, Enum.PlayerActions.CharacterJump))");
  EXPECT_FLOAT_EQ(scene.level().world.jumpSpeed, 120);
  EXPECT_EQ(scene.unmodelled("controls that scripts take away"), 0u);
}

TEST(Keys, DisabledControlsAreReported) {
  Scene scene;
  keyScript(scene,
            "game.ContextActionService:BindAction('freeze', function() return "
            "Enum.ContextActionResult.Sink end, false, "
            "unpack(Enum.PlayerActions:GetEnumItems()))");
  scene.level();
  EXPECT_GE(scene.unmodelled("controls that scripts take away"), 4u);
}

TEST(Keys, AHeldScreenButtonIsAnAbility) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto starter = scene.add("StarterGui", "StarterGui", kNoInstance);
  const auto gui = scene.add("ScreenGui", "ScreenGui", starter);
  const auto button = scene.add("TextButton", "Sprint", gui);
  const auto script = scene.add("LocalScript", "LocalScript", button);
  scene.set(script, "Source",
            std::string(R"(local human = game.Players.LocalPlayer.Character.Humanoid
script.Parent.MouseButton1Down:Connect(function() human.WalkSpeed = 40 end)
script.Parent.MouseButton1Up:Connect(function() human.WalkSpeed = 16 end))"));
  EXPECT_FLOAT_EQ(scene.level().world.walkSpeed, 40);
}

TEST(Keys, AScreenButtonWithoutAVisibleEffectIsNamed) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto starter = scene.add("StarterGui", "StarterGui", kNoInstance);
  const auto gui = scene.add("ScreenGui", "ScreenGui", starter);
  const auto button = scene.add("TextButton", "Buy", gui);
  const auto script = scene.add("LocalScript", "LocalScript", button);
  scene.set(script, "Source", std::string("script.Parent.Activated:Connect(function() end)"));
  scene.level();
  EXPECT_EQ(scene.unmodelled("input without a visible effect"), 1u);
  EXPECT_EQ(scene.unmodelled("keys that a script listens to"), 0u);
}

TEST(Keys, ChatCommandsInScriptsAreTried) {
  Scene scene;
  const auto bridge = scene.part("Bridge");
  scene.set(bridge, "CanCollide", false);
  scene.script(R"(game.Players.PlayerAdded:Connect(function(player)
  player.Chatted:Connect(function(text)
    if text:lower() == '!bridge' then workspace.Bridge.CanCollide = true end
  end)
end))",
               scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[bridge].solid);
}

TEST(Keys, ChatWithoutAnEffectIsNamed) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  scene.script("game.Players.PlayerAdded:Connect(function(p) p.Chatted:Connect(print) end)",
               scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("chat that scripts listen to"), 1u);
}

TEST(Keys, TextCommandsAreTried) {
  Scene scene;
  const auto bridge = scene.part("Bridge");
  scene.set(bridge, "CanCollide", false);
  const auto chat = scene.add("TextChatService", "TextChatService", kNoInstance);
  scene.add("TextChatCommand", "Build", chat);
  scene.script(
      "game:GetService('TextChatService').Build.Triggered:Connect(function() "
      "workspace.Bridge.CanCollide = true end)",
      scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[bridge].solid);
}

TEST(Keys, StartingADragCountsAsUsingThePart) {
  Scene scene;
  const auto lever = scene.part("Lever"), wall = scene.part("Wall", {20, 0, 0});
  scene.add("DragDetector", "DragDetector", lever);
  scene.script(
      "script.Parent.DragDetector.DragStart:Connect(function() "
      "workspace.Wall:Destroy() end)",
      lever);
  scene.level();
  EXPECT_TRUE(scene[lever].button);
  EXPECT_TRUE(scene[wall].vanish);
  EXPECT_EQ(scene.unmodelled("part that players drag"), 1u);
}

}  // namespace
}  // namespace obby::test
