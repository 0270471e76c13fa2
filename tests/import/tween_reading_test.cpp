// What a script finds where it reads what a tween drives.
#include <string>

#include "import/tween_scene.h"

namespace obby::test {
namespace {

TEST(TweenReading, APoseOnTheWayIsWhereItHasComeTo) {
  const char* const texts[] = {"tween(even(4), to(40)):Play() task.wait(1)",
                               "local t = tween(even(4), to(40)) t:Play() task.wait(1) t:Cancel()",
                               "tween(swing(1.5), to(15)):Play() task.wait(2)"};
  for (const char* text : texts) {
    const Overlap cut({std::string(text) +
                       "\nlocal up = {Position = p.Position + Vector3.new(0, 8, 0)}\n"
                       "tween(even(1), up):Play()"});
    expectNear(cut.motion().keys.back().pose.position, {0, 8, 10}, 0.1f);
  }
}

TEST(TweenReading, AWholeCFrameAndAPivotAreOnTheWayToo) {
  for (const char* pose : {"p.CFrame", "p:GetPivot()"}) {
    const Overlap cut(
        {"tween(even(4), to(40)):Play() task.wait(1)\n"
         "tween(even(1), {Position = (" +
         std::string(pose) + " + Vector3.new(0, 8, 0)).Position}):Play()"});
    expectNear(cut.motion().keys.back().pose.position, {0, 8, 10}, 0.1f);
  }
}

TEST(TweenReading, WhatReversesIsBackWhereItBegan) {
  const Overlap back(
      {"local t = tween(TweenInfo.new(1, line, way, 0, true), to(20)) t:Play()\n"
       "t.Completed:Wait()\n"
       "tween(even(1), {Position = p.Position + Vector3.new(0, 8, 0)}):Play()"});
  expectNear(back.motion().keys.back().pose.position, {0, 8, 0}, 0.1f);
  EXPECT_NEAR(back.motion().keys.back().time, 3, 0.02);
}

TEST(TweenReading, OtherPropertiesAreOnTheWayToo) {
  const char* const reads[] = {
      "tween(even(4), {Size = Vector3.new(4, 1, 44)}):Play() task.wait(1) local up = p.Size.Z",
      "tween(even(4), {Transparency = 1}):Play() task.wait(1) local up = p.Transparency * 56",
      "tween(TweenInfo.new(1, line, way, 0, true), {Transparency = 1}):Play() task.wait(3)\n"
      "local up = p.Transparency + 14"};
  for (const char* read : reads) {
    const Overlap late(
        {std::string(read) + "\ntween(even(1), {Position = Vector3.new(0, up, 0)}):Play()"});
    EXPECT_NEAR(late.motion().keys.back().pose.position.y, 14, 0.1) << read;
  }
}

TEST(TweenReading, WaitingForAnEndTakesWhatIsLeft) {
  const Overlap two(
      {"local t = tween(even(2), to(20)) t:Play() task.wait(1) t.Completed:Wait()\n"
       "tween(even(1), to(0)):Play()"});
  EXPECT_NEAR(two.z(2), 20, 0.1);
  EXPECT_NEAR(two.z(3), 0, 0.1);
}

// The wait may be one for the end of the tween.
TEST(TweenReading, AfterAWaitOfUnknownTimeATweenIsOver) {
  const Overlap two(
      {"tween(even(2), to(20)):Play() task.wait(p.Seconds.Value)\n"
       "tween(even(1), {Position = p.Position + Vector3.new(0, 8, 0)}):Play()"});
  expectNear(two.motion().keys.back().pose.position, {0, 8, 20}, 0.1f);
}

// What each frame follows a swing goes with it.
TEST(TweenReading, APartMayFollowATweenFrameByFrame) {
  Scene scene;
  scene.part("Mover");
  const auto rider = scene.part("Rider", {0, 5, 0});
  scene.script(kBefore +
                   "tween(swing(2), to(20)):Play()\n"
                   "game:GetService('RunService').Heartbeat:Connect(function()\n"
                   "workspace.Rider.Position = p.Position + Vector3.new(0, 5, 0) end)",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[rider].motion);
  EXPECT_NEAR(scene[rider].motion->keys.back().time, 4, 0.05);
  expectNear(at(scene[rider], 1), {0, 5, 10}, 0.3f);
  expectNear(at(scene[rider], 2), {0, 5, 20}, 0.3f);
  expectNear(at(scene[rider], 3), {0, 5, 10}, 0.3f);
}

// That wait may be one for its end, too.
TEST(TweenReading, AfterAWaitForWhatItReachesATweenIsOver) {
  const Overlap two(
      {"tween(even(2), to(20)):Play() repeat task.wait() until p.Position.Z > 19\n"
       "tween(even(1), {Position = p.Position + Vector3.new(0, 8, 0)}):Play()"});
  expectNear(two.motion().keys.back().pose.position, {0, 8, 20}, 0.1f);
}

// A turn on the spot leaves it to the tweens where the part is.
TEST(TweenReading, ALoopMayTurnWhatAnotherLoopTweens) {
  const char* const turns[] = {
      "game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
      "p.CFrame = p.CFrame * CFrame.Angles(0, dt, 0) end)\n",
      "task.spawn(function() while true do\n"
      "p.Orientation = p.Orientation + Vector3.new(0, 3, 0) task.wait() end end)\n"};
  for (const char* turn : turns) {
    const Overlap both({std::string(turn) +
                        "while true do tween(even(2), to(20)):Play() task.wait(2)\n"
                        "tween(even(2), to(0)):Play() task.wait(2) end"});
    EXPECT_TRUE(both.motion().spin) << turn;
    EXPECT_NEAR(both.z(2), 20, 0.1) << turn;
    EXPECT_NEAR(both.z(3), 10, 0.1) << turn;
    EXPECT_EQ(both.scene.unmodelled("motion that a script computes"), 0u) << turn;
  }
}

// Two that set the same, and a loop whose rounds the reading does not follow.
TEST(TweenReading, WhatTheTextDoesNotTellIsNamed) {
  const char* const texts[] = {
      "tween(even(4), {CFrame = CFrame.new(0, 0, 9)}):Play() tween(even(4), to(40)):Play()\n"
      "task.wait(1) rider({Position = p.Position})",
      "task.spawn(function() task.wait(9) rider({Position = p.Position}) end)\n"
      "while true do tween(even(2), to(20)):Play() task.wait(2)\n"
      "tween(even(2), to(0)):Play() task.wait(2) end"};
  for (const char* text : texts) {
    Scene scene;
    scene.part("Mover");
    const auto rider = scene.part("Rider", {0, 5, 0});
    scene.script(kBefore +
                     "local function rider(goal)\n"
                     "ts:Create(workspace.Rider, even(1), goal):Play() end\n" +
                     text,
                 scene.scripts);
    scene.level();
    EXPECT_FALSE(scene[rider].motion) << text;
    EXPECT_EQ(scene.unmodelled("motion that a script computes"), 1u) << text;
  }
}

}  // namespace
}  // namespace obby::test
