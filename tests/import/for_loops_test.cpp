// `for` loops that count for ever, and loops whose end depends on a model's position.
#include <algorithm>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

const std::string kKill = "p.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)";

TEST(ForLoops, EndlessCountingLoopsAreRecognised) {
  const char* const loops[] = {"for i = 1, math.huge do", "for i = 1, math.huge, 2 do",
                               "for i = 10, -math.huge, -1 do", "for i = 1, 1e9 do"};
  for (const char* loop : loops) {
    ScriptedPart scene(std::string(loop) +
                       " p.CFrame = p.CFrame * CFrame.Angles(0, 0.05, 0) wait() end\n" + kKill);
    ASSERT_TRUE(scene[scene.self].motion) << loop;
    ASSERT_TRUE(scene[scene.self].motion->spin) << loop;
    EXPECT_NEAR(scene[scene.self].motion->spin->speed, 1.5, 2e-3) << loop;
    EXPECT_FALSE(scene[scene.self].kill) << "what stands behind it is never reached";
    EXPECT_TRUE(scene.level().unmodelled.empty()) << loop;
  }
}

TEST(ForLoops, EndlessLoopsUpdateTheirVariable) {
  ScriptedPart scene(
      "for i = 0, math.huge do p.Position = Vector3.new(0, i % 2 * 8, 0) task.wait(1) end");
  ASSERT_TRUE(scene[scene.self].motion);
  for (const double round : {0, 2, 40}) {
    EXPECT_NEAR(poseAt(scene[scene.self], round + 0.5).position.y, 0, 0.1);
    EXPECT_NEAR(poseAt(scene[scene.self], round + 1.5).position.y, 8, 0.1);
  }
}

TEST(ForLoops, EndlessLoopsCanBeTimers) {
  ScriptedPart scene(
      "for i = 1, math.huge do p.CanCollide = false wait(1) p.CanCollide = true wait(2) end");
  ASSERT_TRUE(scene[scene.self].vanish);
  EXPECT_TRUE(scene[scene.self].vanish->timer);
  EXPECT_NEAR(scene[scene.self].vanish->away, 1, 1e-3);
  EXPECT_NEAR(scene[scene.self].vanish->delay, 2, 1e-3);
}

TEST(ForLoops, LongLoopsCountAsEndless) {
  for (const char* loop : {"for i = 1, 1e6 do", "for i = 1, 5000 do", "for i = 1e5, 1, -2 do"}) {
    ScriptedPart scene(std::string(loop) +
                       " p.CanCollide = false wait(1) p.CanCollide = true task.wait(2) end");
    ASSERT_TRUE(scene[scene.self].vanish) << loop;
    EXPECT_TRUE(scene[scene.self].vanish->timer) << loop;
    EXPECT_NEAR(scene[scene.self].vanish->away, 1, 0.02) << loop;
    EXPECT_NEAR(scene[scene.self].vanish->delay, 2, 0.02) << loop;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << loop;
  }
  ScriptedPart turns("for i = 1, 1e6 do p.CFrame *= CFrame.Angles(0, 0.05, 0) task.wait() end");
  ASSERT_TRUE(turns[turns.self].motion);
  EXPECT_TRUE(turns[turns.self].motion->spin);
}

// The engine stops a script that runs too long without a wait.
TEST(ForLoops, LongLoopsWithoutAWaitAreReported) {
  for (const bool many : {false, true}) {
    ScriptedPart scene("for i = 1, " + std::string(many ? "1e9" : "1e4") +
                       " do p.Transparency = 0.5 end\n" + kKill);
    const bool isGuess = scene.evidence(scene.self, "kill").rfind("guessed: ", 0) == 0;
    EXPECT_TRUE(scene[scene.self].kill);
    EXPECT_EQ(isGuess, many) << "by the text alone";
    EXPECT_EQ(scene.unmodelled("script that fails"), many ? 1u : 0u);
  }
}

TEST(ForLoops, LoopsInTheWrongDirectionDoNotRun) {
  ScriptedPart scene("for i = 1, -math.huge do p:Destroy() end");
  EXPECT_EQ(scene.level().parts.size(), 1u);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(ForLoops, EndlessLoopsCanBreak) {
  Scene scene;
  const InstanceId parts[] = {scene.part("Red1", {9, 0, 0}), scene.part("Red2", {18, 0, 0}),
                              scene.part("Red3", {27, 0, 0})};
  const auto last = scene.part("Last", {36, 0, 0});
  scene.script(
      "local function kill(h) h.Parent.Humanoid.Health = 0 end\n"
      "for i = 1, math.huge do local red = workspace:FindFirstChild('Red' .. i)\n"
      "if not red then break end red.Touched:Connect(kill) end\n"
      "workspace.Last.Touched:Connect(kill)",
      scene.scripts);
  scene.level();
  for (const InstanceId part : parts) EXPECT_TRUE(scene[part].kill) << part;
  EXPECT_TRUE(scene[last].kill);
}

// The script reads the model's position from a part, and sets the position by a method.
TEST(ForLoops, AModelsMotionCanEndByItsPosition) {
  const std::string step = "m:PivotTo(m:GetPivot() * CFrame.new(0, 0.1, 0)) task.wait(0.05) ";
  const std::string texts[] = {"while m.PrimaryPart.Position.Y < 3.95 do " + step + "end",
                               "repeat " + step + "until m.PrimaryPart.Position.Y >= 3.95"};
  for (const std::string& text : texts) {
    Scene scene;
    const auto model = scene.add("Model", "Lift", scene.workspace);
    const auto floor = scene.part("Floor", {}, model);
    scene.set(model, "PrimaryPart", Ref{floor});
    scene.script("local m = workspace.Lift\n" + text, scene.scripts);
    scene.level();
    ASSERT_TRUE(scene[floor].motion) << text;
    for (const double time : {0.0, 1.0, 5.0})
      EXPECT_NEAR(poseAt(scene[floor], time).position.y, std::min(0.1 + 2 * time, 4.0), 0.11);
    EXPECT_EQ(scene.evidence(floor, "motion").rfind("script ", 0), 0u) << text;
  }
}

}  // namespace
}  // namespace obby::test
