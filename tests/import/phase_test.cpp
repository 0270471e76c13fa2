// Parts that begin to move after their script has waited. The wait is the phase of the motion.
#include <cmath>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

// Scripts for the part `p`, each with a different endless motion.
const char* const kMotions[] = {
    "ts:Create(p, TweenInfo.new(2, Enum.EasingStyle.Linear, Enum.EasingDirection.InOut, -1, true), "
    "{Position = Vector3.new(0, 9, 0)}):Play()",
    "ts:Create(p, TweenInfo.new(2, Enum.EasingStyle.Sine, Enum.EasingDirection.InOut, -1), "
    "{Position = Vector3.new(0, 9, 0)}):Play()",
    "ts:Create(p, TweenInfo.new(4, Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1), "
    "{Orientation = Vector3.new(0, 360, 0)}):Play()",
    "while true do there:Play() there.Completed:Wait() back:Play() back.Completed:Wait() end",
    "there.Completed:Connect(function() back:Play() end) "
    "back.Completed:Connect(function() there:Play() end) there:Play()",
    "while true do p.CFrame *= CFrame.Angles(0, 0.05, 0) task.wait() end",
    "while true do p.CFrame = CFrame.new(0, 5, 0) task.wait(1) p.CFrame = CFrame.new(0, 0, 0) "
    "task.wait(1) end",
    "game:GetService('RunService').Heartbeat:Connect(function(dt) "
    "p.CFrame = p.CFrame * CFrame.Angles(0, math.rad(90) * dt, 0) end)"};

const std::string kPhaseBefore = R"(local p, ts = script.Parent, game:GetService("TweenService")
local there = ts:Create(p, TweenInfo.new(1), {Position = Vector3.new(0, 9, 0)})
local back = ts:Create(p, TweenInfo.new(1), {Position = Vector3.new(0, 0, 0)})
)";

// The second part follows the first by a second, within two frames.
TEST(Phase, AWaitBeforeARepeatedMotionIsItsPhase) {
  for (const char* motion : kMotions) {
    Scene scene;
    const auto first = scene.part("First"), second = scene.part("Second");
    scene.script(kPhaseBefore + motion, first);
    scene.script(kPhaseBefore + "task.wait(1)\n" + motion, second);
    scene.level();
    for (const double time : {0.3, 0.7, 2.5, 3.4, 30.3}) {
      const Pose a = poseAt(scene[first], time), b = poseAt(scene[second], time + 1);
      expectNear(b.position, a.position, 0.6f);
      expectNear(b.rotation.x, a.rotation.x, 0.11f);
    }
  }
}

TEST(Phase, PlatformsOfOneScriptMoveInTurn) {
  Scene scene;
  const auto wave = scene.add("Folder", "Wave", scene.workspace);
  InstanceId platforms[3] = {};
  for (int i = 0; i < 3; ++i) platforms[i] = scene.part("Platform", {10 * float(i), 0, 0}, wave);
  scene.script(R"(local TweenService = game:GetService("TweenService")
local info = TweenInfo.new(2, Enum.EasingStyle.Linear, Enum.EasingDirection.InOut, -1, true)
for _, p in workspace.Wave:GetChildren() do
  TweenService:Create(p, info, {Position = p.Position + Vector3.new(0, 8, 0)}):Play()
  task.wait(0.5)
end)",
               scene.scripts);
  scene.level();
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(poseAt(scene[platforms[i]], 10).position.y, 8 - 2 * i, 0.15) << i;
}

TEST(Phase, AMotionThatHappensOnceWaitsInItsKeys) {
  Scene scene;
  const auto part = scene.part("Mover");
  scene.script(kPhaseBefore + "task.wait(3) there:Play()", part);
  scene.level();
  for (const auto& [time, y] : {std::pair(2.9, 0.0f), {3.5, 6.75f}, {4.0, 9.0f}, {20.0, 9.0f}})
    EXPECT_NEAR(poseAt(scene[part], time).position.y, y, 0.3) << time;
}

// The simulator accepts a motion whose round trip takes twenty minutes.
TEST(Phase, AMotionCanLastTwentyMinutes) {
  for (const bool longer : {false, true}) {
    Scene scene;
    const auto part = scene.part("Mover");
    const std::string seconds = longer ? "700" : "590";
    scene.script(kPhaseBefore + "ts:Create(p, TweenInfo.new(" + seconds +
                     ", Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1, true), "
                     "{Position = Vector3.new(0, 59, 0)}):Play()",
                 part);
    scene.level();
    ASSERT_EQ(scene[part].motion.has_value(), !longer) << "there and back";
    EXPECT_EQ(scene.unmodelled("motion out of range"), longer ? 1u : 0u);
    if (longer) continue;
    for (const auto& [time, y] : {std::pair(100, 10), {590, 59}, {1080, 10}, {1190, 1}})
      EXPECT_NEAR(poseAt(scene[part], time).position.y, float(y), 0.1) << time;
  }
}

}  // namespace
}  // namespace obby::test
