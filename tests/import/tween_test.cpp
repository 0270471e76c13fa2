// Tweens: their angles, their combined effect, and their reversal.
#include <cmath>

#include "import/document/pose_math.h"
#include "import/motion_checks.h"

namespace obby::test {
namespace {

constexpr float kTweenPi = 3.14159265f;

// A part `p` that a script tweens by `info` to `goals`. `before` runs before the tween.
struct Tweened {
  Tweened(const std::string& info, const std::string& goals, const std::string& before = {}) {
    part = scene.part("Mover");
    scene.script("local p = script.Parent\n" + before +
                     "\ngame:GetService('TweenService'):Create(p, TweenInfo.new(" + info + "), {" +
                     goals + "}):Play()",
                 part);
    scene.level();
  }
  const importer::Motion& motion() const {
    static const importer::Motion kNone;
    EXPECT_TRUE(scene[part].motion);
    return scene[part].motion ? *scene[part].motion : kNone;
  }
  Vec3 at(double time) const { return poseAt(scene[part], time).position; }
  float yaw(double time) const { return yawAt(scene[part], time); }

  Scene scene;
  InstanceId part = kNoInstance;
};

const std::string kLinear = "Enum.EasingStyle.Linear, Enum.EasingDirection.In";

TEST(Tween, EndlessWholeTurnsAreASpin) {
  struct Case {
    const char *goal, *before;
    Vec3 axis;
    float speed;
  };
  const Case cases[] = {
      {"Orientation = p.Orientation + Vector3.new(0, 360, 0)", "", {0, 1, 0}, kTweenPi / 2},
      {"Orientation = Vector3.new(0, -720, 0)", "", {0, -1, 0}, kTweenPi},
      {"Orientation = p.Orientation + Vector3.new(0, 360, 0)",
       "p.Orientation = Vector3.new(0, 0, 90)",
       {1, 0, 0},
       kTweenPi / 2}};
  for (const Case& now : cases) {
    const Tweened tweened("4, " + kLinear + ", -1", now.goal, now.before);
    const auto& motion = tweened.motion();
    ASSERT_TRUE(motion.spin) << now.goal;
    EXPECT_NEAR(motion.spin->speed, now.speed, 1e-4) << now.goal;
    expectNear(motion.spin->axis, now.axis);
    expectNear(motion.spin->pivot, {});
    EXPECT_EQ(motion.keys.size(), 0u);
    EXPECT_NEAR(motion.offset, 0, 1e-3);
  }
}

TEST(Tween, LongTurnsTakeTheLongDirection) {
  const std::string goal = "Orientation = p.Orientation + Vector3.new(0, 270, 0)";
  const Tweened endless("3, " + kLinear + ", -1", goal), once("3", goal);
  EXPECT_FALSE(endless.motion().spin);
  for (const double round : {0, 30})
    for (const double time : {0.5, 1.0, 1.5, 1.9})
      EXPECT_NEAR(endless.yaw(round + time), 90 * time, 3) << time;
  EXPECT_NEAR(once.yaw(1.5), 202.5 - 360, 1.5);  // quad, out
  EXPECT_NEAR(once.yaw(3), -90, 0.1);
  EXPECT_NEAR(once.yaw(30), -90, 0.1);
}

TEST(Tween, ATurnAboutTwoAxesFollowsItsAngles) {
  const Tweened tweened("2, " + kLinear, "Orientation = Vector3.new(60, 80, 0)");
  const Pose half = poseAt(tweened.scene[tweened.part], 1);
  expectNear(importer::toOrientation(half.rotation), {30, 40, 0}, 1);
}

TEST(Tween, AllGoalsOfATweenAreReachedTogether) {
  const std::string goals = "Position = Vector3.new(0, 0, 20), Orientation = Vector3.new(0, 90, 0)";
  const Tweened swing("2, Enum.EasingStyle.Linear, Enum.EasingDirection.Out, -1, true", goals);
  const Tweened once("2, " + kLinear, goals);
  for (const Tweened* tweened : {&swing, &once}) {
    expectNear(tweened->at(2), {0, 0, 20});
    EXPECT_NEAR(tweened->yaw(2), 90, 0.1);
    EXPECT_NEAR(tweened->yaw(1), 45, 0.5);
  }
}

TEST(Tween, AReversingTweenRunsTimeBackwards) {
  struct Case {
    const char* direction;
    float half;
  };
  for (const Case& now : {Case{"Out", 6}, {"In", 2}, {"InOut", 4}}) {
    const Tweened tweened("2, Enum.EasingStyle.Quad, Enum.EasingDirection." +
                              std::string(now.direction) + ", 0, true",
                          "Position = Vector3.new(0, 8, 0)");
    for (const double time : {1, 3}) EXPECT_NEAR(tweened.at(time).y, now.half, 0.1);
    EXPECT_NEAR(tweened.at(2).y, 8, 0.1) << now.direction;
    EXPECT_NEAR(tweened.at(4).y, 0, 0.1) << now.direction;
  }
}

TEST(Tween, InvalidTweensAreReportedAndNotPlayed) {
  const Tweened tweened("2", "Position = Vector3.new(0, 8, 0), Orientation = other()");
  EXPECT_FALSE(tweened.scene[tweened.part].motion);
  EXPECT_EQ(tweened.scene.unmodelled("script that fails"), 1u);
}

TEST(Tween, ALoopAfterATweenKeepsItsMotion) {
  Scene scene;
  const auto endless = scene.part("Endless"), once = scene.part("Once", {9, 0, 0});
  const auto other = scene.part("Other", {20, 0, 0});
  scene.script(
      "local ts, goal = game:GetService('TweenService'), {Position = Vector3.new(0, 8, 0)}\n"
      "ts:Create(workspace.Endless, TweenInfo.new(2, " +
          kLinear +
          ", -1, true), goal):Play()\n"
          "ts:Create(workspace.Once, TweenInfo.new(2.5), goal):Play()\n"
          "while true do workspace.Other.CFrame *= CFrame.Angles(0, 0.1, 0) task.wait() end",
      scene.scripts);
  scene.level();
  expectNear(poseAt(scene[endless], 42).position, {0, 8, 0}, 0.1f);
  expectNear(poseAt(scene[once], 0).position, {9, 0, 0});
  expectNear(poseAt(scene[once], 1.25).position, {2.25f, 6, 0}, 0.1f);
  expectNear(poseAt(scene[once], 3).position, {0, 8, 0});
  ASSERT_TRUE(scene[other].motion);
  EXPECT_TRUE(scene[other].motion->spin);
}

TEST(Tween, AnEndlessTweenStartsAtThePrecedingTweensEnd) {
  const Tweened tweened("2, " + kLinear + ", -1, true", "Position = Vector3.new(0, 8, 20)",
                        "local t = game:GetService('TweenService'):Create(p, TweenInfo.new(1), "
                        "{Position = Vector3.new(0, 8, 0)}) t:Play() t.Completed:Wait()");
  expectNear(tweened.at(2), {0, 8, 10}, 0.4f);
  expectNear(tweened.at(3), {0, 8, 20}, 0.4f);
  expectNear(tweened.at(41), {0, 8, 0}, 0.4f);
}

TEST(Tween, AllRepetitionsAreRecorded) {
  const std::string goal = "Position = Vector3.new(0, 8, 0)";
  Tweened over("0.5, " + kLinear + ", 99", goal);
  EXPECT_NEAR(over.at(20.25).y, 4, 0.3);
  EXPECT_NEAR(over.at(49.75).y, 4, 0.3);
  EXPECT_NEAR(over.at(55).y, 8, 0.1);
  EXPECT_TRUE(over.scene.level().unmodelled.empty());
}

// Tweens that outlast the run count as endless.
TEST(Tween, RepetitionsBeyondTheRunCountAsEndless) {
  for (const char* repeats : {"500", "1e5", "1e9", "-1"}) {
    Tweened tweened("2, " + kLinear + ", " + repeats + ", true", "Position = Vector3.new(0, 8, 0)");
    EXPECT_EQ(tweened.motion().repeat, importer::Repeat::loop) << repeats;
    EXPECT_NEAR(tweened.at(1).y, 4, 0.1) << repeats;
    EXPECT_NEAR(tweened.at(42).y, 8, 0.1) << repeats;
    EXPECT_TRUE(tweened.scene.level().unmodelled.empty()) << repeats;
  }
  Tweened ends("2, " + kLinear + ", 20, true", "Position = Vector3.new(0, 8, 0)");
  EXPECT_NEAR(ends.at(42).y, 8, 0.1);
  EXPECT_EQ(ends.scene.level().unmodelled.count("motion that ends"), 1u);
}

// A script that plays tweens in an endless loop does not end with the last observed tween.
TEST(Tween, AlternatingTweensInALoopAreEndless) {
  Scene scene;
  const InstanceId slab = scene.part("Slab");
  scene.script(R"(
local tweens, info = game:GetService("TweenService"), TweenInfo.new(4, Enum.EasingStyle.Sine)
local there = tweens:Create(script.Parent, info, {Position = Vector3.new(0, 5, 9)})
local back = tweens:Create(script.Parent, info, {Position = Vector3.new(0, 5, 0)})
while true do
  there:Play()
  there.Completed:Wait()
  back:Play()
  back.Completed:Wait()
end)",
               slab);
  EXPECT_TRUE(scene.level().unmodelled.empty());
  EXPECT_TRUE(scene[slab].motion);
}

// The recorded run shows at most half a round.
TEST(Tween, LongTweensContinueBeyondTheRun) {
  const Tweened swing("40, " + kLinear + ", -1, true", "Position = Vector3.new(0, 0, 80)");
  const Tweened once("100",
                     "Position = Vector3.new(0, 0, 80), Orientation = Vector3.new(0, 90, 0)");
  const Tweened turn("200, " + kLinear + ", -1", "Orientation = Vector3.new(0, 360, 0)");
  for (const auto& [time, z] : {std::pair(10, 20), {40, 80}, {60, 40}, {80, 0}, {90, 20}})
    EXPECT_NEAR(swing.at(time).z, float(z), 0.1) << time;
  EXPECT_LE(swing.motion().keys.size(), 8u);
  for (const auto& [time, z] : {std::pair(50, 60.0f), {80, 76.8f}, {100, 80}, {300, 80}})
    EXPECT_NEAR(once.at(time).z, z, 0.1) << time;
  EXPECT_NEAR(once.yaw(300), 90, 0.1);
  ASSERT_TRUE(turn.motion().spin);
  EXPECT_NEAR(turn.yaw(150), -90, 0.1);
  EXPECT_TRUE(turn.scene.unmodelled("motion without a period") == 0);
}

TEST(Tween, HostileTurnsEndSoon) {
  const Tweened tweened("1, Enum.EasingStyle.Sine, Enum.EasingDirection.Out, 400, true",
                        "Orientation = Vector3.new(1e9, 1e30, 5)");
  const auto& motion = tweened.scene[tweened.part].motion;
  EXPECT_TRUE(!motion || motion->keys.size() < 4000);
}

}  // namespace
}  // namespace obby::test
