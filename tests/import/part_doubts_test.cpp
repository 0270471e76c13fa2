// The parts that a loss concerns.
#include <gtest/gtest.h>

#include "import/level/doubts.h"
#include "import/scene.h"

namespace obby::test {
namespace {

using Kinds = std::vector<std::string>;
const std::string kFails = "error('no')";

struct Doubted : Scene {
  Doubted() {
    for (int i = 0; i < 10; ++i) part("Plain", {100.0f * float(i), 0, 0});
  }
  Kinds doubts(InstanceId id) { return (*this)[id].doubts; }
  bool anywhere(const std::string& kind) { return level().unmodelled.at(kind).anywhere; }
};

TEST(PartDoubts, AScriptInAPartConcernsThatPart) {
  Doubted scene;
  const InstanceId part = scene.part("Trap"), other = scene.part("Other", {20, 0, 0});
  scene.script(kFails, part);
  scene.script(kFails, part);
  scene.level();
  EXPECT_EQ(scene.doubts(part), Kinds{"script that fails"});
  EXPECT_EQ(scene.doubts(other), Kinds{});
  EXPECT_FALSE(scene.anywhere("script that fails"));
}

TEST(PartDoubts, AScriptInAModelConcernsItsParts) {
  Doubted scene;
  const InstanceId model = scene.add("Model", "Door", scene.workspace);
  const InstanceId left = scene.part("Left", {20, 0, 0}, model),
                   right = scene.part("Right", {24, 0, 0}, model);
  scene.script(kFails, model);
  scene.level();
  EXPECT_EQ(scene.doubts(left), Kinds{"script that fails"});
  EXPECT_EQ(scene.doubts(right), Kinds{"script that fails"});
}

TEST(PartDoubts, ServiceAndLargeModelScriptsConcernNoPart) {
  for (const bool folder : {false, true}) {
    Scene scene;
    const InstanceId map = scene.add("Folder", "Map", scene.workspace);
    const InstanceId part = scene.part("Part", {20, 0, 0}, map);
    scene.part("Part", {30, 0, 0}, map);
    scene.script(kFails, folder ? map : scene.scripts);
    EXPECT_TRUE(scene.level().unmodelled.at("script that fails").anywhere);
    EXPECT_EQ(scene[part].doubts, Kinds{});
  }
}

const std::string kKillsLater =
    "\nscript.Parent.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end)";

// An error ends a script in the game, too. An error at a feature that the twin lacks might not.
TEST(PartDoubts, AScriptThatFailsBeforeItListensIsHarmless) {
  Doubted scene;
  const InstanceId wrong = scene.part("Wrong", {20, 0, 0}), limited = scene.part("Limited");
  scene.script("local value = workspace.Missing.Value" + kKillsLater, wrong);
  scene.script("local module = require(123456)" + kKillsLater, limited);
  scene.level();
  EXPECT_FALSE(scene[wrong].kill);
  EXPECT_EQ(scene.doubts(wrong), Kinds{"script that fails"});
  ASSERT_TRUE(scene[limited].kill);
  EXPECT_TRUE(scene[limited].evidence.back().guessed);
}

TEST(PartDoubts, MovingAPlayerWithoutATouchIsReported) {
  const std::string pushes[] = {
      "character:PivotTo(CFrame.new(0, 50, 0))",
      "character.HumanoidRootPart.AssemblyLinearVelocity = Vector3.new(0, 90, 0)",
      "local force = Instance.new('BodyVelocity') force.Velocity = Vector3.new(9, 0, 0) "
      "force.Parent = character.HumanoidRootPart"};
  for (const std::string& push : pushes) {
    Doubted scene;
    scene.script(
        "game.Players.PlayerAdded:Connect(function(player)\n"
        " local character = player.Character or player.CharacterAdded:Wait()\n"
        " task.wait(20)\n " +
            push + "\nend)",
        scene.scripts);
    EXPECT_EQ(scene.unmodelled("push without a touch"), 0u);
    scene.level();
    EXPECT_EQ(scene.unmodelled("push without a touch"), 1u) << push;
  }
}

// Scripts that all run without errors decide what kills; a name alone does not.
TEST(PartDoubts, ANameKillsOnlyIfScriptsDoNotDecide) {
  for (const std::string& text : {std::string(), std::string("print('x')"), kFails}) {
    Scene scene;
    const InstanceId lava = scene.part("Lava", {20, 0, 0});
    if (!text.empty()) scene.script(text, scene.scripts);
    scene.level();
    EXPECT_EQ(scene[lava].kill.has_value(), text != "print('x')") << text;
  }
}

TEST(PartDoubts, HelpfulAndHarmfulLossesAreDistinguished) {
  EXPECT_EQ(importer::bearingOf("tool"), importer::Bearing::easier);
  EXPECT_EQ(importer::bearingOf("harm without a touch"), importer::Bearing::harder);
  EXPECT_EQ(importer::bearingOf("script that fails"), importer::Bearing::either);
}

// A kill part that moves into the player at the spawn is harm with a known cause.
TEST(PartDoubts, AKillPartMovingToSpawnIsNoLoss) {
  Scene scene;
  const InstanceId arm = scene.part("Arm", {12, 3, 0});
  scene.script(R"(
script.Parent.Touched:Connect(function(hit)
  local humanoid = hit.Parent:FindFirstChild("Humanoid")
  if humanoid then humanoid.Health = 0 end
end)
while true do
  script.Parent.CFrame = CFrame.new(12, 3, 0)
  task.wait(2)
  script.Parent.CFrame = CFrame.new(0, 3, 0)
  task.wait(2)
end)",
               arm);
  scene.level();
  EXPECT_TRUE(scene[arm].kill);
  EXPECT_FALSE(scene.level().unmodelled.contains("harm without a touch"));
}

}  // namespace
}  // namespace obby::test
