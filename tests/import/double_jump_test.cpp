// Jumps in the air that scripts give the player: the number of jumps, and whether a floor restores
// them.
#include "import/player_script.h"

namespace obby::test {
namespace {

// Returns the air jumps of a level whose script runs for each new body.
uint16_t airJumpsOf(const std::string& source, Scene& scene) {
  bodyScript(scene, "local input = game:GetService('UserInputService')\n" + source);
  return scene.level().world.airJumps;
}
uint16_t airJumpsOf(const std::string& source) {
  Scene scene;
  return airJumpsOf(source, scene);
}

constexpr const char* kDouble = R"(local can, used = false, false
input.JumpRequest:Connect(function()
  if can and not used then
    used = true
    human:ChangeState(Enum.HumanoidStateType.Jumping)
  end
end)
human.StateChanged:Connect(function(_, new)
  if new == Enum.HumanoidStateType.Landed then
    can, used = false, false
  elseif new == Enum.HumanoidStateType.Freefall then
    task.wait(0.2)
    can = true
  end
end))";

TEST(DoubleJump, AJumpRequestAllowsOneAirJump) {
  Scene scene;
  EXPECT_EQ(airJumpsOf(kDouble, scene), 1);
  EXPECT_EQ(scene.unmodelled("keys that a script listens to"), 0u);
  EXPECT_EQ(scene.unmodelled("ability of the player"), 0u);
}

TEST(DoubleJump, ACounterOnTheSpaceKeyLimitsAirJumps) {
  EXPECT_EQ(airJumpsOf(R"(local left = 2
input.InputBegan:Connect(function(key)
  if key.KeyCode ~= Enum.KeyCode.Space or human:GetState() ~= Enum.HumanoidStateType.Freefall then return end
  if left > 0 then
    left = left - 1
    human:ChangeState("Jumping")
  end
end)
human.StateChanged:Connect(function(_, new)
  if new == Enum.HumanoidStateType.Landed then left = 2 end
end))"),
            2);
}

TEST(DoubleJump, JumpsWithoutACounterAreUnlimited) {
  EXPECT_EQ(airJumpsOf("input.JumpRequest:Connect(function() "
                       "human:ChangeState(Enum.HumanoidStateType.Jumping) end)"),
            100);
}

TEST(DoubleJump, AJumpOncePerLifeAddsNoAirJump) {
  Scene scene;
  EXPECT_EQ(airJumpsOf(R"(local used = false
input.JumpRequest:Connect(function()
  if used or human.FloorMaterial ~= Enum.Material.Air then return end
  used = true
  human:ChangeState(Enum.HumanoidStateType.Jumping)
end))",
                       scene),
            0);
}

TEST(DoubleJump, OtherKeysAreStillNamed) {
  Scene scene;
  EXPECT_EQ(airJumpsOf("input.InputBegan:Connect(function() print('key') end)", scene), 0);
  EXPECT_EQ(scene.unmodelled("keys that a script listens to"), 1u);
}

}  // namespace
}  // namespace obby::test
