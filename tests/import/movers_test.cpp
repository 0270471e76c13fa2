// Parts that body movers and their constraints push, pull, turn and hold.
#include <limits>
#include <string>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A loose part with a mover in it.
struct Pushed {
  explicit Pushed(const char* className) {
    part = scene.part("Lift", {0, 8, 0});
    scene.set(part, "Anchored", false);
    mover = scene.add(className, "Mover", part);
    if (std::string(className).rfind("Body", 0) == 0) return;
    scene.set(mover, "Attachment0", Ref{scene.add("Attachment", "A0", part)});
  }
  // `m` is the mover.
  void script(const std::string& text) {
    scene.script("local m = workspace.Lift.Mover\n" + text, scene.scripts);
  }

  Scene scene;
  InstanceId part = kNoInstance, mover = kNoInstance;
};

const char* const kUpAndDown =
    "while true do m.Velocity = Vector3.new(0, 10, 0) task.wait(2)\n"
    "m.Velocity = Vector3.new(0, -10, 0) task.wait(2) end";

TEST(Movers, AVelocityThatALoopTurnsRoundIsAMotion) {
  Pushed lift("BodyVelocity");
  lift.script("m.MaxForce = Vector3.new(0, math.huge, 0)\n" + std::string(kUpAndDown));
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  const auto& motion = *lift.scene[lift.part].motion;
  EXPECT_TRUE(motion.carries);
  EXPECT_NEAR(motion.keys.back().time, 4, 0.02);
  expectNear(at(lift.scene[lift.part], 1), {0, 18, 0}, 0.1f);
  expectNear(at(lift.scene[lift.part], 2), {0, 28, 0}, 0.1f);
  expectNear(at(lift.scene[lift.part], 3), {0, 18, 0}, 0.1f);
  EXPECT_EQ(lift.scene.evidence(lift.part, "motion").rfind("guessed: ", 0), 0u);
}

TEST(Movers, ALinearVelocityGoesToAndFro) {
  Pushed lift("LinearVelocity");
  lift.scene.set(lift.mover, "MaxForce", 1e6);
  lift.script(
      "while true do m.VectorVelocity = Vector3.new(5, 0, 0) task.wait(2)\n"
      "m.VectorVelocity = Vector3.new(-5, 0, 0) task.wait(2) end");
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  expectNear(at(lift.scene[lift.part], 2), {10, 8, 0}, 0.1f);
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
  EXPECT_EQ(floats.scene.unmodelled("motion of a pushing mover"), 0u);
}

TEST(Movers, AVelocityThatATouchTurnsRoundIsNamed) {
  Pushed lift("BodyVelocity");
  lift.scene.set(lift.mover, "Velocity", Vec3{});
  lift.script("workspace.Lift.Touched:Connect(function() " + std::string(kUpAndDown) + " end)");
  lift.scene.level();
  EXPECT_FALSE(lift.scene[lift.part].motion);
  EXPECT_TRUE(lift.scene[lift.part].anchored);
  EXPECT_EQ(lift.scene.unmodelled("motion that a touch or click starts"), 1u);
}

TEST(Movers, WhatFloatsMayTurn) {
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
  floats.script(kUpAndDown);
  floats.scene.level();
  EXPECT_EQ(floats.scene.unmodelled("part that two movers move"), 1u);
}

TEST(Movers, AVelocityCountsFromWhereAScriptPlacesThePart) {
  Pushed lift("BodyVelocity");
  lift.script("workspace.Lift.Position = Vector3.new(50, 8, 0)\n" + std::string(kUpAndDown));
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  expectNear(at(lift.scene[lift.part], 0), {50, 8, 0}, 0.1f);
  expectNear(at(lift.scene[lift.part], 2), {50, 28, 0}, 0.1f);
}

TEST(Movers, WhatPushesForEverIsNamed) {
  const char* const texts[] = {"m.Velocity = Vector3.new(0, 10, 0)",
                               "while true do m.Velocity = Vector3.new(0, 10, 0) task.wait(2)\n"
                               "m.Velocity = Vector3.new(0, -5, 0) task.wait(2) end",
                               "while true do m.Velocity = other() task.wait(2) end"};
  for (const char* text : texts) {
    Pushed away("BodyVelocity");
    away.scene.set(away.mover, "MaxForce", Vec3{1e6f, 1e6f, 1e6f});
    away.script(text);
    away.scene.level();
    EXPECT_FALSE(away.scene[away.part].motion) << text;
    EXPECT_TRUE(away.scene[away.part].anchored) << text;
    EXPECT_EQ(away.scene.unmodelled("motion of a pushing mover"), 1u) << text;
  }
}

TEST(Movers, WhatIsTooWeakOrHasOtherPullsIsLeftLoose) {
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

TEST(Movers, AnAnchoredPartDoesNotHeedThem) {
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
                 CFrame{{}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});  // its X is up
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

TEST(Movers, APlaceThatATweenSwingsIsAMotion) {
  Pushed lift("AlignPosition");
  lift.scene.set(lift.mover, "Mode", EnumItem{0, {}});
  lift.scene.set(lift.mover, "Position", Vec3{0, 8, 0});
  lift.script(kSwing);
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  EXPECT_TRUE(lift.scene[lift.part].motion->carries);
  EXPECT_EQ(lift.scene[lift.part].motion->repeat, importer::Repeat::pingPong);
  expectNear(at(lift.scene[lift.part], 1), {0, 8, 10}, 0.1f);
}

TEST(Movers, ASwingOfALocalScriptCountsAsOtherEndlessMotions) {
  Pushed lift("AlignPosition");
  lift.scene.set(lift.mover, "Mode", EnumItem{0, {}});
  lift.scene.set(lift.mover, "Position", Vec3{0, 8, 0});
  const auto starter = lift.scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto local = lift.scene.add("LocalScript", "Local", starter);
  lift.scene.set(local, "Source", "local m = workspace.Lift.Mover\n" + std::string(kSwing));
  lift.scene.level();
  EXPECT_TRUE(lift.scene[lift.part].motion);
  EXPECT_EQ(lift.scene.unmodelled("part that a LocalScript changes"), 0u);
}

TEST(Movers, APlaceThatALoopTweensIsReachedAsTheTweenIs) {
  Pushed lift("BodyPosition");
  lift.script(
      "local function to(z) game:GetService('TweenService'):Create(m, TweenInfo.new(4, "
      "Enum.EasingStyle.Linear), {Position = Vector3.new(0, 8, z)}):Play() task.wait(5) end\n"
      "while true do to(20) to(0) end");
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  expectNear(at(lift.scene[lift.part], 2), {0, 8, 10}, 0.6f);
  expectNear(at(lift.scene[lift.part], 4.5f), {0, 8, 20}, 0.1f);
  expectNear(at(lift.scene[lift.part], 7), {0, 8, 10}, 0.6f);
}

TEST(Movers, LongTweensThatAreCutAgainAndAgainTakeNoMemory) {
  Pushed lift("BodyPosition");
  lift.script(
      "game:GetService('RunService').Heartbeat:Connect(function() for i = 1, 20 do\n"
      "game:GetService('TweenService'):Create(m, TweenInfo.new(1100, Enum.EasingStyle.Linear), "
      "{Position = Vector3.new(0, 8, i)}):Play()\n"
      "task.delay(1100, function() m.Position = Vector3.new(0, 8, 0) end) end\n"
      "task.wait(1150) end)");
  lift.scene.level();
  ASSERT_TRUE(lift.scene[lift.part].motion);
  EXPECT_LT(lift.scene[lift.part].motion->keys.size(), 60000u);
}

TEST(Movers, WhatIsAlignedWithATweenedPartGoesWithIt) {
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
      expectNear(at(lift.scene[lift.part], 2), {0, 8, 20}, 0.1f);
    } else {
      EXPECT_EQ(lift.scene.unmodelled("constraint AlignPosition"), 1u);
    }
  }
}

TEST(Movers, WhatALocalScriptSetsIsForOnePlayer) {
  Pushed drum("AngularVelocity");
  drum.scene.set(drum.mover, "AngularVelocity", Vec3{0, 3, 0});
  drum.scene.set(drum.mover, "MaxTorque", 1000.0);
  const auto starter = drum.scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto local = drum.scene.add("LocalScript", "Local", starter);
  const std::string sets = "workspace.Lift.Mover.AngularVelocity = Vector3.new(0, 9, 0)";
  for (const char* before : {"", "task.wait(2) "}) {
    drum.scene.set(local, "Source", before + sets);
    drum.scene.level();
    ASSERT_TRUE(drum.scene[drum.part].motion && drum.scene[drum.part].motion->spin) << before;
    EXPECT_NEAR(drum.scene[drum.part].motion->spin->speed, 3, 1e-4) << before;
    EXPECT_EQ(drum.scene.unmodelled("part that a LocalScript changes"), 1u) << before;
  }
}

}  // namespace
}  // namespace obby::test
