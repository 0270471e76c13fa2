// Tweens: how far they turn, what they reach together, and how they come back.
#include <algorithm>
#include <cmath>

#include "import/motion_checks.h"
#include "import/pose_math.h"

namespace obby::test {
namespace {

constexpr float kTweenPi = 3.14159265f;

// One part, tweened by `info` to `goals`; `p` is the part, and `before` runs first.
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

  Scene scene;
  InstanceId part = kNoInstance;
};

const std::string kLinear = "Enum.EasingStyle.Linear, Enum.EasingDirection.In";

// Degrees about Y that the keys turn one after the other, and their largest step.
std::pair<float, float> yawThrough(const importer::Motion& motion) {
  float total = 0, largest = 0;
  for (size_t i = 1; i < motion.keys.size(); ++i) {
    const Mat3 turn = motion.keys[i].pose.rotation * inverse(motion.keys[i - 1].pose.rotation);
    const float yaw = importer::toOrientation(turn).y;
    total += yaw;
    largest = std::max(largest, std::abs(yaw));
  }
  return {total, largest};
}

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
    EXPECT_EQ(motion.keys.size(), *now.before ? 1u : 0u);  // it begins where the script put it
  }
}

TEST(Tween, LongTurnsGoTheWholeWay) {
  const std::string goal = "Orientation = p.Orientation + Vector3.new(0, 270, 0)";
  const Tweened endless("3, " + kLinear + ", -1", goal), once("3", goal);
  EXPECT_FALSE(endless.motion().spin);
  for (const auto* motion : {&endless.motion(), &once.motion()}) {
    const auto [total, largest] = yawThrough(*motion);
    EXPECT_NEAR(total, 270, 0.1);
    EXPECT_LE(largest, 90);
    EXPECT_NEAR(motion->keys.back().time, 3, 1e-4);
  }
  // Quad out: three quarters of the way after half the time.
  const auto& keys = once.motion().keys;
  const auto half =
      std::find_if(keys.begin(), keys.end(), [](const auto& key) { return key.time > 1.499f; });
  ASSERT_NE(half, keys.end());
  EXPECT_NEAR(importer::toOrientation(half->pose.rotation).y, 202.5 - 360, 2);
}

TEST(Tween, WhatTurnsAboutTwoAxesFollowsItsAngles) {
  const Tweened tweened("2, " + kLinear, "Orientation = Vector3.new(60, 80, 0)");
  const auto& keys = tweened.motion().keys;
  const auto half =
      std::find_if(keys.begin(), keys.end(), [](const auto& key) { return key.time > 0.999f; });
  ASSERT_NE(half, keys.end());
  expectNear(importer::toOrientation(half->pose.rotation), {30, 40, 0}, 1);
}

TEST(Tween, GoalsOfOneTweenAreReachedTogether) {
  const std::string goals = "Position = Vector3.new(0, 0, 20), Orientation = Vector3.new(0, 90, 0)";
  const Tweened swing("2, Enum.EasingStyle.Linear, Enum.EasingDirection.Out, -1, true", goals);
  EXPECT_EQ(swing.motion().repeat, importer::Repeat::pingPong);
  const Tweened once("2, " + kLinear, goals);
  for (const auto* motion : {&swing.motion(), &once.motion()}) {
    const auto& last = motion->keys.back();
    EXPECT_NEAR(last.time, 2, 1e-4);
    expectNear(last.pose.position, {0, 0, 20});
    EXPECT_NEAR(importer::toOrientation(last.pose.rotation).y, 90, 0.1);
  }
}

TEST(Tween, AWayBackRunsTimeBackwards) {
  using enum importer::EasingDirection;
  const std::pair<const char*, importer::EasingDirection> cases[] = {
      {"Out", in}, {"In", out}, {"InOut", inOut}};
  for (const auto& [direction, back] : cases) {
    const Tweened tweened(
        "2, Enum.EasingStyle.Quad, Enum.EasingDirection." + std::string(direction) + ", 0, true",
        "Position = Vector3.new(0, 8, 0)");
    const auto& keys = tweened.motion().keys;
    ASSERT_EQ(keys.size(), 3u);
    EXPECT_NE(keys[1].direction, back == inOut ? in : back) << direction;
    EXPECT_EQ(keys[2].direction, back) << direction;
    EXPECT_EQ(keys[2].easing, importer::Easing::quad);
    EXPECT_NEAR(keys[2].time, 4, 1e-4);
  }
}

TEST(Tween, AnUnknownGoalOfAPoseLeavesThePartWhereItIs) {
  const Tweened tweened("2", "Position = Vector3.new(0, 8, 0), Orientation = other()");
  EXPECT_FALSE(tweened.scene[tweened.part].motion);
  EXPECT_EQ(tweened.scene.unmodelled("motion that a script computes"), 1u);
}

TEST(Tween, ALoopAfterItTakesNothingAway) {
  const char* const loops[] = {
      "while true do print('x') wait(1) end",
      "while true do workspace.Other.CFrame *= CFrame.Angles(0, 0.1, 0) task.wait() end"};
  for (const char* loop : loops) {
    Scene scene;
    const auto endless = scene.part("Endless"), once = scene.part("Once", {9, 0, 0});
    const auto other = scene.part("Other", {20, 0, 0});
    scene.script(
        "local ts, goal = game:GetService('TweenService'), {Position = Vector3.new(0, 8, 0)}\n"
        "ts:Create(workspace.Endless, TweenInfo.new(2, " +
            kLinear +
            ", -1, true), goal):Play()\n"
            "ts:Create(workspace.Once, TweenInfo.new(3), goal):Play()\n" +
            loop,
        scene.scripts);
    scene.level();
    ASSERT_TRUE(scene[endless].motion && scene[once].motion) << loop;
    EXPECT_EQ(scene[endless].motion->repeat, importer::Repeat::pingPong) << loop;
    EXPECT_EQ(scene[once].motion->repeat, importer::Repeat::once) << loop;
    expectNear(at(scene[once], 0), {9, 0, 0});
    expectNear(at(scene[once], 3), {0, 8, 0});
    EXPECT_EQ(scene[other].motion.has_value(), loop != loops[0]) << loop;
  }
}

TEST(Tween, AnEndlessOneBeginsWhereTheOneBeforeItEnds) {
  const Tweened tweened("2, " + kLinear + ", -1, true", "Position = Vector3.new(0, 8, 20)",
                        "local t = game:GetService('TweenService'):Create(p, TweenInfo.new(1), "
                        "{Position = Vector3.new(0, 8, 0)}) t:Play() t.Completed:Wait()");
  const auto& motion = tweened.motion();
  EXPECT_EQ(motion.repeat, importer::Repeat::pingPong);
  ASSERT_EQ(motion.keys.size(), 2u);
  expectNear(motion.keys[0].pose.position, {0, 8, 0});
  EXPECT_NEAR(motion.offset, -1, 0.02);
}

TEST(Tween, AComputedTimeIsAGuess) {
  for (const bool computed : {false, true}) {
    const Tweened tweened(
        std::string(computed ? "math.random(2, 5), " : "2, ") + kLinear + ", -1, true",
        "Position = Vector3.new(0, 8, 0)");
    const std::string why = tweened.scene.evidence(tweened.part, "motion");
    EXPECT_EQ(why.rfind("guessed: ", 0) == 0, computed) << why;
    EXPECT_EQ(tweened.scene.unmodelled("wait that a script computes"), computed ? 1u : 0u);
  }
}

TEST(Tween, OfManyRoundsTheFirstOnesAreDone) {
  const std::string goal = "Position = Vector3.new(0, 8, 0)";
  for (const bool many : {false, true}) {
    const Tweened tweened("0.5, " + kLinear + (many ? ", 101" : ", 100"), goal);
    EXPECT_EQ(tweened.motion().repeat, importer::Repeat::once);
    EXPECT_NEAR(tweened.motion().keys.back().time, 50.5, 1e-3);
    EXPECT_EQ(tweened.scene.unmodelled("tween with many repeats"), many ? 1u : 0u);
  }
}

// Nobody waits for its end.
TEST(Tween, OneThatRepeatsForLongerThanAMotionCanIsEndless) {
  for (const char* repeats : {"500", "1e5", "1e9"}) {
    Tweened tweened("2, " + kLinear + ", " + repeats + ", true", "Position = Vector3.new(0, 8, 0)");
    EXPECT_EQ(tweened.motion().repeat, importer::Repeat::pingPong) << repeats;
    EXPECT_NEAR(tweened.motion().keys.back().time, 2, 1e-3) << repeats;
    EXPECT_TRUE(tweened.scene.level().unmodelled.empty()) << repeats;
  }
}

TEST(Tween, HostileTurnsHaveFewKeys) {
  const Tweened tweened("1, Enum.EasingStyle.Sine, Enum.EasingDirection.Out, 400, true",
                        "Orientation = Vector3.new(1e9, 1e30, 5)");
  EXPECT_GT(tweened.motion().keys.size(), 200u);
  EXPECT_LT(tweened.motion().keys.size(), 1600u);
}

}  // namespace
}  // namespace obby::test
