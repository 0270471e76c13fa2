// Motions by physics carry players: kits and constraints.
#include <string>
#include <utility>
#include <vector>

#include "import/constraint_scene.h"
#include "import/motion_checks.h"

namespace obby::test {
namespace {

TEST(Carrying, ATaggedPlatformFollowsItsWaypoints) {
  Scene scene;
  const auto model = scene.add("Model", "MovingPlatform", scene.workspace);
  scene.tag(model, "MovingPlatform");
  scene.attribute(model, "speed", 10.0);
  scene.attribute(model, "delay", 1.0);
  const auto platform = scene.part("Platform", {0, 0, 0}, model);
  const auto path = scene.add("Folder", "Checkpoints", model);
  const auto first = scene.part("Checkpoint1", {0, 0, 0}, path);
  scene.part("Checkpoint2", {40, 0, 0}, path);
  scene.level();
  ASSERT_TRUE(scene[platform].motion);
  EXPECT_TRUE(scene[platform].motion->carries);
  EXPECT_NEAR(scene[platform].motion->keys.back().time, 1 + 4 + 1 + 4, 1e-3);
  expectNear(at(scene[platform], 3), {20, 0, 0});
  EXPECT_FALSE(scene[first].solid);
  EXPECT_FALSE(scene[first].checkpoint);  // a waypoint, not a respawn point
}

TEST(Carrying, TowerKitPositions) {
  Scene scene;
  const auto model = scene.add("Model", "Moving Platform", scene.workspace);
  const auto platform = scene.part("Platform", {0, 0, 0}, model);
  scene.value("NumberValue", "Delay", 5.0, model);
  const auto positions = scene.add("Model", "Positions", model);
  scene.part("a2", {0, 20, 0}, positions);
  scene.part("a1", {0, 0, 0}, positions);
  scene.level();
  ASSERT_TRUE(scene[platform].motion);
  EXPECT_NEAR(scene[platform].motion->keys.back().time, 10, 1.1);
  expectNear(at(scene[platform], 4.9f), {0, 0, 0});
  expectNear(at(scene[platform], 8), {0, 20, 0});
}

TEST(Carrying, HingeMotorSpinsAndCarries) {
  Scene scene;
  const auto c = constrained(scene, "HingeConstraint");
  scene.set(c.id, "ActuatorType", EnumItem{1, {}});
  scene.set(c.id, "AngularVelocity", 3.0);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion) << "a motor without torque does nothing";
  EXPECT_EQ(scene.unmodelled("constraint HingeConstraint"), 1u);
  scene.set(c.id, "MotorMaxTorque", 1e6);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin);
  EXPECT_TRUE(scene[c.arm].motion->carries);
  EXPECT_TRUE(scene[c.arm].anchored);
  EXPECT_NEAR(scene[c.arm].motion->spin->speed, 3, 1e-4);
  expectNear(scene[c.arm].motion->spin->axis, {0, 1, 0});
}

// The servo moves at 10 studs/s.
TEST(Carrying, ASliderServoMovesToItsScriptedTargets) {
  struct Case {
    const char* text;
    std::vector<std::pair<double, float>> heights;  // times and heights of the arm
  };
  const Case cases[] = {
      {"while true do slider.TargetPosition = 20 task.wait(5)\n"
       "slider.TargetPosition = 0 task.wait(5) end",
       {{0, 8}, {1, 18}, {4, 28}, {6, 18}, {9, 8}, {51, 18}}},
      {"task.wait(1) while true do slider.TargetPosition = 20 task.wait(5)\n"
       "slider.TargetPosition = 0 task.wait(5) end",
       {{2, 18}, {5, 28}, {7, 18}, {10, 8}}},
      // The slider turns back before it arrives.
      {"while true do slider.TargetPosition = 40 task.wait(2)\n"
       "slider.TargetPosition = 0 task.wait(2) end",
       {{1, 18}, {2, 28}, {3, 18}, {4, 8}, {42, 28}}},
      {"while true do task.wait(5) slider.TargetPosition = 20\n"
       "task.wait(5) slider.TargetPosition = 0 end",
       {{6, 18}, {9, 28}, {11, 18}, {14, 8}}},
      {"while true do slider.TargetPosition = 20 task.wait() end", {{3, 28}, {50, 28}}},
      {"task.wait(4) slider.TargetPosition = 20", {{4, 8}, {5, 18}, {7, 28}, {99, 28}}},
      {"while true do slider.TargetPosition = 20 repeat task.wait() until slider.CurrentPosition "
       "> 19.9\nslider.TargetPosition = 0 repeat task.wait() until slider.CurrentPosition < 0.1 "
       "end",
       {{1, 18}, {2, 28}, {3, 18}}}};
  for (const auto& [text, heights] : cases) {
    Scene scene;
    const auto c = servoed(scene);
    scene.script("local slider = script.Parent.PrismaticConstraint\n" + std::string(text), c.base);
    scene.level();
    const auto& arm = scene[c.arm];
    EXPECT_TRUE(arm.anchored) << text;
    EXPECT_TRUE(!arm.motion || arm.motion->carries) << text;
    for (const auto& [time, height] : heights)
      EXPECT_NEAR(poseAt(arm, time).position.y, height, 0.25f) << text << " at " << time;
  }
}

TEST(Carrying, AServoWithoutATargetMovesToZero) {
  Scene scene;
  const auto c = constrained(scene, "PrismaticConstraint");
  scene.set(c.arm, "CFrame", CFrame{{0, 3, 0}, {}});
  scene.set(c.id, "ActuatorType", EnumItem{2, {}});
  scene.set(c.id, "Speed", 10.0);
  scene.set(c.id, "ServoMaxForce", 1e6);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion);
  expectNear(at(scene[c.arm], 4), {0, 8, 0});
}

TEST(Carrying, AServoWithoutForceDrivesNothing) {
  Scene scene;
  const auto c = constrained(scene, "PrismaticConstraint");
  scene.set(c.id, "ActuatorType", EnumItem{2, {}});
  scene.set(c.id, "Speed", 10.0);
  scene.set(c.id, "TargetPosition", 20.0);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion);
  EXPECT_EQ(scene.unmodelled("constraint PrismaticConstraint"), 1u);
  scene.set(c.id, "ServoMaxForce", 1e6);
  scene.level();
  EXPECT_TRUE(scene[c.arm].motion);
}

TEST(Carrying, TurnersNeedTorque) {
  Scene scene;
  const auto wheel = scene.part("Wheel"), drum = scene.part("Drum", {20, 0, 0});
  for (const auto id : {wheel, drum}) scene.set(id, "Anchored", false);
  // The file omits the class's default speed and torque.
  const auto legacy = scene.add("BodyAngularVelocity", "BodyAngularVelocity", wheel);
  const auto turner = scene.add("AngularVelocity", "AngularVelocity", drum);
  const auto attachment = scene.add("Attachment", "Attachment", drum);
  scene.set(turner, "Attachment0", Ref{attachment});
  scene.set(turner, "AngularVelocity", Vec3{0, 3, 0});
  scene.level();
  ASSERT_TRUE(scene[wheel].motion && scene[wheel].motion->spin);
  EXPECT_NEAR(scene[wheel].motion->spin->speed, 2, 1e-4);
  EXPECT_FALSE(scene[drum].motion) << "its torque is 0 unless it is set";
  EXPECT_EQ(scene.unmodelled("constraint AngularVelocity"), 1u);
  scene.set(turner, "MaxTorque", 1000.0);
  scene.set(legacy, "MaxTorque", Vec3{});
  scene.level();
  ASSERT_TRUE(scene[drum].motion && scene[drum].motion->spin);
  EXPECT_NEAR(scene[drum].motion->spin->speed, 3, 1e-4);
  EXPECT_FALSE(scene[wheel].motion);
}

TEST(Carrying, ASliderMotorMovesToItsLimitAndStays) {
  for (const char* className : {"PrismaticConstraint", "CylindricalConstraint"}) {
    Scene scene;
    const auto c = pushed(scene, className);
    scene.set(c.id, "LimitsEnabled", true);
    scene.set(c.id, "LowerLimit", -10.0);
    scene.set(c.id, "UpperLimit", 20.0);
    scene.level();
    ASSERT_TRUE(scene[c.arm].motion) << className;
    EXPECT_TRUE(scene[c.arm].anchored);
    EXPECT_TRUE(scene[c.arm].motion->carries);
    EXPECT_EQ(scene[c.arm].motion->repeat, importer::Repeat::once);
    EXPECT_NEAR(scene[c.arm].motion->keys.back().time, 4, 1e-4);
    expectNear(at(scene[c.arm], 1), {0, 13, 0});
    expectNear(at(scene[c.arm], 4), {0, 28, 0});
    scene.set(c.id, "Velocity", -5.0);
    scene.level();
    ASSERT_TRUE(scene[c.arm].motion) << className;
    expectNear(at(scene[c.arm], 2), {0, -2, 0});
  }
}

TEST(Carrying, ASliderMotorAtItsLimitHoldsItsPart) {
  Scene scene;
  const auto c = pushed(scene, "PrismaticConstraint");
  scene.set(c.id, "LimitsEnabled", true);
  scene.set(c.id, "UpperLimit", 0.0);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion);
  EXPECT_TRUE(scene[c.arm].anchored);
  EXPECT_NE(scene.evidence(c.arm, "held"), "");
  EXPECT_EQ(scene.unmodelled("motion of a slider's motor"), 0u);
}

TEST(Carrying, ASliderMotorWithoutForceDrivesNothing) {
  Scene scene;
  const auto c = pushed(scene, "PrismaticConstraint");
  scene.set(c.id, "MotorMaxForce", 0.0);
  scene.level();
  EXPECT_FALSE(scene[c.arm].motion);
  EXPECT_FALSE(scene[c.arm].anchored);
  EXPECT_EQ(scene.unmodelled("constraint PrismaticConstraint"), 1u);
}

// A deck on the arm of a slider, with or without limits.
struct Decked {
  explicit Decked(bool limited) {
    c = pushed(scene, "PrismaticConstraint");
    scene.set(c.id, "LimitsEnabled", limited);
    deck = scene.part("Deck", {0, 9, 0});
    scene.set(deck, "Anchored", false);
    const auto weld = scene.add("WeldConstraint", "Weld", deck);
    scene.set(weld, "Part0", Ref{deck});
    scene.set(weld, "Part1", Ref{c.arm});
  }

  Scene scene;
  Constraint c{};
  InstanceId deck = kNoInstance;
};

TEST(Carrying, AnUnlimitedSliderMotorHoldsItsParts) {
  Decked slider(false);
  slider.scene.level();
  for (const InstanceId part : {slider.c.arm, slider.deck}) {
    EXPECT_FALSE(slider.scene[part].motion);
    EXPECT_TRUE(slider.scene[part].anchored);
    EXPECT_NE(slider.scene.evidence(part, "held"), "");
  }
  EXPECT_EQ(slider.scene.unmodelled("motion of a slider's motor"), 1u);
  EXPECT_EQ(slider.scene.unmodelled("constraint PrismaticConstraint"), 0u);
  EXPECT_EQ(slider.scene.unmodelled("unanchored part"), 0u);
}

// In one second, the slider moves from its lower limit, 0, to its upper limit, 5.
TEST(Carrying, AReversingSliderMotorMovesBetweenItsLimits) {
  Decked slider(true);
  slider.scene.script(
      "local slider = script.Parent.PrismaticConstraint\nwhile true do\n"
      " slider.Velocity = 5\n task.wait(4)\n slider.Velocity = -5\n task.wait(4)\nend",
      slider.c.base);
  slider.scene.level();
  for (const auto& [part, height] : {std::pair{slider.c.arm, 8.0f}, {slider.deck, 9.0f}}) {
    ASSERT_TRUE(slider.scene[part].motion);
    EXPECT_TRUE(slider.scene[part].motion->carries);
    for (const auto& [time, travel] :
         {std::pair{8.0, 0.0f}, {8.5, 2.5f}, {11, 5.0f}, {12.5, 2.5f}, {15, 0.0f}})
      EXPECT_NEAR(poseAt(slider.scene[part], time).position.y, height + travel, 0.15f) << time;
  }
  EXPECT_TRUE(slider.scene.level().unmodelled.empty());
}

TEST(Carrying, ACylinderTurnsAsItSlides) {
  Scene scene;
  const auto c = pushed(scene, "CylindricalConstraint");
  scene.set(c.id, "LimitsEnabled", true);
  scene.set(c.id, "UpperLimit", 20.0);
  scene.set(c.id, "AngularActuatorType", EnumItem{1, {}});
  scene.set(c.id, "AngularVelocity", 3.0);
  scene.set(c.id, "MotorMaxTorque", 1e6);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin);
  EXPECT_NEAR(scene[c.arm].motion->spin->speed, 3, 1e-4);
  expectNear(at(scene[c.arm], 4), {0, 28, 0});
  scene.set(c.id, "LimitsEnabled", false);
  scene.level();
  ASSERT_TRUE(scene[c.arm].motion && scene[c.arm].motion->spin);
  EXPECT_TRUE(scene[c.arm].motion->keys.empty());
  EXPECT_EQ(scene.unmodelled("motion of a slider's motor"), 1u);
}

}  // namespace
}  // namespace obby::test
