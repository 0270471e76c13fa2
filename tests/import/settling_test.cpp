// Motions that come to rest between their ends, and motions that a touch starts.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const std::string kSpring =
    "local v, goal = Vector3.zero, p.Position\n"
    "game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
    "local x = p.Position - goal v += (-x * 6.3 - v * 5) * dt p.Position += v * dt end)\n"
    "while true do goal = Vector3.new(0, 0, 24) task.wait(5) goal = Vector3.zero task.wait(5) end";

std::string lerpEach(int seconds) {
  const std::string wait = "task.wait(" + std::to_string(seconds) + ") ";
  return "local goal = p.Position\n"
         "game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
         "p.Position = p.Position:Lerp(goal, 1 - math.exp(-3 * dt)) end)\n"
         "while true do goal = Vector3.new(0, 0, 24) " +
         wait + "goal = Vector3.zero " + wait + "end";
}

// Expects a motion from one end to the other and back within `seconds`.
void expectThereAndBack(const ScriptedPart& scene, double seconds, const std::string& what) {
  const PartDraft& pad = scene[scene.self];
  ASSERT_TRUE(pad.motion) << what;
  EXPECT_NEAR(pad.motion->keys.back().time, seconds, 0.1) << what;
  EXPECT_NEAR(poseAt(pad, seconds / 2 - 0.1).position.z, 24, 1) << what;
  EXPECT_NEAR(poseAt(pad, seconds - 0.1).position.z, 0, 1) << what;
}

TEST(Settling, SpringsAndLerpsReachTheirTargets) {
  expectThereAndBack(ScriptedPart(kSpring), 10, "spring");
  for (const int seconds : {5, 8, 14})
    expectThereAndBack(ScriptedPart(lerpEach(seconds)), 2 * seconds, std::to_string(seconds));
}

const std::string kTween =
    "local home = p.Position local function to(z) local t = game:GetService('TweenService')\n"
    ":Create(p, TweenInfo.new(6, Enum.EasingStyle.Linear), {Position = home + Vector3.new(0, 0, "
    "z)})"
    "\nt:Play() t.Completed:Wait() end\n";

TEST(Settling, ATouchStartsTweensLongerThanTheProbe) {
  const ScriptedPart scene(
      kTween +
      "local busy = false p.Touched:Connect(function() if busy then return end\n"
      "busy = true to(24) task.wait(3) to(0) busy = false end)");
  const PartDraft& pad = scene[scene.self];
  ASSERT_TRUE(pad.motion);
  EXPECT_EQ(pad.motion->trigger, importer::MotionTrigger::touch);
  EXPECT_NEAR(pad.motion->keys.back().time, 15, 0.1);
  expectNear(at(pad, 7), {0, 0, 24}, 0.2f);
  expectNear(at(pad, 12), {0, 0, 12}, 0.4f);
  expectNear(at(pad, 15), {0, 0, 0}, 0.2f);
}

TEST(Settling, AButtonStartsAnEndlessTween) {
  Scene scene;
  const auto raft = scene.part("Raft"), button = scene.part("Button", {9, 0, 0});
  scene.script(
      "local started script.Parent.Touched:Connect(function() if started then return end\n"
      "started = true game:GetService('TweenService'):Create(workspace.Raft,\n"
      "TweenInfo.new(6, Enum.EasingStyle.Linear, Enum.EasingDirection.Out, -1, true),\n"
      "{Position = Vector3.new(0, 0, 24)}):Play() end)",
      button);
  scene.level();
  ASSERT_TRUE(scene[raft].motion && scene[button].button);
  EXPECT_EQ(scene[raft].motion->trigger, importer::MotionTrigger::signal);
  EXPECT_EQ(scene[raft].motion->repeat, importer::Repeat::loop);
  EXPECT_TRUE(scene[button].button->forever);
  EXPECT_NEAR(scene[raft].motion->keys.back().time, 12, 0.1);
  expectNear(at(scene[raft], 6), {0, 0, 24}, 0.2f);
}

}  // namespace
}  // namespace obby::test
