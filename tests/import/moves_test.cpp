// Effects of scripts on the player's own moves.
#include "import/player_script.h"

namespace obby::test {
namespace {

void perBody(Scene& scene, const std::string& source) {
  bodyScript(scene, "local root = script.Parent:WaitForChild('HumanoidRootPart')\n" + source);
}

TEST(Moves, ALaunchOnJumpingIsThePlayersJump) {
  Scene scene;
  perBody(scene, R"(human.Jumping:Connect(function(active)
  if active then root.AssemblyLinearVelocity = Vector3.new(0, 100, 0) end
end))");
  EXPECT_FLOAT_EQ(scene.level().world.jumpSpeed, 100);
}

TEST(Moves, AMoverOnEachJumpCountsAndIsReported) {
  Scene scene;
  perBody(scene, R"(human.StateChanged:Connect(function(_, new)
  if new ~= Enum.HumanoidStateType.Jumping then return end
  local push = Instance.new('BodyVelocity', root)
  push.Velocity = Vector3.new(0, 90, 0)
  game.Debris:AddItem(push, 0.2)
end))");
  EXPECT_GT(scene.level().world.jumpSpeed, 110);
  EXPECT_EQ(scene.unmodelled("push that lasts"), 1u);
}

TEST(Moves, ALaunchOnOnlySomeJumpsIsReported) {
  Scene scene;
  perBody(scene, R"(local used
human.Jumping:Connect(function(active)
  if active and not used then used = true root.Velocity = Vector3.new(0, 100, 0) end
end))");
  EXPECT_LT(scene.level().world.jumpSpeed, 60);
  EXPECT_EQ(scene.unmodelled("ability of the player"), 1u);
}

TEST(Moves, APlayerWhoDiesAtTakeOffCannotJump) {
  Scene scene;
  perBody(scene, "human.Jumping:Connect(function(active) if active then human.Health = 0 end end)");
  EXPECT_EQ(scene.level().world.jumpSpeed, 0);
  EXPECT_EQ(scene.unmodelled("harm by falling"), 0u);
}

TEST(Moves, HarmInTheAirIsNamed) {
  Scene scene;
  perBody(scene, R"(local air = 0
game:GetService('RunService').Heartbeat:Connect(function(dt)
  air = human.FloorMaterial == Enum.Material.Air and air + dt or 0
  if air > 0.3 then human.Health = 0 end
end))");
  EXPECT_GT(scene.level().world.jumpSpeed, 50);
  EXPECT_EQ(scene.unmodelled("harm by jumping"), 1u);
  EXPECT_EQ(scene.unmodelled("harm by falling"), 1u);
}

TEST(Moves, HarmFromHighFallsOnlyIsReported) {
  Scene scene;
  perBody(scene, R"(local from
human.StateChanged:Connect(function(_, new)
  if new == Enum.HumanoidStateType.Freefall then from = root.Position.Y end
  if new == Enum.HumanoidStateType.Landed and from - root.Position.Y > 25 then human:TakeDamage(80) end
end))");
  const LevelDraft& level = scene.level();
  EXPECT_EQ(scene.unmodelled("harm by falling"), 1u);
  EXPECT_EQ(scene.unmodelled("harm by jumping"), 0u);
  EXPECT_TRUE(level.unmodelled.at("harm by falling").anywhere);
}

TEST(Moves, WalkingInAForbiddenZoneKills) {
  Scene scene;
  scene.part("SpawnLocation", {0, 0, 60}, scene.workspace, "SpawnLocation");
  const auto zone = scene.part("Zone", {0, 5, 0}), floor = scene.part("Floor", {0, 0, 20});
  scene.set(zone, "Size", Vec3{20, 10, 20});
  scene.set(zone, "CanCollide", false);
  scene.script(R"(while task.wait(0.1) do
  for _, player in game.Players:GetPlayers() do
    local human = player.Character and player.Character:FindFirstChild('Humanoid')
    if human and human.MoveDirection.Magnitude > 0 then
      for _, part in workspace:GetPartsInPart(workspace.Zone) do
        if part:IsDescendantOf(player.Character) then human.Health = 0 break end
      end
    end
  end
end)",
               scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[zone].kill);
  EXPECT_FALSE(scene[floor].kill);
}

TEST(Moves, EffectsOfWalkingAreNotAttributedToAPart) {
  Scene scene;
  const auto pad = scene.part("Pad", {20, 0, 0});
  scene.script("script.Parent.Touched:Connect(function() end)", pad);
  perBody(scene, R"(game:GetService('RunService').Heartbeat:Connect(function()
  human.WalkSpeed = human.MoveDirection.Magnitude > 0 and 24 or 16
end))");
  scene.level();
  EXPECT_FALSE(scene[pad].boost);
  EXPECT_EQ(scene.unmodelled("speed that scripts change"), 4u);
}

TEST(Moves, APadKillingOnlyFallingPlayersIsInDoubt) {
  Scene scene;
  scene.part("SpawnLocation", {0, 0, 60}, scene.workspace, "SpawnLocation");
  const auto pad = scene.part("Pad");
  scene.script(R"(script.Parent.Touched:Connect(function(hit)
  local root = hit.Parent:FindFirstChild('HumanoidRootPart')
  if root and root.AssemblyLinearVelocity.Y < -60 then hit.Parent.Humanoid.Health = 0 end
end))",
               pad);
  scene.level();
  EXPECT_EQ(scene[pad].doubts, std::vector<std::string>{"touch that acts differently in a fall"});
}

}  // namespace
}  // namespace obby::test
