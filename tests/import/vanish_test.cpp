// Parts that disappear, by a touch or by a timer.
#include <cmath>

#include "import/scene.h"

namespace obby::test {
namespace {

TEST(Vanish, AFadingPartVanishesAtTheScriptsTimes) {
  Scene scene;
  const auto part = scene.part("Fading");
  scene.script(R"(local platform = script.Parent
local isTouched = false
local function fade()
  if not isTouched then
    isTouched = true
    for count = 1, 10 do
      platform.Transparency = count / 10
      task.wait(0.1)
    end
    platform.CanCollide = false
    task.wait(3)
    platform.CanCollide = true
    platform.Transparency = 0
    isTouched = false
  end
end
platform.Touched:Connect(function(otherPart)
  if otherPart.Parent:FindFirstChildWhichIsA("Humanoid") then fade() end
end))",
               part);
  scene.level();
  ASSERT_TRUE(scene[part].vanish);
  EXPECT_FALSE(scene[part].vanish->timer);
  EXPECT_NEAR(scene[part].vanish->delay, 1, 0.02);
  EXPECT_NEAR(scene[part].vanish->away, 3, 1e-3);
}

constexpr double kFrames = 0.04;  // tolerance in seconds, since waits end on a frame

TEST(Vanish, PartsVanishAtOnceOrAfterADelay) {
  Scene scene;
  const auto atOnce = scene.part("A"), delayed = scene.part("B"), forGood = scene.part("C");
  scene.script(
      "script.Parent.Touched:connect(function() script.Parent.CanCollide = false "
      "wait(3) script.Parent.CanCollide = true end)",
      atOnce);
  scene.script(
      "local p = script.Parent\np.Touched:Connect(function()\n"
      " task.delay(0.5, function() p.CanCollide = false end)\n"
      " task.delay(2.5, function() p.CanCollide = true end)\nend)",
      delayed);
  scene.script("script.Parent.Touched:Connect(function() wait(1) script.Parent:Destroy() end)",
               forGood);
  scene.level();
  EXPECT_NEAR(scene[atOnce].vanish->delay, 0, kFrames);
  EXPECT_NEAR(scene[atOnce].vanish->away, 3, kFrames);
  ASSERT_TRUE(scene[delayed].vanish);
  EXPECT_NEAR(scene[delayed].vanish->delay, 0.5, kFrames);
  EXPECT_NEAR(scene[delayed].vanish->away, 2, kFrames);
  EXPECT_NEAR(scene[forGood].vanish->delay, 1, kFrames);
  EXPECT_GE(scene[forGood].vanish->away, 600);
}

TEST(Vanish, OneScriptForAFolderOfPlatforms) {
  Scene scene;
  const auto folder = scene.add("Folder", "DisappearingPlatforms", scene.workspace);
  const auto a = scene.part("P", {}, folder), b = scene.part("P", {8, 0, 0}, folder);
  scene.value("NumberValue", "Off", 5.0, folder);
  scene.script(R"(local folder = workspace:WaitForChild("DisappearingPlatforms")
local function onTouched(platform)
  wait(0.5)
  platform.CanCollide = false
  wait(folder.Off.Value)
  platform.CanCollide = true
end
for _, platform in pairs(folder:GetChildren()) do
  if platform:IsA("BasePart") then
    platform.Touched:Connect(function(hit)
      if hit.Parent:FindFirstChild("Humanoid") then onTouched(platform) end
    end)
  end
end)",
               scene.scripts);
  scene.level();
  for (const auto id : {a, b}) {
    ASSERT_TRUE(scene[id].vanish);
    EXPECT_NEAR(scene[id].vanish->delay, 0.5, kFrames);
    EXPECT_NEAR(scene[id].vanish->away, 5, kFrames);
  }
}

TEST(Vanish, TimersGiveTimesAndPhase) {
  Scene scene;
  const auto starts = scene.part("StartsSolid"), gone = scene.part("StartsGone"),
             toggles = scene.part("Toggles");
  scene.script(
      "while true do\n wait(3)\n script.Parent.CanCollide = false\n wait(1)\n"
      " script.Parent.CanCollide = true\nend",
      starts);
  scene.script(
      "while true do\n script.Parent.CanCollide = false\n wait(2)\n"
      " script.Parent.CanCollide = true\n wait(2.5)\nend",
      gone);
  scene.script("while wait(2) do script.Parent.CanCollide = not script.Parent.CanCollide end",
               toggles);
  scene.level();
  for (const auto id : {starts, gone, toggles}) {
    ASSERT_TRUE(scene[id].vanish) << id;
    EXPECT_TRUE(scene[id].vanish->timer);
  }
  const auto period = [&](InstanceId id) {
    return scene[id].vanish->delay + scene[id].vanish->away;
  };
  EXPECT_NEAR(scene[starts].vanish->delay, 3, kFrames);
  EXPECT_NEAR(scene[starts].vanish->away, 1, kFrames);
  EXPECT_NEAR(std::remainder(scene[starts].vanish->phase - 0, period(starts)), 0, kFrames);
  EXPECT_NEAR(scene[gone].vanish->delay, 2.5, kFrames);
  EXPECT_NEAR(scene[gone].vanish->away, 2, kFrames);
  EXPECT_NEAR(std::remainder(scene[gone].vanish->phase - 2.5, period(gone)), 0, kFrames);
  EXPECT_NEAR(scene[toggles].vanish->delay, 2, kFrames);
  EXPECT_NEAR(scene[toggles].vanish->away, 2, kFrames);
}

TEST(Vanish, RandomVanishingIsReported) {
  Scene scene;
  const auto part = scene.part("Risky");
  scene.script(
      "while true do\n wait(2)\n if math.random(1, 10) == 1 then\n  wait(1.5)\n"
      "  script.Parent.CanCollide = false\n  wait(5)\n  script.Parent.CanCollide = true\n"
      " end\nend",
      part);
  scene.level();
  EXPECT_FALSE(scene[part].vanish);
  EXPECT_TRUE(scene[part].solid);
  EXPECT_EQ(scene.unmodelled("part that comes and goes irregularly"), 1u);
}

TEST(Vanish, FadeWithoutLosingCollisionIsADecoy) {
  Scene scene;
  const auto part = scene.part("Decoy");
  scene.script(
      "script.Parent.Touched:Connect(function() for i = 1, 10 do "
      "script.Parent.Transparency = i / 10 wait(0.1) end end)",
      part);
  scene.level();
  EXPECT_FALSE(scene[part].vanish);
}

TEST(Vanish, TowerKitValues) {
  Scene scene;
  const auto model = scene.add("Model", "DisappearingPlatform", scene.workspace);
  const auto platform = scene.part("Platform", {}, model);
  scene.value("NumberValue", "FadeTime", 2.0, model);
  scene.value("NumberValue", "RespawnTime", 1.0, model);
  const auto v6 = scene.part("V6");
  const auto configuration = scene.add("Configuration", "VanisherConfiguration", v6);
  scene.attribute(configuration, "RespawnTime", 2.0);
  scene.level();
  ASSERT_TRUE(scene[platform].vanish && scene[v6].vanish);
  EXPECT_NEAR(scene[platform].vanish->delay, 2, 1e-6);
  EXPECT_NEAR(scene[platform].vanish->away, 1, 1e-6);
  EXPECT_NEAR(scene[v6].vanish->away, 2, 1e-6);
}

TEST(Vanish, NegativeTowerKitValuesUseTheDefaults) {
  Scene scene;
  const auto platform = scene.part("Platform");
  scene.value("NumberValue", "FadeTime", -2.0, platform);
  scene.value("NumberValue", "RespawnTime", -1.0, platform);
  const auto v6 = scene.part("V6");
  const auto configuration = scene.add("Configuration", "VanisherConfiguration", v6);
  scene.attribute(configuration, "BlinkCount", -1.0);
  scene.attribute(configuration, "RespawnTime", -1.0);
  scene.level();
  ASSERT_TRUE(scene[platform].vanish && scene[v6].vanish);
  EXPECT_NEAR(scene[platform].vanish->delay, 2, 1e-6);
  EXPECT_NEAR(scene[platform].vanish->away, 1, 1e-6);
  EXPECT_NEAR(scene[v6].vanish->delay, 0.6, 1e-6);
  EXPECT_NEAR(scene[v6].vanish->away, 2, 1e-6);
}

}  // namespace
}  // namespace obby::test
