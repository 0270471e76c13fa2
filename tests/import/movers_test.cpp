// Parts that body movers and their constraints push, pull, turn and hold.
#include <limits>
#include <string>
#include <utility>

#include "import/constraint_scene.h"
#include "import/motion_checks.h"

namespace obby::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// An unanchored part with a mover in it.
struct Pushed {
  explicit Pushed(const char* className) {
    part = scene.part("Lift", {0, 8, 0});
    scene.set(part, "Anchored", false);
    mover = scene.add(className, "Mover", part);
    if (std::string(className).rfind("Body", 0) == 0) return;
    scene.set(mover, "Attachment0", Ref{scene.add("Attachment", "A0", part)});
  }
  // Adds a script in which `m` is the mover.
  void script(const std::string& text) {
    scene.script("local m = workspace.Lift.Mover\n" + text, scene.scripts);
  }

  Scene scene;
  InstanceId part = kNoInstance, mover = kNoInstance;
};

void clientScript(Scene& scene, const std::string& text) {
  const auto starter = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto folder = scene.add("StarterPlayerScripts", "StarterPlayerScripts", starter);
  scene.set(scene.add("LocalScript", "Local", folder), "Source", text);
}

const char* const kUpAndDown =
    "while true do m.Velocity = Vector3.new(0, 10, 0) task.wait(2)\n"
    "m.Velocity = Vector3.new(0, -10, 0) task.wait(2) end";

TEST(Movers, AnAlternatingVelocityIsAMotion) {
  Pushed lift("BodyVelocity");
  lift.script("m.MaxForce = Vector3.new(0, math.huge, 0)\n" + std::string(kUpAndDown));
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  EXPECT_TRUE(lift.scene[lift.part].motion->carries);
  for (const auto& [time, y] : {std::pair{1, 18}, {2, 28}, {3, 18}, {4, 8}, {42, 28}})
    expectNear(poseAt(lift.scene[lift.part], time).position, {0, float(y), 0}, 0.2f);
  EXPECT_EQ(lift.scene.evidence(lift.part, "motion").rfind("script Script line 2: ", 0), 0u);
}

TEST(Movers, ALinearVelocityMovesBackAndForth) {
  Pushed lift("LinearVelocity");
  lift.scene.set(lift.mover, "MaxForce", 1e6);
  lift.script(
      "while true do m.VectorVelocity = Vector3.new(5, 0, 0) task.wait(2)\n"
      "m.VectorVelocity = Vector3.new(-5, 0, 0) task.wait(2) end");
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  expectNear(poseAt(lift.scene[lift.part], 2).position, {10, 8, 0}, 0.1f);
  lift.scene.set(lift.mover, "VelocityConstraintMode", EnumItem{0, {}});
  lift.scene.level();
  EXPECT_FALSE(lift.scene[lift.part].motion) << "along a line";
  EXPECT_EQ(lift.scene.unmodelled("constraint LinearVelocity"), 1u);
}

TEST(Movers, AMoverWithoutVelocityHoldsItsPart) {
  Pushed floats("BodyVelocity");
  floats.scene.set(floats.mover, "Velocity", Vec3{});
  floats.scene.set(floats.mover, "MaxForce", Vec3{kInfinity, kInfinity, kInfinity});
  floats.scene.level();
  EXPECT_FALSE(floats.scene[floats.part].motion);
  EXPECT_TRUE(floats.scene[floats.part].anchored);
  EXPECT_NE(floats.scene.evidence(floats.part, "held"), "");
  EXPECT_EQ(floats.scene.unmodelled("constraint BodyVelocity"), 0u);
  EXPECT_EQ(floats.scene.unmodelled("motion by a BodyVelocity or LinearVelocity"), 0u);
}

TEST(Movers, AVelocitySetByATouchBeginsWithIt) {
  Pushed lift("BodyVelocity");
  lift.scene.set(lift.mover, "Velocity", Vec3{});
  lift.script("workspace.Lift.Touched:Connect(function() " + std::string(kUpAndDown) + " end)");
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  EXPECT_EQ(lift.scene[lift.part].motion->trigger, importer::MotionTrigger::touch);
  EXPECT_TRUE(lift.scene[lift.part].motion->carries);
  EXPECT_TRUE(lift.scene[lift.part].anchored);
  expectNear(at(lift.scene[lift.part], 1), {0, 18, 0}, 0.4f);
  expectNear(at(lift.scene[lift.part], 2), {0, 28, 0}, 0.4f);
}

// A hinge with a servo opens 90 degrees in a second, and shuts after four.
TEST(Movers, ADoorThatATouchOpensTurns) {
  Scene scene;
  const auto c = constrained(scene, "HingeConstraint");
  scene.set(c.id, "ActuatorType", EnumItem{2, {}});
  scene.set(c.id, "AngularSpeed", 1.5708);
  scene.set(c.id, "ServoMaxTorque", 1e6);
  const auto button = scene.part("Button", {30, 0, 0});
  scene.script(
      "local hinge = workspace.Base.HingeConstraint\n"
      "script.Parent.Touched:Connect(function() hinge.TargetAngle = 90 wait(4) "
      "hinge.TargetAngle = 0 end)",
      button);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[button].button);
  EXPECT_EQ(scene[c.arm].motion->signal, scene[button].button->signal);
  EXPECT_TRUE(scene[c.arm].motion->carries && scene[c.arm].anchored);
  for (const auto& [time, yaw] : {std::pair{0.5, 45}, {2.0, 90}, {4.5, 45}, {6.0, 0}})
    EXPECT_NEAR(yawAt(scene[c.arm], time), yaw, 4) << time;
}

TEST(Movers, AMoverThatAScriptMakesPushes) {
  Scene scene;
  const auto lift = scene.part("Lift", {0, 8, 0});
  scene.script(
      "local p = script.Parent p.Anchored = false\nlocal m = Instance.new('BodyPosition')\n"
      "m.MaxForce = Vector3.one * math.huge m.Position = p.Position m.Parent = p\n"
      "while true do m.Position += Vector3.new(0, 0, 20) wait(2)\n"
      "m.Position -= Vector3.new(0, 0, 20) wait(2) end",
      lift);
  scene.level();
  ASSERT_TRUE(scene[lift].motion);
  EXPECT_TRUE(scene[lift].motion->carries);
  for (const auto& [time, z] : {std::pair{5.5, 20}, {7.5, 0}, {9.5, 20}})
    expectNear(poseAt(scene[lift], time).position, {0, 8, float(z)}, 0.1f);
}

TEST(Movers, AMoverThatAScriptMakesHolds) {
  Scene scene;
  const auto lift = scene.part("Lift", {0, 8, 0});
  scene.script(
      "local p = script.Parent p.Anchored = false\nlocal m = Instance.new('BodyPosition', p)\n"
      "m.MaxForce = Vector3.one * math.huge m.Position = Vector3.new(0, 12, 0)",
      lift);
  scene.level();
  EXPECT_TRUE(scene[lift].anchored);
  expectNear(poseAt(scene[lift], 4).position, {0, 12, 0});
}

TEST(Movers, AFloatingPartCanTurn) {
  Pushed floats("BodyVelocity");
  floats.scene.set(floats.mover, "Velocity", Vec3{});
  floats.scene.add("BodyAngularVelocity", "Turner", floats.part);
  floats.scene.level();
  ASSERT_TRUE(floats.scene[floats.part].motion);
  EXPECT_TRUE(floats.scene[floats.part].motion->spin);
  EXPECT_EQ(floats.scene.unmodelled("part that two movers move"), 0u);
  floats.scene.set(floats.mover, "Velocity", Vec3{0, 5, 0});
  floats.scene.level();
  EXPECT_EQ(floats.scene.unmodelled("part that two movers move"), 1u);
}

TEST(Movers, AVelocityStartsFromTheScriptedPosition) {
  Pushed lift("BodyVelocity");
  lift.script("workspace.Lift.Position = Vector3.new(50, 8, 0)\n" + std::string(kUpAndDown));
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  expectNear(poseAt(lift.scene[lift.part], 0).position, {50, 8, 0}, 0.1f);
  expectNear(poseAt(lift.scene[lift.part], 2).position, {50, 28, 0}, 0.1f);
}

TEST(Movers, APermanentPushIsReported) {
  const std::pair<const char*, const char*> cases[] = {
      {"m.Velocity = Vector3.new(0, 10, 0)", "motion without a period"},
      {"while true do m.Velocity = Vector3.new(0, 10, 0) task.wait(2)\n"
       "m.Velocity = Vector3.new(0, -5, 0) task.wait(2) end",
       "motion without a period"},
      {"print('as in the file')", "motion by a BodyVelocity or LinearVelocity"}};
  for (const auto& [text, kind] : cases) {
    Pushed away("BodyVelocity");
    away.scene.set(away.mover, "MaxForce", Vec3{1e6f, 1e6f, 1e6f});
    away.script(text);
    away.scene.level();
    EXPECT_FALSE(away.scene[away.part].motion) << text;
    EXPECT_TRUE(away.scene[away.part].anchored) << text;
    EXPECT_EQ(away.scene.unmodelled(kind), 1u) << text;
  }
}

TEST(Movers, WeakOrConflictingMoversLeaveThePartDynamic) {
  Pushed weak("BodyVelocity");
  weak.scene.set(weak.mover, "MaxForce", Vec3{1e6f, 100, 1e6f});
  weak.script(kUpAndDown);
  weak.scene.level();
  EXPECT_FALSE(weak.scene[weak.part].motion);
  EXPECT_FALSE(weak.scene[weak.part].anchored);
  EXPECT_EQ(weak.scene.unmodelled("constraint BodyVelocity"), 1u);

  Pushed pulled("BodyVelocity");
  pulled.scene.set(pulled.mover, "MaxForce", Vec3{1e6f, 1e6f, 1e6f});
  pulled.scene.add("BodyForce", "BodyForce", pulled.part);
  pulled.script(kUpAndDown);
  pulled.scene.level();
  EXPECT_FALSE(pulled.scene[pulled.part].motion);
  EXPECT_EQ(pulled.scene.unmodelled("constraint BodyVelocity"), 1u);
}

TEST(Movers, AnAnchoredPartIgnoresMovers) {
  Pushed still("BodyVelocity");
  still.scene.set(still.part, "Anchored", true);
  still.script(kUpAndDown);
  still.scene.level();
  EXPECT_FALSE(still.scene[still.part].motion);
  EXPECT_EQ(still.scene.unmodelled("constraint BodyVelocity"), 0u);
}

TEST(Movers, ATurnMayBeInTheFrameOfTheAttachment) {
  Pushed drum("AngularVelocity");
  drum.scene.set(drum.mover, "AngularVelocity", Vec3{3, 0, 0});
  drum.scene.set(drum.mover, "MaxTorque", 1000.0);
  drum.scene.set(drum.scene.document.instances[drum.part].children.back(), "CFrame",
                 CFrame{{}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});  // its X axis points up
  for (const uint32_t frame : {0u, 2u}) {
    drum.scene.set(drum.mover, "RelativeTo", EnumItem{frame, {}});
    drum.scene.level();
    ASSERT_TRUE(drum.scene[drum.part].motion && drum.scene[drum.part].motion->spin);
    expectNear(drum.scene[drum.part].motion->spin->axis,
               frame == 0 ? Vec3{0, 1, 0} : Vec3{1, 0, 0});
  }
}

TEST(Movers, AnAxisWithoutTorqueDoesNotTurn) {
  Pushed drum("BodyAngularVelocity");
  drum.scene.set(drum.mover, "AngularVelocity", Vec3{5, 2, 0});
  drum.scene.set(drum.mover, "MaxTorque", Vec3{0, 4000, 0});
  drum.scene.level();
  ASSERT_TRUE(drum.scene[drum.part].motion && drum.scene[drum.part].motion->spin);
  EXPECT_NEAR(drum.scene[drum.part].motion->spin->speed, 2, 1e-4);
  expectNear(drum.scene[drum.part].motion->spin->axis, {0, 1, 0});
}

const char* const kSwing =
    "game:GetService('TweenService'):Create(m, TweenInfo.new(2, Enum.EasingStyle.Linear, "
    "Enum.EasingDirection.In, -1, true), {Position = Vector3.new(0, 8, 20)}):Play()";

// A part follows its target with a lag of a tenth of a second. Client scripts work like server
// scripts.
TEST(Movers, ATweenedTargetPositionIsAMotion) {
  for (const bool local : {false, true}) {
    Pushed lift("AlignPosition");
    lift.scene.set(lift.mover, "Mode", EnumItem{0, {}});
    lift.scene.set(lift.mover, "Position", Vec3{0, 8, 0});
    lift.script(local ? "" : kSwing);
    if (local) clientScript(lift.scene, "local m = workspace.Lift.Mover\n" + std::string(kSwing));
    lift.scene.level();
    ASSERT_TRUE(lift.scene[lift.part].motion) << local;
    EXPECT_TRUE(lift.scene[lift.part].motion->carries);
    for (const auto& [time, z] : {std::pair{1.1, 10}, {3.1, 10}, {5.1, 10}, {41.1, 10}})
      expectNear(poseAt(lift.scene[lift.part], time).position, {0, 8, float(z)}, 0.3f);
  }
}

TEST(Movers, ARepeatedTweenOfTheTargetReachesIt) {
  Pushed lift("BodyPosition");
  lift.script(
      "local function to(z) game:GetService('TweenService'):Create(m, TweenInfo.new(4, "
      "Enum.EasingStyle.Linear), {Position = Vector3.new(0, 8, z)}):Play() task.wait(5) end\n"
      "while true do to(20) to(0) end");
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  for (const auto& [time, z] : {std::pair{2.0, 10}, {4.7, 20}, {7.0, 10}, {9.7, 0}, {42.0, 10}})
    expectNear(poseAt(lift.scene[lift.part], time).position, {0, 8, float(z)}, 0.8f);
}

TEST(Movers, APartAlignedWithATweenedPartFollowsIt) {
  for (const float gap : {0.0f, 9.0f}) {
    Pushed lift("AlignPosition");
    const auto guide = lift.scene.part("Guide", {gap, 8, 0});
    lift.scene.set(lift.mover, "Attachment1", Ref{lift.scene.add("Attachment", "A1", guide)});
    lift.script("m = workspace.Guide\n" + std::string(kSwing));
    lift.scene.level();
    ASSERT_TRUE(lift.scene[guide].motion);
    EXPECT_EQ(lift.scene[lift.part].motion.has_value(), gap == 0);
    if (gap == 0) {
      EXPECT_TRUE(lift.scene[lift.part].motion->carries);
      expectNear(poseAt(lift.scene[lift.part], 2).position, {0, 8, 20}, 0.3f);
      expectNear(poseAt(lift.scene[lift.part], 7).position, {0, 8, 10}, 0.3f);
    } else {
      EXPECT_EQ(lift.scene.unmodelled("constraint AlignPosition"), 1u);
    }
  }
}

TEST(Movers, LocalScriptsCanSetMovers) {
  Pushed drum("AngularVelocity");
  drum.scene.set(drum.mover, "AngularVelocity", Vec3{0, 3, 0});
  drum.scene.set(drum.mover, "MaxTorque", 1000.0);
  clientScript(drum.scene, "workspace.Lift.Mover.AngularVelocity = Vector3.new(0, 9, 0)");
  drum.scene.level();
  ASSERT_TRUE(drum.scene[drum.part].motion && drum.scene[drum.part].motion->spin);
  EXPECT_NEAR(drum.scene[drum.part].motion->spin->speed, 9, 0.1);
}

}  // namespace
}  // namespace obby::test
