// Tweens of one part that do not come one after the other: those of one property end each other,
// those of different ones go on side by side.
#include <algorithm>
#include <cmath>
#include <string>

#include "import/pose_math.h"
#include "import/tween_scene.h"

namespace obby::test {
namespace {

constexpr float kTweenOverlapPi = 3.14159265f;

// Degrees about Y of the first key at or after `time`.
float yawAt(const importer::Motion& motion, float time) {
  const auto key = std::find_if(motion.keys.begin(), motion.keys.end(),
                                [&](const auto& k) { return k.time > time - 0.01f; });
  return key == motion.keys.end() ? NAN : importer::toOrientation(key->pose.rotation).y;
}

TEST(TweenOverlap, ALaterTweenOfTheSamePropertyEndsTheFirst) {
  const Overlap cut({"tween(even(4), to(40)):Play() task.wait(2) tween(even(2), to(0)):Play()"});
  EXPECT_EQ(cut.motion().repeat, importer::Repeat::once);
  EXPECT_NEAR(cut.z(1), 10, 0.1);
  EXPECT_NEAR(cut.z(2), 20, 0.1);
  EXPECT_NEAR(cut.z(3), 10, 0.1);
  EXPECT_NEAR(cut.z(4), 0, 0.1);
  EXPECT_NEAR(cut.motion().keys.back().time, 4, 0.01);
}

TEST(TweenOverlap, AnEasedTweenIsCutOnItsWay) {
  const Overlap cut(
      {"tween(TweenInfo.new(2), to(16)):Play() task.wait(1)\n"
       "tween(even(1), to(0)):Play()"});
  EXPECT_NEAR(cut.z(0.5f), 7, 0.1);  // quad, out
  EXPECT_NEAR(cut.z(1), 12, 0.1);
  EXPECT_NEAR(cut.z(1.5f), 6, 0.1);
  EXPECT_NEAR(cut.z(2), 0, 0.1);
}

TEST(TweenOverlap, OfTwoThatArePlayedAtOnceTheLastCounts) {
  const Overlap both({"tween(even(2), to(90)):Play() tween(even(2), to(-10)):Play()"});
  EXPECT_NEAR(both.z(1), -5, 0.1);
  EXPECT_NEAR(both.z(2), -10, 0.1);
  EXPECT_NEAR(both.motion().keys.back().time, 2, 0.01);
}

TEST(TweenOverlap, DifferentPropertiesGoSideBySide) {
  const Overlap both(
      {"tween(even(4), to(40)):Play()\n"
       "tween(even(2), {Orientation = Vector3.new(0, 90, 0)}):Play()"});
  EXPECT_NEAR(both.z(1), 10, 0.1);
  EXPECT_NEAR(both.z(4), 40, 0.1);
  EXPECT_NEAR(yawAt(both.motion(), 1), 45, 1);
  EXPECT_NEAR(yawAt(both.motion(), 2), 90, 1);
  EXPECT_NEAR(yawAt(both.motion(), 4), 90, 1);
  EXPECT_NEAR(both.motion().keys.back().time, 4, 0.01);
}

TEST(TweenOverlap, APlatformMayGoToAndFroAndTurn) {
  const char* const there = "tween(swing(2), to(20)):Play()\n";
  const char* const turn = "tween(ever(4), {Orientation = Vector3.new(0, 360, 0)}):Play()\n";
  const Overlap cases[] = {Overlap({std::string(there) + turn}),
                           Overlap({std::string(turn) + there}), Overlap({there, turn}),
                           Overlap({turn, there})};
  for (const Overlap& both : cases) {
    const auto& motion = both.motion();
    EXPECT_EQ(motion.repeat, importer::Repeat::pingPong);
    ASSERT_EQ(motion.keys.size(), 2u);
    EXPECT_NEAR(motion.keys[1].time, 2, 1e-3);
    expectNear(motion.keys[1].pose.position, {0, 0, 20});
    ASSERT_TRUE(motion.spin);
    EXPECT_NEAR(motion.spin->speed, kTweenOverlapPi / 2, 1e-3);
    expectNear(motion.spin->axis, {0, 1, 0});
    EXPECT_EQ(both.scene.unmodelled("part that two scripts move"), 0u);
  }
}

TEST(TweenOverlap, ALoopMayTurnWhatATweenMoves) {
  const std::string there = "tween(swing(2), to(20)):Play()\n";
  for (const char* turn : {"p.CFrame = p.CFrame * CFrame.Angles(0, 0.05, 0)",
                           "p.Orientation = p.Orientation + Vector3.new(0, 3, 0)"}) {
    const std::string loop = "while true do " + std::string(turn) + " task.wait() end";
    const Overlap cases[] = {Overlap({there + loop}), Overlap({there, loop}),
                             Overlap({loop, there})};
    for (const Overlap& both : cases) {
      const auto& motion = both.motion();
      EXPECT_EQ(motion.repeat, importer::Repeat::pingPong) << turn;
      ASSERT_EQ(motion.keys.size(), 2u) << turn;
      expectNear(motion.keys[0].pose.position, {0, 0, 0});
      expectNear(motion.keys[1].pose.position, {0, 0, 20});
      ASSERT_TRUE(motion.spin) << turn;
      EXPECT_NEAR(motion.spin->speed, 3, 0.2) << turn;
      EXPECT_EQ(both.scene.unmodelled("part that two scripts move"), 0u) << turn;
    }
  }
}

TEST(TweenOverlap, ATurnThatBeganLaterIsBehind) {
  const Overlap both(
      {"tween(swing(2), to(20)):Play() task.wait(1)\n"
       "tween(ever(4), {Orientation = Vector3.new(0, 360, 0)}):Play()"});
  ASSERT_TRUE(both.motion().spin);
  EXPECT_EQ(both.motion().offset, 0);
  // A second behind: the keys are turned back by a quarter.
  for (const auto& key : both.motion().keys)
    EXPECT_NEAR(importer::toOrientation(key.pose.rotation).y, -90, 0.5);
}

TEST(TweenOverlap, ALoopGoesOnBesideATurn) {
  const Overlap both(
      {"tween(ever(4), {Orientation = Vector3.new(0, 360, 0)}):Play()\n"
       "while true do tween(even(2), to(20)):Play() task.wait(2)\n"
       "tween(even(2), to(0)):Play() task.wait(2) end"});
  ASSERT_TRUE(both.motion().spin);
  EXPECT_EQ(both.motion().repeat, importer::Repeat::loop);
  EXPECT_NEAR(both.z(2), 20, 0.1);
  EXPECT_NEAR(both.z(3), 10, 0.1);
}

TEST(TweenOverlap, SwingsOfCommonRoundsAreOneMotion) {
  const Overlap both(
      {"tween(swing(2), to(20)):Play()\n"
       "tween(swing(1), {Orientation = Vector3.new(0, 60, 0)}):Play()"});
  EXPECT_EQ(both.motion().repeat, importer::Repeat::loop);
  EXPECT_NEAR(both.motion().keys.back().time, 4, 0.01);
  EXPECT_NEAR(both.z(1), 10, 0.1);
  EXPECT_NEAR(both.z(3), 10, 0.1);
  EXPECT_NEAR(yawAt(both.motion(), 1), 60, 1);
  EXPECT_NEAR(yawAt(both.motion(), 2), 0, 1);
}

TEST(TweenOverlap, ALoopSetsThePartBackBeforeEachTween) {
  const Overlap belt(
      {"while true do p.Position = Vector3.new(0, 0, -10)\n"
       "local t = tween(even(2), to(10)) t:Play() t.Completed:Wait() end"});
  EXPECT_EQ(belt.motion().repeat, importer::Repeat::loop);
  EXPECT_NEAR(belt.motion().keys.back().time, 2, 0.02);
  EXPECT_NEAR(belt.z(0.5f), -5, 0.1);
  EXPECT_NEAR(belt.z(1.5f), 5, 0.1);
}

TEST(TweenOverlap, APoseThatWasKeptBringsThePartBack) {
  const Overlap belt(
      {"local start = p.CFrame while true do p.CFrame = start\n"
       "local t = tween(even(2), to(10)) t:Play() t.Completed:Wait() end"});
  EXPECT_NEAR(belt.z(0.5f), 2.5, 0.1);
  EXPECT_NEAR(belt.z(1.5f), 7.5, 0.1);
}

TEST(TweenOverlap, ALoopThatWaitsFirstIsOneRoundLong) {
  const Overlap swing(
      {"while true do task.wait(2) tween(even(2), to(20)):Play()\n"
       "task.wait(2) tween(even(2), to(0)):Play() end"});
  EXPECT_NEAR(swing.motion().offset, -2, 0.02);
  EXPECT_NEAR(swing.motion().keys.back().time, 4, 0.01);
  EXPECT_NEAR(swing.z(1), 10, 0.1);
  EXPECT_NEAR(swing.z(2), 20, 0.1);
  EXPECT_NEAR(swing.z(3), 10, 0.1);
}

TEST(TweenOverlap, WhatIsTweenedToOnePlaceEachFrameIsThere) {
  const Overlap there({"while true do tween(even(2), to(10)):Play() task.wait() end"});
  EXPECT_NEAR(there.z(0), 10, 0.1);
}

TEST(TweenOverlap, TweensThatCutEachOtherInALoopSwing) {
  const Overlap swing(
      {"while true do tween(even(2), to(10)):Play() task.wait(1)\n"
       "tween(even(2), to(0)):Play() task.wait(1) end"});
  EXPECT_NEAR(swing.motion().keys.back().time, 2, 0.01);
  EXPECT_NEAR(swing.z(0), 10 / 3.0, 0.1);
  EXPECT_NEAR(swing.z(1), 20 / 3.0, 0.1);
  EXPECT_NEAR(swing.z(2), 10 / 3.0, 0.1);
}

TEST(TweenOverlap, ALoopThatChangesMoreIsOneRoundLong) {
  Scene scene;
  const auto part = scene.part("Mover");
  scene.part("Door", {50, 0, 0});
  scene.script(kBefore +
                   "local door = workspace.Door while true do\n"
                   "tween(even(1), to(20)):Play() door.CanCollide = false task.wait(2)\n"
                   "tween(even(1), to(0)):Play() door.CanCollide = true task.wait(3) end",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  EXPECT_NEAR(scene[part].motion->keys.back().time, 5, 0.01);
  EXPECT_NEAR(at(scene[part], 1.5f).z, 20, 0.1);
  EXPECT_NEAR(at(scene[part], 2.5f).z, 10, 0.1);
  EXPECT_NEAR(at(scene[part], 4).z, 0, 0.1);
}

TEST(TweenOverlap, PlayOfWhatPlaysDoesNothing) {
  const Overlap again({"local t = tween(even(2), to(10)) t:Play() task.wait(1) t:Play()"});
  EXPECT_NEAR(again.motion().keys.back().time, 2, 0.01);
  EXPECT_NEAR(again.z(1.5f), 7.5, 0.1);
}

TEST(TweenOverlap, WhatIsCancelledStaysOnItsWay) {
  const Overlap cut({"local t = tween(even(4), to(40)) t:Play() task.wait(1) t:Cancel()"});
  EXPECT_NEAR(cut.z(1), 10, 0.1);
  EXPECT_NEAR(cut.motion().keys.back().time, 1, 0.02);
  expectNear(cut.motion().keys.back().pose.position, {0, 0, 10}, 0.2f);
}

TEST(TweenOverlap, WhatIsPausedGoesOnWithWhatIsLeft) {
  const Overlap even(
      {"local t = tween(even(4), to(40)) t:Play() task.wait(1) t:Pause()\n"
       "task.wait(2) t:Play()"});
  EXPECT_NEAR(even.z(1), 10, 0.1);
  EXPECT_NEAR(even.z(3), 10, 0.1);
  EXPECT_NEAR(even.z(4), 20, 0.1);
  EXPECT_NEAR(even.z(6), 40, 0.1);
  EXPECT_NEAR(even.motion().keys.back().time, 6, 0.02);
  const Overlap eased(
      {"local t = tween(TweenInfo.new(2), to(16)) t:Play() task.wait(1) t:Pause()\n"
       "task.wait(1) t:Play()"});
  EXPECT_NEAR(eased.z(2), 12, 0.1);  // quad, out
  EXPECT_NEAR(eased.z(2.5f), 15, 0.1);
  EXPECT_NEAR(eased.z(3), 16, 0.1);
  const Overlap anew(
      {"local t = tween(even(2), to(20)) t:Play() task.wait(1) t:Pause() t:Cancel()\n"
       "task.wait(1) t:Play()"});
  EXPECT_NEAR(anew.z(3), 15, 0.1);
  EXPECT_NEAR(anew.motion().keys.back().time, 4, 0.02);
}

TEST(TweenOverlap, WhatIsPausedInItsDelayWaitsForTheRest) {
  const Overlap late(
      {"local t = tween(TweenInfo.new(1, line, way, 0, false, 2), to(10)) t:Play()\n"
       "task.wait(1) t:Pause() task.wait(1) t:Play()"});
  EXPECT_NEAR(late.z(3), 0, 0.1);
  EXPECT_NEAR(late.z(3.5f), 5, 0.1);
  EXPECT_NEAR(late.z(4), 10, 0.1);
}

TEST(TweenOverlap, AnEndlessTweenThatALoopPausesIsNamed) {
  const Overlap stops(
      {"local t = tween(swing(2), to(20))\n"
       "while true do t:Play() task.wait(2) t:Pause() task.wait(1) end"});
  EXPECT_FALSE(stops.scene[stops.part].motion);
  EXPECT_EQ(stops.scene.unmodelled("overlapping tweens"), 1u);
}

TEST(TweenOverlap, WhatIsTooLongIsNotCalledMixedUp) {
  const Overlap longest(
      {"tween(TweenInfo.new(500), to(40)):Play()\n"
       "tween(even(2), {Orientation = Vector3.new(0, 90, 0)}):Play()"});
  EXPECT_FALSE(longest.scene[longest.part].motion);
  EXPECT_EQ(longest.scene.unmodelled("overlapping tweens"), 0u);
  EXPECT_EQ(longest.scene.unmodelled("motion of too many poses"), 1u);
}

TEST(TweenOverlap, APoseMayBeSetBesideAnEndlessTween) {
  const Overlap both({"tween(swing(2), to(20)):Play() p.Orientation = Vector3.new(0, 90, 0)"});
  EXPECT_EQ(both.motion().repeat, importer::Repeat::pingPong);
  EXPECT_NEAR(both.z(2), 20, 0.1);
  EXPECT_NEAR(yawAt(both.motion(), 0), 90, 1);
  EXPECT_NEAR(yawAt(both.motion(), 2), 90, 1);
}

TEST(TweenOverlap, WhatMakesNoSingleMotionIsNamed) {
  const char* const texts[] = {
      "tween(even(4), {CFrame = CFrame.new(0, 0, 9)}):Play() task.wait(1)\n"
      "tween(even(4), to(40)):Play()",
      "tween(swing(2), to(20)):Play()\n"
      "tween(even(4), {Orientation = Vector3.new(0, 90, 0)}):Play()",
      "tween(swing(2), to(20)):Play()\n"
      "tween(swing(1.37), {Orientation = Vector3.new(0, 60, 0)}):Play()"};
  for (const char* text : texts) {
    const Overlap both({text});
    EXPECT_FALSE(both.scene[both.part].motion) << text;
    EXPECT_EQ(both.scene.unmodelled("overlapping tweens"), 1u) << text;
  }
}

TEST(TweenOverlap, OfTwoScriptsThatMoveAPartTheFirstCounts) {
  const Overlap both({"tween(swing(2), to(20)):Play()", "tween(swing(2), to(-5)):Play()"});
  ASSERT_EQ(both.motion().keys.size(), 2u);
  expectNear(both.motion().keys[1].pose.position, {0, 0, 20});
  EXPECT_EQ(both.scene.unmodelled("part that two scripts move"), 1u);
}

TEST(ScriptedStart, OneScriptMayPlaceAPartThatAnotherTurns) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script("workspace.Part.Orientation = Vector3.new(0, 90, 0)", scene.scripts);
  scene.script("workspace.Part.Position = Vector3.new(0, 5, 0)", scene.scripts);
  scene.level();
  expectNear(scene[part].pose.position, {0, 5, 0});
  EXPECT_NEAR(importer::toOrientation(scene[part].pose.rotation).y, 90, 0.1);
}

}  // namespace
}  // namespace obby::test
