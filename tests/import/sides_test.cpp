// Effects of scripts on players away from parts, from afar, and on one side only.
#include "import/player_script.h"

namespace obby::test {
namespace {

struct Place {
  Scene scene;
  Place() { scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation"); }
  InstanceId button(Vec3 position) {
    const InstanceId part = scene.part("Button", position);
    scene.add("ClickDetector", "ClickDetector", part);
    return part;
  }
  void local(const std::string& source) { localScript(scene, "StarterPlayerScripts", source); }
};

TEST(Uses, HappenAtTheButton) {
  Place place;
  const auto door = place.scene.part("Door", {0, 10, 0});
  place.button({100, 0, 0});
  place.scene.script(R"(workspace.Button.ClickDetector.MouseClick:Connect(function(player)
  local root = player.Character.HumanoidRootPart
  if (root.Position - workspace.Button.Position).Magnitude < 15 then workspace.Door.CanCollide = false end
end))",
                     place.scene.scripts);
  place.scene.level();
  EXPECT_TRUE(place.scene[door].vanish);
}

// The player of a use stands in the same pose as for a touch, with a yaw of 0.3 radians.
TEST(Uses, AreMadeWithTheYawOfATouch) {
  Place place;
  const auto door = place.scene.part("Door", {0, 10, 0});
  place.button({100, 0, 0});
  place.scene.script(R"(workspace.Button.ClickDetector.MouseClick:Connect(function(player)
  local _, yaw = player.Character.HumanoidRootPart.CFrame:ToOrientation()
  if math.abs(yaw - 0.3) < 0.001 then workspace.Door.CanCollide = false end
end))",
                     place.scene.scripts);
  place.scene.level();
  EXPECT_TRUE(place.scene[door].vanish);
}

TEST(Away, HarmEverywhereIsNotAttributedToAPart) {
  Place place;
  const auto pad = place.scene.part("Pad", {30, 0, 0});
  place.scene.script(R"(game:GetService('RunService').Heartbeat:Connect(function()
  for _, player in game.Players:GetPlayers() do
    local root = player.Character and player.Character:FindFirstChild('HumanoidRootPart')
    if root and root.Position.Magnitude > 20 then player.Character.Humanoid.Health = 0 end
  end
end))",
                     place.scene.scripts);
  place.scene.level();
  EXPECT_FALSE(place.scene[pad].kill);
  EXPECT_EQ(place.scene.unmodelled("script that acts on players without a touch"), 1u);
}

TEST(Sides, AClientBindableDoesNotReachTheServer) {
  Place place;
  const auto door = place.scene.part("Door", {0, 10, 0});
  const auto shared = place.scene.add("ReplicatedStorage", "ReplicatedStorage", kNoInstance);
  place.scene.add("BindableEvent", "Open", shared);
  place.scene.script(
      "game.ReplicatedStorage.Open.Event:Connect(function() workspace.Door.CanCollide = false end)",
      place.scene.scripts);
  place.local("task.wait(1)\ngame:GetService('ReplicatedStorage'):WaitForChild('Open'):Fire()");
  place.scene.level();
  EXPECT_TRUE(place.scene[door].solid);
}

TEST(Sides, AClientValueDoesNotReachTheServer) {
  Place place;
  const auto door = place.scene.part("Door", {0, 10, 0});
  const auto shared = place.scene.add("ReplicatedStorage", "ReplicatedStorage", kNoInstance);
  place.scene.value("BoolValue", "Open", false, shared);
  place.scene.script(
      "game.ReplicatedStorage.Open.Changed:Connect(function() workspace.Door.CanCollide = false "
      "end)",
      place.scene.scripts);
  place.local(
      "task.wait(1)\ngame:GetService('ReplicatedStorage'):WaitForChild('Open').Value = true");
  place.scene.level();
  EXPECT_TRUE(place.scene[door].solid);
}

TEST(Touches, APartThatATouchCreatesCanKill) {
  Place place;
  const auto pad = place.scene.part("Pad", {30, 0, 0});
  place.scene.script(R"(workspace.Pad.Touched:Connect(function()
  if workspace:FindFirstChild('Spike') then return end
  local spike = Instance.new('Part')
  spike.Name, spike.Anchored, spike.CanCollide, spike.Size = 'Spike', true, false, Vector3.new(6, 8, 6)
  spike.Position = workspace.Pad.Position + Vector3.new(0, 3, 0)
  spike.Touched:Connect(function(hit)
    local human = hit.Parent:FindFirstChild('Humanoid')
    if human then human.Health = 0 end
  end)
  spike.Parent = workspace
end))",
                     place.scene.scripts);
  place.scene.level();
  EXPECT_TRUE(place.scene[pad].kill);
}

}  // namespace
}  // namespace obby::test
