// Gravity that a touch changes, by Workspace or by a force on the player.
#include <cmath>

#include "import/scene.h"

namespace obby::test {
namespace {

struct PadScene {
  Scene scene;
  InstanceId pad = scene.part("Pad", {0, 10, -20});

  explicit PadScene(const std::string& source) {
    scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
    scene.script(source, pad);
    scene.level();
  }
  std::optional<importer::Boost> boost() const { return scene[pad].boost; }
};

constexpr const char* kForever = R"(script.Parent.Touched:Connect(function(hit)
  if hit.Parent:FindFirstChild("Humanoid") then workspace.Gravity = 98.1 end
end))";

TEST(GravityByTouch, LastsForever) {
  const PadScene place(kForever);
  ASSERT_TRUE(place.boost());
  EXPECT_NEAR(place.boost()->gravity, 0.5f, 1e-4f);
  EXPECT_EQ(place.boost()->jumpSpeed, 1);
  EXPECT_TRUE(place.boost()->forever);
  EXPECT_NE(place.scene.evidence(place.pad, "boost").find("line 2"), std::string::npos);
}

TEST(GravityByTouch, EndsAfterItsDuration) {
  const PadScene place(R"(local busy = false
script.Parent.Touched:Connect(function(hit)
  if busy or not hit.Parent:FindFirstChild("Humanoid") then return end
  busy = true
  workspace.Gravity = 50
  task.wait(4)
  workspace.Gravity = 196.2
  busy = false
end))");
  ASSERT_TRUE(place.boost());
  EXPECT_NEAR(place.boost()->gravity, 50 / 196.2f, 1e-4f);
  EXPECT_FALSE(place.boost()->forever);
  EXPECT_NEAR(place.boost()->seconds, 4, 0.1f);
}

TEST(GravityByTouch, EndsAsThePlayerLeaves) {
  const PadScene place(R"(
script.Parent.Touched:Connect(function() workspace.Gravity = 300 end)
script.Parent.TouchEnded:Connect(function() workspace.Gravity = 196.2 end))");
  ASSERT_TRUE(place.boost());
  EXPECT_GT(place.boost()->gravity, 1.5f);
  EXPECT_FALSE(place.boost()->forever);
  EXPECT_EQ(place.boost()->seconds, 0);
}

TEST(GravityByTouch, AJumpHeightStaysSoTheSpeedChanges) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  scene.set(player, "CharacterUseJumpPower", false);
  const auto pad = scene.part("Pad", {0, 10, -20});
  scene.script(kForever, pad);
  scene.level();
  ASSERT_TRUE(scene[pad].boost);
  EXPECT_NEAR(scene[pad].boost->jumpSpeed, std::sqrt(0.5f), 1e-4f);
}

TEST(JumpByTouch, OnlyTheSettingThatTheBodyUsesCounts) {
  const PadScene place(R"(script.Parent.Touched:Connect(function(hit)
  local human = hit.Parent:FindFirstChild("Humanoid")
  if human then human.JumpPower = 75 human.JumpHeight = 20 end
end))");
  ASSERT_TRUE(place.boost());
  EXPECT_NEAR(place.boost()->jumpSpeed, 1.5f, 1e-4f);
  const PadScene other(R"(script.Parent.Touched:Connect(function(hit)
  local human = hit.Parent:FindFirstChild("Humanoid")
  if human then human.JumpHeight = 20 end
end))");
  EXPECT_FALSE(other.boost());
}

TEST(GravityByTouch, AForceReducesWeightAndIsThenRemoved) {
  const PadScene place(R"(script.Parent.Touched:Connect(function(hit)
  local root = hit.Parent:FindFirstChild("HumanoidRootPart")
  if root and not root:FindFirstChild("Moon") then
    local force = Instance.new("VectorForce")
    force.Name = "Moon"
    force.Attachment0 = Instance.new("Attachment", root)
    force.RelativeTo = Enum.ActuatorRelativeTo.World
    force.Force = Vector3.new(0, root.AssemblyMass * 98.1, 0)
    force.Parent = root
    game.Debris:AddItem(force, 3)
  end
end))");
  ASSERT_TRUE(place.boost());
  EXPECT_NEAR(place.boost()->gravity, 0.5f, 1e-3f);
  EXPECT_EQ(place.boost()->jumpSpeed, 1);
  EXPECT_FALSE(place.boost()->forever);
  EXPECT_NEAR(place.boost()->seconds, 3, 0.1f);
  EXPECT_EQ(place.scene.unmodelled("force on the player"), 0u);
}

TEST(GravityByTouch, ABodyForceCountsByTheMassOfTheWholeBody) {
  const PadScene place(R"(script.Parent.Touched:Connect(function(hit)
  local root = hit.Parent:FindFirstChild("HumanoidRootPart")
  if root and not root:FindFirstChildOfClass("BodyForce") then
    local force = Instance.new("BodyForce", root)
    force.Force = Vector3.new(0, 1236.06, 0)
  end
end))");
  ASSERT_TRUE(place.boost());
  EXPECT_NEAR(place.boost()->gravity, 0.5f, 1e-3f);
  EXPECT_TRUE(place.boost()->forever);
}

TEST(GravityByTouch, SidewaysAndLiftingForcesAreReported) {
  for (const char* const force : {"5000, 500, 0", "0, 5000, 0"}) {
    const PadScene place(std::string(R"(script.Parent.Touched:Connect(function(hit)
  local root = hit.Parent:FindFirstChild("HumanoidRootPart")
  if root and not root:FindFirstChildOfClass("BodyForce") then
    local force = Instance.new("BodyForce")
    force.Force = Vector3.new()") +
                         force + R"()
    force.Parent = root
  end
end))");
    EXPECT_FALSE(place.boost() && place.boost()->gravity == 1) << force;
    EXPECT_EQ(place.scene.unmodelled("force on the player"), 1u) << force;
  }
}

TEST(GravityByTouch, AResettingPadEndsTheEffectOfOthers) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto low = scene.part("Low", {0, 10, -20}), back = scene.part("Back", {0, 10, -60});
  scene.script(kForever, low);
  scene.script("script.Parent.Touched:Connect(function() workspace.Gravity = 196.2 end)", back);
  scene.level();
  ASSERT_TRUE(scene[low].boost);
  ASSERT_TRUE(scene[back].boost);
  EXPECT_TRUE(scene[back].boost->resets);
  EXPECT_TRUE(scene[back].boost->forever);
}

TEST(GravityByTouch, AResettingPadRestoresTheWalkSpeed) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  const auto fast = scene.part("Fast", {0, 10, -20}), back = scene.part("Back", {0, 10, -60});
  for (const auto& [pad, speed] : {std::pair{fast, "32"}, std::pair{back, "16"}})
    scene.script(std::string(R"(script.Parent.Touched:Connect(function(hit)
  local human = hit.Parent:FindFirstChild("Humanoid")
  if human then human.WalkSpeed = )") +
                     speed + " end end)",
                 pad);
  scene.level();
  ASSERT_TRUE(scene[fast].boost);
  EXPECT_FALSE(scene[fast].boost->resets);
  ASSERT_TRUE(scene[back].boost);
  EXPECT_TRUE(scene[back].boost->resets);
  EXPECT_EQ(scene.unmodelled("touch with a later effect"), 1u);
}

TEST(GravityByTouch, AForceOnEveryBodyChangesTheLevelsGravity) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  scene.script(R"(game.Players.PlayerAdded:Connect(function(player)
  player.CharacterAdded:Connect(function(body)
    local root = body:WaitForChild("HumanoidRootPart")
    local force = Instance.new("BodyForce", root)
    force.Force = Vector3.new(0, root.AssemblyMass * 98.1, 0)
  end)
end))",
               scene.scripts);
  EXPECT_NEAR(scene.level().world.gravity, 98.1f, 0.1f);
}

TEST(GravityByTouch, AnUntriggeredChangeIsReported) {
  Scene scene;
  scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
  scene.script(
      "while true do workspace.Gravity = 50 task.wait(5) workspace.Gravity = 196.2 task.wait(5) "
      "end",
      scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("gravity that scripts change"), 1u);
}

}  // namespace
}  // namespace obby::test
