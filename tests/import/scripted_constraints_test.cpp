// Constraints that scripts set, and constraints of parts that scripts place or move.
#include <gmock/gmock.h>

#include <cmath>
#include <utility>

#include "import/constraint_scene.h"
#include "import/motion_checks.h"

namespace obby::test {
namespace {

// Returns a hinge whose motor turns the arm at 3 rad/s.
Constraint turned(Scene& scene) {
  const auto c = constrained(scene, "HingeConstraint");
  scene.set(c.id, "ActuatorType", EnumItem{1, {}});
  scene.set(c.id, "AngularVelocity", 3.0);
  scene.set(c.id, "MotorMaxTorque", 1e6);
  return c;
}

const std::string kHinge = "local hinge = workspace.Base.HingeConstraint\n";
const std::string kSlider = "local slider = workspace.Base.PrismaticConstraint\n";

TEST(ScriptedConstraint, ScriptedSettingsCountLikeTheFiles) {
  const char* const texts[] = {
      "hinge.ActuatorType = Enum.ActuatorType.Motor hinge.AngularVelocity = 3 "
      "hinge.MotorMaxTorque = 1000",
      "task.wait(2) hinge.ActuatorType = 'Motor' hinge.MotorMaxTorque = math.huge "
      "hinge.AngularVelocity = 3",
      "hinge.ActuatorType = 'Motor' hinge.MotorMaxTorque = 1000\n"
      "while true do hinge.AngularVelocity = 3 task.wait(1) end"};
  for (const char* text : texts) {
    Scene scene;
    const auto c = constrained(scene, "HingeConstraint");
    scene.script(kHinge + text, scene.scripts);
    scene.level();
    ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin) << text;
    EXPECT_NEAR(scene[c.arm].motion->spin->speed, 3, 1e-4) << text;
    EXPECT_TRUE(scene[c.arm].motion->carries) << text;
  }
}

TEST(ScriptedConstraint, AServoMovesToItsScriptedTarget) {
  Scene scene;
  const auto c = servoed(scene);
  scene.script(kSlider + "slider.TargetPosition = 20", scene.scripts);
  scene.level();
  expectNear(poseAt(scene[c.arm], 3).position, {0, 28, 0});
  EXPECT_TRUE(scene[c.arm].anchored);
}

TEST(ScriptedConstraint, AHingeTurnsBackAndForthAsScripted) {
  Scene scene;
  const auto c = turned(scene);
  scene.script(kHinge +
                   "while true do hinge.AngularVelocity = 1 task.wait(2) "
                   "hinge.AngularVelocity = -1 task.wait(2) end",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion);
  EXPECT_TRUE(scene[c.arm].motion->carries);
  const std::pair<double, float> yaws[] = {
      {0, 0}, {1, 57.3f}, {2, 114.6f}, {3, 57.3f}, {41, 57.3f}};
  for (const auto& [time, yaw] : yaws) EXPECT_NEAR(yawAt(scene[c.arm], time), yaw, 1.5f) << time;
}

TEST(ScriptedConstraint, AHingeWithLimitsDoesNotTurnForever) {
  Scene scene;
  const auto c = turned(scene);
  scene.set(c.id, "LimitsEnabled", true);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion);
  EXPECT_TRUE(scene[c.arm].anchored);
  EXPECT_EQ(scene.unmodelled("motion of a hinge's motor"), 1u);
}

TEST(ScriptedConstraint, AScriptedJointTurnsItsPart) {
  Scene scene;
  const auto [hub, arm] = joined(scene, "Weld");
  scene.script("workspace.Hub.Weld.C0 = CFrame.new(1, 0, 0)", scene.scripts);
  scene.level();
  expectNear(scene[arm].pose.position, {1, 0, 0});
  scene.script(
      "while true do workspace.Hub.Weld.C0 = workspace.Hub.Weld.C0 * CFrame.Angles(0, 0.1, 0) "
      "wait() end",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[arm].motion);
  for (const double time : {6.0, 6.25, 6.5})  // 3 radians a second
    EXPECT_NEAR(std::remainder(yawAt(scene[arm], time) - yawAt(scene[arm], 5), 360),
                std::remainder(3 * (time - 5) * 57.29578, 360), 8)
        << time;
  expectNear(poseAt(scene[arm], 7).position, {1, 0, 0});
  EXPECT_FALSE(scene[hub].motion);
}

TEST(ScriptedConstraint, SettingsChangedByATouchAreReported) {
  Scene scene;
  const auto c = turned(scene);
  scene.part("Button", {20, 0, 0});
  scene.script(
      kHinge + "workspace.Button.Touched:Connect(function() hinge.AngularVelocity = 9 end)",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin);
  EXPECT_NEAR(scene[c.arm].motion->spin->speed, 3, 1e-4);
  EXPECT_EQ(scene.unmodelled("motion that a touch or click starts"), 1u);
}

TEST(ScriptedConstraint, AnUnanchoredPartIsDriven) {
  Scene scene;
  const auto c = turned(scene);
  scene.set(c.arm, "Anchored", true);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion);
  scene.script("workspace.Arm.Anchored = false", scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion);
  EXPECT_TRUE(scene[c.arm].motion->spin);
}

TEST(ScriptedConstraint, AnArmFollowsATweenedBase) {
  Scene scene;
  const auto c = turned(scene);
  scene.script(
      "game:GetService('TweenService'):Create(workspace.Base, TweenInfo.new(2, "
      "Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1, true), "
      "{Position = Vector3.new(0, 10, 20)}):Play()",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin);
  EXPECT_TRUE(scene[c.arm].motion->carries);
  for (const auto& [time, z] : {std::pair{1, 10}, {2, 20}, {3, 10}, {4, 0}, {21, 10}})
    expectNear(poseAt(scene[c.arm], time).position, {0, 8, float(z)}, 0.2f);
}

TEST(ScriptedConstraint, AMotorOnATurningPartIsHeld) {
  Scene scene;
  const auto c = turned(scene);
  scene.script("while true do workspace.Base.CFrame *= CFrame.Angles(0, 0.1, 0) task.wait() end",
               scene.scripts);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion);
  EXPECT_TRUE(scene[c.arm].anchored);
  EXPECT_EQ(scene.unmodelled("motion on a moving part"), 1u);
}

TEST(ScriptedConstraint, ASliderStartsAtTheScriptedBase) {
  Scene scene;
  const auto c = pushed(scene, "PrismaticConstraint");
  scene.set(c.id, "LimitsEnabled", true);
  scene.set(c.id, "UpperLimit", 20.0);
  scene.script(
      "workspace.Base.Position = Vector3.new(50, 10, 0) "
      "workspace.Arm.Position = Vector3.new(50, 8, 0)",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion);
  expectNear(at(scene[c.arm], 0), {50, 8, 0});
  expectNear(at(scene[c.arm], 4), {50, 28, 0});
}

// A hinge attaches a blade to the part of a slider.
TEST(ScriptedConstraint, ConstraintsFormChains) {
  Scene scene;
  const auto c = pushed(scene, "PrismaticConstraint");
  scene.set(c.id, "LimitsEnabled", true);
  scene.set(c.id, "UpperLimit", 20.0);
  const auto blade = scene.part("Blade", {4, 8, 0});
  scene.set(blade, "Anchored", false);
  const auto a0 = scene.add("Attachment", "A0", c.arm), a1 = scene.add("Attachment", "A1", blade);
  scene.set(a1, "CFrame", CFrame{{-4, 0, 0}, {}});
  const auto hinge = scene.add("HingeConstraint", "HingeConstraint", c.arm);
  scene.set(hinge, "Attachment0", Ref{a0});
  scene.set(hinge, "Attachment1", Ref{a1});
  scene.set(hinge, "ActuatorType", EnumItem{1, {}});
  scene.set(hinge, "AngularVelocity", 3.0);
  scene.set(hinge, "MotorMaxTorque", 1e6);
  scene.level();
  ASSERT_TRUE(scene[blade].motion && scene[blade].motion->spin);
  expectNear(at(scene[blade], 0), {4, 8, 0});
  expectNear(at(scene[blade], 4), {4, 28, 0});
  expectNear(scene[blade].motion->spin->pivot, {-4, 0, 0});
  EXPECT_EQ(scene[blade].motion->repeat, importer::Repeat::once);
}

TEST(ScriptedConstraint, AScriptedPartIgnoresTheMotor) {
  Scene scene;
  const auto c = turned(scene);
  scene.script("while true do workspace.Arm.CFrame *= CFrame.Angles(0, 0.1, 0) task.wait() end",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin);
  EXPECT_NEAR(scene[c.arm].motion->spin->speed, 6, 0.1);
  EXPECT_EQ(scene.unmodelled("part that a script and a constraint move"), 1u);
  EXPECT_THAT(scene.noteOf("part that a script and a constraint move"),
              testing::MatchesRegex("moved by the script only; the constraint .* is ignored"));
}

}  // namespace
}  // namespace obby::test
