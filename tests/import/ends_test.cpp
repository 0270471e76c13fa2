// Touches after which a player can no longer continue, and doubts about the player's abilities.
#include "import/player_script.h"

namespace obby::test {
namespace {

struct Touched {
  Scene scene;
  InstanceId pad;
  explicit Touched(const std::string& effect) {
    scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
    pad = scene.part("Pad", {20, 0, 0});
    scene.script(
        "workspace.Pad.Touched:Connect(function(hit)\n"
        "  local body = hit.Parent\n"
        "  local human = body:FindFirstChild('Humanoid')\n"
        "  if not human then return end\n"
        "  local player = game.Players:GetPlayerFromCharacter(body)\n" +
            effect + "\nend)",
        scene.scripts);
    scene.level();
  }
  bool ends() const { return scene[pad].kill && scene[pad].kill->damage > 1000; }
  bool doubtful() const {
    const auto& doubts = scene[pad].doubts;
    return std::count(doubts.begin(), doubts.end(), "part that stops the player") > 0;
  }
};

TEST(Ends, AKickEndsTheAttempt) { EXPECT_TRUE(Touched("player:Kick('no')").ends()); }

TEST(Ends, AnotherPlaceEndsTheAttempt) {
  EXPECT_TRUE(Touched("game:GetService('TeleportService'):Teleport(1, player)").ends());
}

TEST(Ends, APermanentlyAnchoredBodyEndsIt) {
  EXPECT_TRUE(Touched("body.HumanoidRootPart.Anchored = true").ends());
}

TEST(Ends, AReleasedBodyDoesNotEndIt) {
  const Touched touched(
      "body.HumanoidRootPart.Anchored = true\n"
      "task.wait(2)\nbody.HumanoidRootPart.Anchored = false");
  EXPECT_FALSE(touched.ends());
}

TEST(Ends, PermanentPlatformStandEndsIt) {
  EXPECT_TRUE(Touched("human.PlatformStand = true").ends());
}

TEST(Ends, PermanentZeroSpeedEndsIt) { EXPECT_TRUE(Touched("human.WalkSpeed = 0").ends()); }

TEST(Ends, ADisabledStateRaisesADoubt) {
  EXPECT_TRUE(Touched("human:SetStateEnabled(Enum.HumanoidStateType.Jumping, false)").doubtful());
  EXPECT_FALSE(Touched("human:SetStateEnabled(Enum.HumanoidStateType.Ragdoll, false)").doubtful());
}

LevelDraft bodyBy(const std::string& source, Scene& scene) {
  bodyScript(scene, source);
  return scene.level();
}

TEST(Body, AScriptedSlopeLimitAppliesToThePlayer) {
  Scene scene;
  EXPECT_NEAR(bodyBy("human.MaxSlopeAngle = 20", scene).world.maxSlope, 0.349f, 1e-3f);
}

TEST(Body, AScriptedHipHeightIsReported) {
  Scene scene;
  bodyBy("human.HipHeight = 18", scene);
  EXPECT_EQ(scene.unmodelled("hip height that scripts change"), 1u);
}

TEST(Body, DisabledControlsAreReported) {
  Scene scene;
  bodyBy(
      "local scripts = game.Players.LocalPlayer:WaitForChild('PlayerScripts')\n"
      "require(scripts:WaitForChild('PlayerModule')):GetControls():Disable()",
      scene);
  EXPECT_EQ(scene.unmodelled("player that cannot walk"), 1u);
}

}  // namespace
}  // namespace obby::test
