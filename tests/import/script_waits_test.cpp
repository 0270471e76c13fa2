// Loops that wait for the end of a tween or a motion, and the tween data that scripts read.
#include <utility>

#include "import/tween_scene.h"

namespace obby::test {
namespace {

const std::string kThereAndBack =
    "local there, back = tween(even(2), to(10)), tween(even(1), to(0))\n";

TEST(ScriptWaits, ALoopCanCheckWhetherATweenIsOver) {
  const char* const texts[] = {
      ("while true do there:Play()\n"
       "repeat task.wait() until there.PlaybackState == Enum.PlaybackState.Completed\n"
       "back:Play()\n"
       "repeat task.wait() until back.PlaybackState == Enum.PlaybackState.Completed end"),
      ("while true do there:Play()\n"
       "while there.PlaybackState == Enum.PlaybackState.Playing do print(p.Name) task.wait() end\n"
       "back:Play()\n"
       "while back.PlaybackState ~= Enum.PlaybackState.Completed do task.wait() end end"),
      ("while true do there:Play() task.wait(there.TweenInfo.Time)\n"
       "back:Play() task.wait(back.TweenInfo.Time) end")};
  for (const char* text : texts) {
    const Overlap tweened({kThereAndBack + text});
    ASSERT_FALSE(tweened.motion().keys.empty()) << text;
    EXPECT_NEAR(tweened.motion().keys.back().time, 3, 0.06) << text;
    EXPECT_NEAR(tweened.z(1), 5, 0.2) << text;
    EXPECT_NEAR(tweened.z(2.5), 5, 0.6) << text;
    EXPECT_TRUE(tweened.scene.unmodelled("motion without a period") == 0) << text;
  }
}

TEST(ScriptWaits, TheEndStateOfATweenIsKnown) {
  const char* const texts[] = {
      "there.Completed:Connect(function(state)\n"
      "if state == Enum.PlaybackState.Completed then back:Play() end end) there:Play()",
      "there:Play() local state = there.Completed:Wait()\n"
      "if state == Enum.PlaybackState.Completed then back:Play() end",
      "there:Play() there.Completed:Wait()\n"
      "if there.PlaybackState ~= Enum.PlaybackState.Cancelled then back:Play() end",
      "local over = there.Completed there:Play() over:Wait() back:Play()",
      "local over = {there.Completed} over[1]:Connect(function() back:Play() end) there:Play()"};
  for (const char* text : texts) {
    const Overlap tweened({kThereAndBack + text});
    for (const auto& [time, z] : {std::pair(1.0, 5), {2.0, 10}, {2.5, 5}, {3.0, 0}, {9.0, 0}})
      EXPECT_NEAR(tweened.z(time), float(z), 0.4) << text << " at " << time;
    EXPECT_EQ(tweened.scene.evidence(tweened.part, "motion").rfind("script ", 0), 0u) << text;
  }
  const Overlap cut({kThereAndBack +
                     "there.Completed:Connect(function(state)\n"
                     "if state == Enum.PlaybackState.Completed then tween(even(1), to(-9)):Play()\n"
                     "end end) there:Play() task.wait(1) back:Play()"});
  EXPECT_NEAR(cut.z(9), 0, 0.1) << "another tween has cut it";
}

TEST(ScriptWaits, TweenInfoDurationsAreKnown) {
  const Overlap tweened(
      {"local info = TweenInfo.new(2, line, way, 1, true, 0.5)\n"
       "tween(even(1), to(4)):Play() task.wait(info.Time + info.DelayTime)\n"
       "if info.Reverses and info.RepeatCount == 1 then tween(even(1), to(8)):Play() end"});
  EXPECT_NEAR(tweened.z(2.4), 4, 0.1);
  EXPECT_NEAR(tweened.z(3), 6, 0.15);
  EXPECT_NEAR(tweened.z(3.5), 8, 0.1);
}

// The condition reads a component of the pose, which the loop sets by other means.
TEST(ScriptWaits, AMotionCanEndAtAPosition) {
  const char* const texts[] = {
      "while true do\n"
      "while p.Position.Z < 10 do p.CFrame = p.CFrame + Vector3.new(0, 0, 0.5) task.wait() end\n"
      "while p.Position.Z > 0 do p.CFrame = p.CFrame - Vector3.new(0, 0, 0.5) task.wait() end end",
      "while true do\n"
      "repeat p.CFrame = p.CFrame + Vector3.new(0, 0, 0.5) task.wait() until p.Position.Z >= 10\n"
      "repeat p.CFrame = p.CFrame - Vector3.new(0, 0, 0.5) task.wait() until p.Position.Z <= 0 end",
      "while true do\n"
      "while true do p.CFrame = p.CFrame + Vector3.new(0, 0, 0.5) task.wait()\n"
      " if p.Position.Z >= 10 then break end end\n"
      "while true do p.CFrame = p.CFrame - Vector3.new(0, 0, 0.5) task.wait()\n"
      " if p.Position.Z <= 0 then break end end end"};
  for (const char* text : texts) {
    const Overlap stepped({text});
    ASSERT_FALSE(stepped.motion().keys.empty()) << text;
    EXPECT_NEAR(stepped.motion().keys.back().time, 40 / 60.0, 0.05) << text;
    EXPECT_NEAR(stepped.z(1 / 3.0), 10, 0.6) << text;
    EXPECT_EQ(stepped.scene.evidence(stepped.part, "motion").rfind("script ", 0), 0u) << text;
  }
}

TEST(ScriptWaits, AnInnerLoopCanEndAtRandom) {
  const Overlap stepped(
      {"while true do while true do p.CFrame = p.CFrame * CFrame.Angles(0, 0.1, 0) task.wait()\n"
       "if math.random() > 0.5 then break end end end"});
  EXPECT_TRUE(stepped.motion().spin);
}

// A function that a loop calls may end the loop.
TEST(ScriptWaits, AFunctionCallCanEndAnInnerLoop) {
  const Overlap stepped(
      {"local open = true\n"
       "local function look() if p.Position.Z >= 2 then open = false end end\n"
       "while true do open = true\n"
       "while open do p.CFrame = p.CFrame + Vector3.new(0, 0, 0.5) task.wait() look()\n"
       " if p.Position.Z > 50 then break end end\n"
       "p.CFrame = CFrame.new(0, 0, 0) task.wait(1) end"});
  for (const auto& key : stepped.motion().keys) EXPECT_LE(key.pose.position.z, 2);
}

// A script moves another part after it has waited for the end of a tween.
TEST(ScriptWaits, EffectsThatAwaitATweenFollowItsEnd) {
  Scene scene;
  scene.part("Mover");
  const auto lift = scene.part("Lift", {20, 0, 0});
  scene.script(kBefore + kThereAndBack +
                   "there:Play() while there.PlaybackState == Enum.PlaybackState.Playing do\n"
                   "task.wait() end\n"
                   "local l = workspace.Lift for i = 1, 9 do l.Position += Vector3.new(0, 1, 0) "
                   "task.wait(0.1) end",
               scene.scripts);
  scene.level();
  for (const auto& [time, y] : {std::pair(1.9, 0.0f), {2.45, 5.0f}, {3.0, 9.0f}})
    EXPECT_NEAR(poseAt(scene[lift], time).position.y, y, 0.7) << time;
}

}  // namespace
}  // namespace obby::test
