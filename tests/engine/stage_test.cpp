// Scripts of small places run, and their effects are recorded.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

TEST(Stage, SpinsAPart) {
  Place place;
  const InstanceId part = place.part("Spinner", {10, 5, 0});
  place.script(
      "while true do script.Parent.CFrame = script.Parent.CFrame * CFrame.Angles(0, 0.1, 0) "
      "task.wait() end",
      part);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(60);
  const engine::Observation& seen = stage.observation();
  EXPECT_EQ(problems(seen), "");
  ASSERT_TRUE(seen.tracks.contains(part));
  EXPECT_GE(seen.tracks.at(part).poses.size(), 59u);
  EXPECT_EQ(seen.tracks.at(part).line.line, 1);
}

TEST(Stage, KillsOnTouch) {
  Place place;
  const InstanceId lava = place.part("Lava", {20, 0, 0});
  place.script(
      "script.Parent.Touched:Connect(function(hit)\n"
      "  local h = hit.Parent:FindFirstChild(\"Humanoid\")\n"
      "  if h then h.Health = 0 end\nend)",
      lava);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(10);
  EXPECT_TRUE(stage.observation().player.alive);
  stage.stand({20, 0.5f, 0}, 0);
  stage.run(5);
  const engine::Observation& seen = stage.observation();
  EXPECT_EQ(problems(seen), "");
  EXPECT_FALSE(seen.player.alive);
  ASSERT_EQ(seen.harms.size(), 1u);
  EXPECT_EQ(seen.harms[0].line.line, 3);
}

TEST(Stage, TweensAndWaits) {
  Place place;
  const InstanceId part = place.part("Lift", {0, 5, 20});
  place.script(
      "local TweenService = game:GetService(\"TweenService\")\n"
      "local tween = TweenService:Create(script.Parent, TweenInfo.new(1, Enum.EasingStyle.Linear), "
      "{Position = "
      "Vector3.new(0, 15, 20)})\n"
      "wait(0.5)\n"
      "tween:Play()\n"
      "tween.Completed:Wait()\n"
      "script.Parent.CanCollide = false",
      part);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(120);
  const engine::Observation& seen = stage.observation();
  EXPECT_EQ(problems(seen), "");
  ASSERT_TRUE(seen.tracks.contains(part));
  EXPECT_FLOAT_EQ(seen.tracks.at(part).poses.back().pose.position.y, 15);
  ASSERT_EQ(seen.tweens.size(), 1u);
  EXPECT_NEAR(seen.tweens[0].time, 0.5, 0.04);
  ASSERT_EQ(seen.changes.size(), 1u);
  EXPECT_EQ(seen.changes[0].property, "CanCollide");
  EXPECT_NEAR(seen.changes[0].time, 1.5, 0.06);
}

TEST(Stage, APartWithoutAShapeIsABlock) {
  Place place;
  const InstanceId plank = place.part("Plank", {0, 0, 40});
  place.set(plank, "Size", Vec3{6, 1, 60});
  place.script(
      "local hit = workspace:Raycast(Vector3.new(2.5, 3, 60), Vector3.new(0, -4, 0))\n"
      "workspace.Plank.CanCollide = hit == nil or hit.Instance.Name ~= 'Plank'",
      place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  const engine::Observation& seen = stage.observation();
  EXPECT_EQ(problems(seen), "");
  ASSERT_EQ(seen.changes.size(), 1u);
  EXPECT_EQ(std::get<bool>(seen.changes[0].value), false);
}

TEST(Stage, ACancelledThreadDoesNotWait) {
  Place place;
  place.script("task.cancel(task.delay(100, function() end))", place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  EXPECT_FALSE(stage.isBusy());
}

}  // namespace
}  // namespace obby::test
