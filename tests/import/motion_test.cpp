// Moving and spinning parts: tweens, loops, kits, constraints.
#include <utility>

#include "import/constraint_scene.h"
#include "import/motion_checks.h"

namespace obby::test {
namespace {

constexpr float kPi = 3.14159265f;

// Visible marker parts at the destinations are parts like any others.
TEST(Motion, TweenBetweenMarkerPartsInALoop) {
  Scene scene;
  const auto model = scene.add("Model", "Lift", scene.workspace);
  const auto platform = scene.part("Platform", {0, 5, 0}, model);
  scene.part("Part1", {0, 5, 0}, model);
  const auto two = scene.part("Part2", {0, 5, 30}, model);
  scene.script(R"(local TweenService = game:GetService("TweenService")
local platform = script.Parent.Platform
local info = TweenInfo.new(3, Enum.EasingStyle.Sine, Enum.EasingDirection.InOut)
local there = TweenService:Create(platform, info, {CFrame = script.Parent.Part2.CFrame})
local back = TweenService:Create(platform, info, {CFrame = script.Parent.Part1.CFrame})
while true do
  there:Play()
  there.Completed:Wait()
  task.wait(1)
  back:Play()
  back.Completed:Wait()
  task.wait(1)
end)",
               model);
  scene.level();
  ASSERT_TRUE(scene[platform].motion);
  EXPECT_FALSE(scene[platform].motion->carries);
  for (const auto& [time, z] : {std::pair(0.75, 4.39f), {1.5, 15.0f}, {3.5, 30.0f}, {5.5, 15.0f}})
    expectNear(poseAt(scene[platform], time).position, {0, 5, z}, 1);
  EXPECT_TRUE(scene[two].solid);
}

TEST(Motion, AnEndlessReversingTweenMovesBackAndForth) {
  Scene scene;
  const auto part = scene.part("Mover");
  scene.script(
      "local t = game:GetService('TweenService'):Create(script.Parent, "
      "TweenInfo.new(2, Enum.EasingStyle.Linear, Enum.EasingDirection.Out, -1, true), "
      "{Position = script.Parent.Position + Vector3.new(10, 0, 0)})\nt:Play()",
      part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  EXPECT_LE(scene[part].motion->keys.size(), 4u);
  for (const double round : {0, 40, 400})
    for (const auto& [time, x] : {std::pair(0, 0), {1, 5}, {2, 10}, {3, 5}})
      expectNear(poseAt(scene[part], round + time).position, {float(x), 0, 0}, 0.05f);
}

TEST(Motion, TweensThatStartEachOtherAreALoop) {
  Scene scene;
  const auto part = scene.part("Mover");
  scene.script(R"(local ts = game:GetService("TweenService")
local a = ts:Create(script.Parent, TweenInfo.new(2), {Position = Vector3.new(0, 8, 0)})
local b = ts:Create(script.Parent, TweenInfo.new(4), {Position = Vector3.new(0, 0, 0)})
a.Completed:Connect(function() b:Play() end)
b.Completed:Connect(function() a:Play() end)
a:Play())",
               part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  EXPECT_NEAR(scene[part].motion->keys.back().time, 6, 0.05);
  for (const auto& [time, y] : {std::pair(1, 6), {2, 8}, {4, 2}, {6, 0}})
    EXPECT_NEAR(poseAt(scene[part], time).position.y, float(y), 0.2) << time;
}

TEST(Motion, StepsBackAndForthKeepTheirPauses) {
  Scene scene;
  const auto part = scene.part("Slider");
  scene.script(R"(while true do
  for i = 1, 20 do
    script.Parent.CFrame = script.Parent.CFrame * CFrame.new(1, 0, 0)
    wait()
  end
  wait(2)
  for i = 1, 20 do
    script.Parent.CFrame = script.Parent.CFrame * CFrame.new(-1, 0, 0)
    wait()
  end
  wait(2)
end)",
               part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  const auto& keys = scene[part].motion->keys;
  EXPECT_NEAR(keys.back().time, 2 * (20 / 30.0 + 2), 0.05);
  EXPECT_LE(keys.size(), 12u);
  for (const auto& [time, x] : {std::pair(0.3, 10), {1.5, 20}, {3.0, 10}, {4.0, 0}, {5.64, 10}})
    expectNear(poseAt(scene[part], time).position, {float(x), 0, 0}, 1.1f);
  EXPECT_FALSE(scene[part].motion->carries);
}

TEST(Motion, SineOfTheClock) {
  Scene scene;
  const auto part = scene.part("Swing", {0, 10, 0});
  scene.script(R"(local base = script.Parent.CFrame
game:GetService("RunService").Heartbeat:Connect(function()
  script.Parent.CFrame = base * CFrame.new(0, 0, math.sin(os.clock() * math.pi) * 12)
end))",
               part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  expectNear(poseAt(scene[part], 0.5).position, {0, 10, 12}, 0.3f);
  expectNear(poseAt(scene[part], 1.5).position, {0, 10, -12}, 0.3f);
}

struct SpinCase {
  const char* code;
  float speed;  // rad/s
  Vec3 axis;
};

TEST(Motion, SpinRatesFollowTheWaits) {
  const SpinCase cases[] = {
      {"while true do p.CFrame = p.CFrame * CFrame.Angles(0, math.pi / 90, 0) wait() end",
       kPi / 90 * 30,
       {0, 1, 0}},
      {"while task.wait() do p.CFrame *= CFrame.Angles(0, 0.05, 0) end", 3, {0, 1, 0}},
      {"while true do task.wait(0.01) p.CFrame = p.CFrame * CFrame.Angles(0, math.rad(1), 0) end",
       kPi / 180 * 60,
       {0, 1, 0}},
      {"while true do p.Orientation = p.Orientation + Vector3.new(0, 0, 2) wait(0.04) end",
       kPi / 90 * 15,  // wait(0.04) takes two frames of 1/30 s
       {0, 0, 1}},
      {"game:GetService('RunService').Heartbeat:Connect(function(dt) "
       "p.CFrame = p.CFrame * CFrame.Angles(0, math.rad(90) * dt, 0) end)",
       kPi / 2,
       {0, 1, 0}},
      {"game:GetService('RunService').Stepped:Connect(function(t, dt) "
       "p.CFrame = p.CFrame * CFrame.fromEulerAnglesXYZ(-math.rad(120) * dt, 0, 0) end)",
       kPi * 2 / 3,
       {-1, 0, 0}}};
  for (const auto& spin : cases) {
    Scene scene;
    const auto part = scene.part("Spinner", {3, 4, 5});
    scene.script("local p = script.Parent\n" + std::string(spin.code), part);
    scene.level();
    ASSERT_TRUE(scene[part].motion && scene[part].motion->spin) << spin.code;
    EXPECT_NEAR(scene[part].motion->spin->speed, spin.speed, 0.002f * spin.speed) << spin.code;
    expectNear(scene[part].motion->spin->axis, spin.axis);
    expectNear(scene[part].motion->spin->pivot, {});
  }
}

TEST(Motion, AKillPartCanSpin) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script("script.Parent.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)", part);
  scene.script("while true do script.Parent.CFrame *= CFrame.Angles(0, 0.1, 0) wait(0) end", part);
  scene.level();
  EXPECT_TRUE(scene[part].kill);
  ASSERT_TRUE(scene[part].motion);
  EXPECT_TRUE(scene[part].motion->spin);
}

TEST(Motion, WeldedPlatformsFollowTheirHub) {
  Scene scene;
  const auto [hub, arm] = joined(scene, "WeldConstraint");
  scene.script("while true do script.Parent.CFrame *= CFrame.Angles(0, 0.1, 0) task.wait() end",
               hub);
  scene.level();
  ASSERT_TRUE(scene[arm].motion && scene[arm].motion->spin);
  expectNear(scene[arm].motion->spin->pivot, {-10, 0, 0});
  EXPECT_NEAR(scene[arm].motion->spin->speed, 6, 0.1);
}

TEST(Motion, ModelsTurnAboutTheirPivot) {
  const char* const turns[] = {
      "m:PivotTo(m:GetPivot() * CFrame.Angles(0, 0, math.rad(3)))",
      "m:SetPrimaryPartCFrame(m.PrimaryPart.CFrame * CFrame.Angles(0, 0, math.rad(3)))",
      "m:PivotTo(m.Centre.CFrame * CFrame.Angles(0, 0, math.rad(3)))",
      "m:SetPrimaryPartCFrame(m:GetPrimaryPartCFrame() * CFrame.Angles(0, 0, math.rad(3)))"};
  for (const char* turn : turns) {
    Scene scene;
    const auto model = scene.add("Model", "Windmill", scene.workspace);
    const auto centre = scene.part("Centre", {0, 5, 0}, model),
               blade = scene.part("Blade", {6, 5, 0}, model);
    scene.set(model, "PrimaryPart", Ref{centre});
    scene.script("local m = script.Parent while task.wait() do " + std::string(turn) + " end",
                 model);
    scene.level();
    ASSERT_TRUE(scene[blade].motion && scene[blade].motion->spin) << turn;
    expectNear(scene[blade].motion->spin->pivot, {-6, 0, 0});
    expectNear(scene[blade].motion->spin->axis, {0, 0, 1});
  }
}

TEST(Motion, PartsOfAMovingModelReportTheirCurrentPositions) {
  Scene scene;
  const auto model = scene.add("Model", "Train", scene.workspace);
  const auto engine = scene.part("Engine", {0, 5, 0}, model);
  scene.part("Wagon", {0, 5, 6}, model);
  scene.part("Flag", {0, 9, 6}, scene.add("Model", "Roof", model));
  scene.set(model, "PrimaryPart", Ref{engine});
  const auto mark = scene.part("Mark", {90, 0, 0});
  scene.script(R"(local m = workspace.Train
m.Wagon.Position = m.Wagon.Position + Vector3.new(0, 0, 2)
m:PivotTo(CFrame.new(10, 5, 0))
m.Roof:TranslateBy(Vector3.new(0, 1, 0))
m.Engine.Position = m.Engine.Position + Vector3.new(3, 0, 0)
local at = Vector3.new(m:GetPivot().Position.X, m.Roof.Flag.Position.Y, m.Wagon.Position.Z)
game:GetService("TweenService"):Create(workspace.Mark, TweenInfo.new(1), {Position = at}):Play())",
               scene.scripts);
  scene.level();
  expectNear(poseAt(scene[mark], 0.5).position, {90 - 0.75f * 77, 7.5f, 6}, 0.1f);
  expectNear(poseAt(scene[mark], 1).position, {13, 10, 8});
}

TEST(Motion, PartsTurnAboutTheirEditedPivot) {
  Scene scene;
  const auto part = scene.part("Door", {20, 5, 3}), other = scene.part("Door", {40, 5, 3});
  for (const auto id : {part, other}) scene.set(id, "PivotOffset", CFrame{{0, 0, -10}, {}});
  scene.script(
      "while task.wait() do local p = script.Parent "
      "p:PivotTo(p:GetPivot() * CFrame.Angles(0, 0.05, 0)) end",
      part);
  scene.script("while task.wait() do script.Parent.CFrame *= CFrame.Angles(0, 0.05, 0) end", other);
  scene.level();
  ASSERT_TRUE(scene[part].motion && scene[part].motion->spin);
  expectNear(scene[part].motion->spin->pivot, {0, 0, -10});
  expectNear(scene[part].motion->spin->axis, {0, 1, 0});
  EXPECT_NEAR(scene[part].motion->spin->speed, 3, 0.05);
  ASSERT_TRUE(scene[other].motion && scene[other].motion->spin);
  expectNear(scene[other].motion->spin->pivot, {});
}

TEST(Motion, ModelsTurnAboutTheEditedPivotOfTheirPrimaryPart) {
  Scene scene;
  const auto model = scene.add("Model", "Gate", scene.workspace);
  const auto post = scene.part("Post", {0, 5, 0}, model),
             leaf = scene.part("Leaf", {6, 5, 0}, model);
  scene.set(model, "PrimaryPart", Ref{post});
  scene.set(post, "PivotOffset", CFrame{{-2, 0, 0}, {}});
  scene.script(
      "while task.wait() do local m = script.Parent "
      "m:PivotTo(m:GetPivot() * CFrame.Angles(0, 0.05, 0)) end",
      model);
  scene.level();
  ASSERT_TRUE(scene[leaf].motion && scene[leaf].motion->spin);
  expectNear(scene[leaf].motion->spin->pivot, {-8, 0, 0});
}

TEST(Motion, ATouchCanStartATween) {
  Scene scene;
  const auto part = scene.part("Elevator", {20, 0, 0});
  scene.script(
      "script.Parent.Touched:Connect(function()\n"
      " game.TweenService:Create(script.Parent, TweenInfo.new(2), "
      "{Position = Vector3.new(20, 50, 0)}):Play()\nend)",
      part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  EXPECT_EQ(scene[part].motion->trigger, importer::MotionTrigger::touch);
  EXPECT_EQ(scene[part].motion->repeat, importer::Repeat::once);
  EXPECT_NEAR(poseAt(scene[part], 1).position.y, 37.5, 1.5);
  EXPECT_NEAR(poseAt(scene[part], 2).position.y, 50, 1);
}

}  // namespace
}  // namespace obby::test
