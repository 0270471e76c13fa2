// Parts that a script moves only once, step by step.
#include <algorithm>
#include <chrono>
#include <string>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

// Each step moves the part 0.1 studs; the steps are 0.05 s apart.
TEST(PoseSteps, StepsInALoopAreAOneTimeMotion) {
  const char* const texts[] = {
      "for i = 1, 40 do p.CFrame = p.CFrame * CFrame.new(0, 0.1, 0) task.wait(0.05) end",
      "for i = 1, 40 do p.CFrame += Vector3.new(0, 0.1, 0) task.wait(0.05) end",
      "for i = 40, 1, -1 do p.Position = p.Position + Vector3.new(0, 0.1, 0) task.wait(0.05) end",
      "for i = 1, 40 do p:PivotTo(CFrame.new(0, i / 10, 0)) task.wait(0.05) end",
      "for i = 1, math.huge do p.CFrame *= CFrame.new(0, 0.1, 0)\n"
      "if i == 40 then break end task.wait(0.05) end",
      "local n = 0 while n < 40 do n += 1 p.Position += Vector3.new(0, 0.1, 0) task.wait(0.05) end",
      "while p.Position.Y < 3.95 do p.CFrame *= CFrame.new(0, 0.1, 0) task.wait(0.05) end",
      "task.spawn(function() for i = 1, 40 do p.CFrame *= CFrame.new(0, 0.1, 0) "
      "task.wait(0.05) end end)"};
  for (const char* text : texts) {
    ScriptedPart scene(text);
    const PartDraft& part = scene[scene.self];
    ASSERT_TRUE(part.motion) << text;
    EXPECT_EQ(part.motion->repeat, importer::Repeat::once) << text;
    EXPECT_LE(part.motion->keys.size(), 4u) << text;
    for (const double time : {0.0, 0.5, 1.0, 1.95, 5.0})
      expectNear(poseAt(part, time).position, {0, float(std::min(0.1 + 2 * time, 4.0)), 0}, 0.11f);
    EXPECT_EQ(scene.evidence(scene.self, "motion").rfind("script Script line 2", 0), 0u) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(PoseSteps, BeginAtTheScriptedPositionAfterTheWait) {
  const std::string steps = "for i = 1, 10 do p.Position = Vector3.new(i, 0, 5) task.wait(0.1) end";
  for (const bool thread : {false, true}) {
    ScriptedPart scene(
        "p.Position = Vector3.new(0, 0, 5) " +
        (thread ? "task.delay(2, function() " + steps + " end)" : "task.wait(2) " + steps));
    const PartDraft& part = scene[scene.self];
    ASSERT_TRUE(part.motion) << thread;
    expectNear(part.pose.position, {0, 0, 5});
    expectNear(poseAt(part, 1.9).position, {0, 0, 5});
    expectNear(poseAt(part, 2.45).position, {5, 0, 5}, 0.6f);
    expectNear(poseAt(part, 3).position, {10, 0, 5});
  }
}

TEST(PoseSteps, AnotherThreadCanMoveThePartLater) {
  ScriptedPart scene(
      "task.delay(30, function() p.Position = Vector3.new(0, 0, 0) end)\n"
      "for i = 1, 10 do p.Position = Vector3.new(i, 0, 0) task.wait(0.1) end");
  const PartDraft& part = scene[scene.self];
  expectNear(poseAt(part, 0.45).position, {5, 0, 0}, 0.6f);
  expectNear(poseAt(part, 29).position, {10, 0, 0});
  expectNear(poseAt(part, 31).position, {});
}

TEST(PoseSteps, CanTurnAPart) {
  ScriptedPart scene(
      "for i = 1, 90 do p.CFrame = p.CFrame * CFrame.Angles(0, math.rad(1), 0) task.wait() end");
  const PartDraft& part = scene[scene.self];
  ASSERT_TRUE(part.motion);
  EXPECT_FALSE(part.motion->spin);
  EXPECT_NEAR(yawAt(part, 0.75), 45, 1.1);
  EXPECT_NEAR(yawAt(part, 9), 90, 0.1);
  expectNear(poseAt(part, 9).position, {});
}

TEST(PoseSteps, AnEndlessPairOfLoopsMovesBackAndForth) {
  const char* const steps[] = {"p.Position = p.Position + Vector3.new(0, 0.2, 0) * way",
                               "p.CFrame = p.CFrame + Vector3.new(0, 0.2, 0) * way"};
  for (const char* step : steps) {
    const std::string loop = "for i = 1, 20 do " + std::string(step) + " task.wait(0.05) end ";
    ScriptedPart scene("local way = 1 while true do\n" + loop + "way = -1\n" + loop +
                       "way = 1\nend");
    const PartDraft& part = scene[scene.self];
    ASSERT_TRUE(part.motion) << step;
    EXPECT_NEAR(part.motion->keys.back().time, 2, 0.05) << step;
    for (const double round : {0, 40}) {
      EXPECT_NEAR(poseAt(part, round + 0.5).position.y, 2.2, 0.21) << step;
      EXPECT_NEAR(poseAt(part, round + 0.96).position.y, 4, 0.21) << step;
      EXPECT_NEAR(poseAt(part, round + 1.5).position.y, 1.8, 0.21) << step;
    }
  }
}

// Motions after a wait that never ends do not occur. A door that a script opens and shuts at the
// start stays where it was left.
TEST(PoseSteps, MotionsAfterAnEndlessWaitDoNotOccur) {
  const std::string steps =
      "for i = 1, 40 do p.CFrame = p.CFrame * CFrame.new(0, 0.1, 0) task.wait(0.05) end";
  const std::string texts[] = {
      "repeat task.wait() until workspace:GetAttribute('Open') " + steps,
      "task.wait(1300) " + steps,
      "local d = Instance.new('ClickDetector', p) d.MouseHoverEnter:Wait() " + steps,
      "task.wait(1) p.Position = Vector3.new(0, 9, 0) task.wait(1) p.Position = Vector3.new()"};
  for (const std::string& text : texts) {
    ScriptedPart scene(text);
    EXPECT_FALSE(scene[scene.self].motion) << text;
    expectNear(scene[scene.self].pose.position, {});
    EXPECT_EQ(scene.unmodelled("motion without a period"), 0u) << text;
  }
}

TEST(PoseSteps, ALongMotionRunsToItsEnd) {
  ScriptedPart scene(
      "for i = 1, 3000 do p.CFrame = p.CFrame * CFrame.new(0, 0.1, 0) task.wait() end");
  const PartDraft& part = scene[scene.self];
  EXPECT_NEAR(poseAt(part, 25).position.y, 150, 0.5);
  EXPECT_NEAR(poseAt(part, 100).position.y, 300, 0.5);
  EXPECT_LE(part.motion->keys.size(), 4u);
}

// The recorded run ends before it shows whether the last step ends the motion.
TEST(PoseSteps, EndlessTranslationsAreReported) {
  ScriptedPart scene(
      "while true do p.Position += Vector3.new(0, 0.1, 0) task.wait(math.random()) end");
  EXPECT_FALSE(scene[scene.self].motion);
  EXPECT_EQ(scene.unmodelled("motion without a period"), 1u);
}

// Two scripts move one part. The part rises once, and also moves or turns for ever.
TEST(PoseSteps, CombineWithAnEndlessMotionOfThePart) {
  const std::string rises = "for i = 1, 40 do p.Position += Vector3.new(0, 1, 0) task.wait() end";
  const std::string before = "local p = workspace.Mover\n";
  const char* const loops[] = {
      "while true do p.Position = Vector3.new(9, 0, 0) task.wait(1) p.Position = Vector3.new() "
      "task.wait(1) end",
      "while true do p.CFrame *= CFrame.Angles(0, 0.1, 0) task.wait() end"};
  for (const bool turns : {false, true}) {
    Scene scene;
    const auto part = scene.part("Mover");
    scene.script(before + rises, scene.scripts);
    scene.script(before + loops[turns ? 1 : 0], scene.scripts);
    scene.level();
    ASSERT_TRUE(scene[part].motion);
    EXPECT_EQ(scene[part].motion->spin.has_value(), turns);
    EXPECT_NEAR(poseAt(scene[part], 20.5).position.x, turns ? 0 : 9, 0.1);
    EXPECT_NEAR(poseAt(scene[part], 20.5).position.y, turns ? 40 : 0, 0.1);
    EXPECT_NEAR(poseAt(scene[part], 0.3).position.y, turns ? 19 : 0, 1.1);
  }
}

TEST(PoseSteps, AFadeIsNeitherAMotionNorAVanishing) {
  ScriptedPart fades("for i = 0, 1, 0.1 do p.Transparency = i task.wait(0.1) end");
  EXPECT_FALSE(fades[fades.self].motion);
  EXPECT_FALSE(fades[fades.self].vanish);
  EXPECT_TRUE(fades[fades.self].solid);
  EXPECT_TRUE(fades.level().unmodelled.empty());
  ScriptedPart goes(
      "while true do for i = 0, 1, 0.1 do p.Transparency = i task.wait(0.1) end\n"
      "p.CanCollide = false task.wait(2) p.CanCollide = true p.Transparency = 0 task.wait(1) end");
  ASSERT_TRUE(goes[goes.self].vanish);
  EXPECT_NEAR(goes[goes.self].vanish->away, 2, 0.01);
  EXPECT_NEAR(goes[goes.self].vanish->delay, 2.1, 0.05);
}

TEST(PoseSteps, HostileNumbersEndSoon) {
  const char* const texts[] = {
      "for i = 1, 1e18 do p.Position += Vector3.new(0, 1, 0) wait(-5) end",
      "for i = 1, 1e305 do wait(1e6) end p.Touched:Connect(function(h) for i = 1, 1e305 do "
      "wait(1e6) end h.Parent.Humanoid.Health = 0 wait(1) end)",
      "for i = 1, 10, math.sqrt(-1) do p.Position += Vector3.new(0, i, 0) wait() end",
      "for i = 1, 10, 0 do p.Position += Vector3.new(0, i, 0) wait() end",
      "for i = 1, 10, math.huge do p.Position += Vector3.new(0, i, 0) wait() end",
      "for i = 1, 1000 do p.Position = p.Position * 1e30 wait(math.sqrt(-1)) end",
      "for i = 1, 1000 do p.CFrame = CFrame.new(i, 0, 0, 1e38, 0, 0, 0, 1e38, 0, 0, 0, 1e38) * "
      "p.CFrame wait() end",
      "p.Touched:Connect(function() task.delay(-9, function() p.CanCollide = false end) end)",
      "p.Touched:Connect(function() task.delay(math.huge, function() p.CanCollide = false end) "
      "end)"};
  for (const char* text : texts) {
    const auto start = std::chrono::steady_clock::now();
    ScriptedPart scene(text);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << text;
    const PartDraft& part = scene[scene.self];
    EXPECT_TRUE(!part.kill || part.kill->cooldown >= 0) << text;
    EXPECT_TRUE(!part.vanish || part.vanish->delay >= 0) << text;
  }
}

}  // namespace
}  // namespace obby::test
