// Tweens of one part that overlap in time. A new tween of a property ends the previous one. Tweens
// of different properties run in parallel.
#include <string>
#include <utility>
#include <vector>

#include "import/tween_scene.h"

namespace obby::test {
namespace {

// Studs that a part moves in a few frames at 10 studs/s, since a script resumes up to two frames
// late.
constexpr float kTweenSlack = 0.5f;

struct OverlapCase {
  const char* text;
  std::vector<std::pair<double, float>> z;  // times and positions of the part
};

TEST(TweenOverlap, TweensOfOnePropertyEndEachOther) {
  const OverlapCase cases[] = {
      {"tween(even(4), to(40)):Play() task.wait(2) tween(even(2), to(0)):Play()",
       {{1, 10}, {2, 20}, {3, 10}, {4, 0}, {9, 0}}},
      {"tween(TweenInfo.new(2), to(16)):Play() task.wait(1) tween(even(1), to(0)):Play()",
       {{0.5, 7}, {1, 12}, {1.5, 6}, {2, 0}}},  // quad, out
      {"tween(even(2), to(90)):Play() tween(even(2), to(-10)):Play()", {{1, -5}, {2, -10}}},
      {"while true do tween(even(2), to(10)):Play() task.wait(1)\n"
       "tween(even(2), to(0)):Play() task.wait(1) end",
       {{20, 10 / 3.0f}, {20.5, 5}, {21, 20 / 3.0f}, {22, 10 / 3.0f}}},
      {"local t = tween(even(2), to(10)) t:Play() task.wait(1) t:Play()", {{1.5, 7.5}, {2, 10}}}};
  for (const OverlapCase& now : cases) {
    const Overlap both({now.text});
    for (const auto& [time, z] : now.z)
      EXPECT_NEAR(both.z(time), z, kTweenSlack) << now.text << " at " << time;
  }
}

TEST(TweenOverlap, PausedOrCancelledTweensStopMidway) {
  const OverlapCase cases[] = {
      {"local t = tween(even(4), to(40)) t:Play() task.wait(1) t:Cancel()", {{1, 10}, {4, 10}}},
      {"local t = tween(even(4), to(40)) t:Play() task.wait(1) t:Pause() task.wait(2) t:Play()",
       {{1, 10}, {3, 10}, {4, 20}, {6, 40}}},
      {"local t = tween(TweenInfo.new(2), to(16)) t:Play() task.wait(1) t:Pause()\n"
       "task.wait(1) t:Play()",
       {{2, 12}, {2.5, 15}, {3, 16}}},  // quad, out
      {"local t = tween(even(2), to(20)) t:Play() task.wait(1) t:Pause() t:Cancel()\n"
       "task.wait(1) t:Play()",
       {{2, 10}, {3, 15}, {4, 20}}},
      // Pause does nothing while a tween is delayed.
      {"local t = tween(TweenInfo.new(1, line, way, 0, false, 2), to(10)) t:Play()\n"
       "task.wait(1) t:Pause() task.wait(1) t:Play()",
       {{2, 0}, {2.5, 5}, {3, 10}}},
      {"local t = tween(swing(2), to(20))\n"
       "while true do t:Play() task.wait(2) t:Pause() task.wait(1) end",
       {{31, 10}, {32, 20}, {33, 20}, {34, 10}, {35, 0}, {36, 0}}}};
  for (const OverlapCase& now : cases) {
    const Overlap stops({now.text});
    for (const auto& [time, z] : now.z)
      EXPECT_NEAR(stops.z(time), z, kTweenSlack) << now.text << " at " << time;
  }
}

TEST(TweenOverlap, TweensOfDifferentPropertiesRunTogether) {
  const Overlap both(
      {"tween(even(4), to(40)):Play()\n"
       "tween(even(2), {Orientation = Vector3.new(0, 90, 0)}):Play()"});
  EXPECT_NEAR(both.z(1), 10, 0.1);
  EXPECT_NEAR(both.z(4), 40, 0.1);
  EXPECT_NEAR(both.yaw(1), 45, 1);
  EXPECT_NEAR(both.yaw(2), 90, 1);
  EXPECT_NEAR(both.yaw(4), 90, 1);
}

TEST(TweenOverlap, SwingsWithACommonPeriodAreOneMotion) {
  const Overlap both(
      {"tween(swing(2), to(20)):Play()\n"
       "tween(swing(1), {Orientation = Vector3.new(0, 60, 0)}):Play()"});
  EXPECT_NEAR(both.motion().keys.back().time, 4, 0.01);
  for (const double round : {0, 40}) {
    EXPECT_NEAR(both.z(round + 1), 10, 0.2);
    EXPECT_NEAR(both.z(round + 3), 10, 0.2);
    EXPECT_NEAR(both.yaw(round + 1), 60, 1.1);
    EXPECT_NEAR(both.yaw(round + 2), 0, 1.1);
  }
}

// A platform moves to and fro as it turns. Tweens or loops move it, in one script or two.
TEST(TweenOverlap, APlatformCanSwingAndTurn) {
  const std::string there = "tween(swing(2), to(20)):Play()\n";
  const std::string steps =
      "task.spawn(function() while true do tween(even(2), to(20)):Play() task.wait(2)\n"
      "tween(even(2), to(0)):Play() task.wait(2) end end)\n";
  struct Turn {
    std::string text;
    float speed;
  };
  const Turn turns[] = {
      {"tween(ever(4), {Orientation = Vector3.new(0, 360, 0)}):Play()\n", 1.5708f},
      {"task.spawn(function() while true do p.CFrame = p.CFrame * CFrame.Angles(0, 0.05, 0)\n"
       "task.wait() end end)\n",
       3},
      {"task.spawn(function() while true do p.Orientation = p.Orientation + Vector3.new(0, 3, 0)\n"
       "task.wait() end end)\n",
       3.1416f},
      {"task.spawn(function() while true do p.CFrame = p.CFrame * CFrame.Angles(0, 0.05, 0)\n"
       "wait() end end)\n",
       1.5f},
      {"game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
       "p.CFrame = p.CFrame * CFrame.Angles(0, dt, 0) end)\n",
       1}};
  for (const Turn& turn : turns) {
    const Overlap cases[] = {Overlap({there + turn.text}), Overlap({turn.text + there}),
                             Overlap({there, turn.text}), Overlap({turn.text + steps})};
    for (const Overlap& both : cases) {
      ASSERT_TRUE(both.motion().spin) << turn.text;
      EXPECT_NEAR(both.motion().spin->speed, turn.speed, 2e-3) << turn.text;
      expectNear(both.motion().spin->axis, {0, 1, 0});
      EXPECT_LE(both.motion().keys.size(), 8u);
      for (const double time : {1, 2, 3, 4, 39})
        EXPECT_NEAR(both.z(time), time == 2 ? 20 : time == 4 ? 0 : 10, kTweenSlack) << turn.text;
      EXPECT_TRUE(both.scene.unmodelled("motion without a period") == 0);
    }
  }
}

TEST(TweenOverlap, ATurnThatStartsLaterLags) {
  const Overlap both(
      {"tween(swing(2), to(20)):Play() task.wait(1)\n"
       "tween(ever(4), {Orientation = Vector3.new(0, 360, 0)}):Play()"});
  ASSERT_TRUE(both.motion().spin);
  EXPECT_NEAR(both.z(2), 20, 0.2);
  EXPECT_NEAR(both.yaw(1), 0, 3.1);
  EXPECT_NEAR(both.yaw(1.5), 45, 3.1);
  EXPECT_NEAR(both.yaw(42), 90, 3.1);
}

TEST(TweenOverlap, ALoopResetsThePartBeforeEachTween) {
  const char* const starts[] = {"while true do p.Position = Vector3.new(0, 0, -10)\n",
                                "p.Position = Vector3.new(0, 0, -10) local start = p.CFrame\n"
                                "while true do p.CFrame = start\n"};
  for (const char* start : starts) {
    const Overlap belt(
        {std::string(start) + "local t = tween(even(2), to(10)) t:Play() t.Completed:Wait() end"});
    EXPECT_NEAR(belt.motion().keys.back().time, 2, 0.02);
    EXPECT_NEAR(belt.z(0.5), -5, 0.2);
    EXPECT_NEAR(belt.z(1.5), 5, 0.2);
  }
}

TEST(TweenOverlap, ALoopThatWaitsFirstHasOnePeriod) {
  const Overlap swing(
      {"while true do task.wait(2) tween(even(2), to(20)):Play()\n"
       "task.wait(2) tween(even(2), to(0)):Play() end"});
  EXPECT_NEAR(swing.motion().keys.back().time, 4, 0.04);
  for (const auto& [time, z] : {std::pair(3, 10), {4, 20}, {5, 10}, {6, 0}})
    EXPECT_NEAR(swing.z(time), float(z), kTweenSlack) << time;
}

TEST(TweenOverlap, ALoopWithOtherChangesHasOnePeriod) {
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
  EXPECT_NEAR(scene[part].motion->keys.back().time, 5, 0.02);
  for (const auto& [time, z] : {std::pair(1.5, 20), {2.5, 10}, {4.0, 0}, {5.5, 10}})
    EXPECT_NEAR(poseAt(scene[part], time).position.z, float(z), 1) << time;
}

// Each new tween replaces the previous one after a single small step.
TEST(TweenOverlap, APartTweenedEveryFrameReachesItsTarget) {
  const Overlap there({"while true do tween(even(2), to(10)):Play() task.wait() end"});
  EXPECT_NEAR(there.z(2), 10 * (1 - std::exp(-1)), 0.3);
  EXPECT_NEAR(there.z(30), 10, 0.1);
}

TEST(TweenOverlap, APoseCanBeSetDuringAnEndlessTween) {
  const Overlap both({"tween(swing(2), to(20)):Play() p.Orientation = Vector3.new(0, 90, 0)"});
  for (const double time : {0, 2, 5}) EXPECT_NEAR(both.yaw(time), 90, 1);
  EXPECT_NEAR(both.z(2), 20, 0.2);
  EXPECT_NEAR(both.z(5), 10, 0.2);
}

// If a single turn happens during an endless swing, the part in the level is turned from the start.
TEST(TweenOverlap, ASingleTweenDuringASwingCountsAsDone) {
  const Overlap both(
      {"tween(swing(2), to(20)):Play()\n"
       "tween(even(4), {Orientation = Vector3.new(0, 90, 0)}):Play()"});
  for (const double time : {4, 30}) EXPECT_NEAR(both.yaw(time), 90, 1);
  EXPECT_NEAR(both.z(5), 10, 0.2);
}

TEST(TweenOverlap, SwingsWithoutACommonPeriodAreReported) {
  const Overlap both(
      {"tween(swing(2), to(20)):Play()\n"
       "tween(swing(1.37), {Orientation = Vector3.new(0, 60, 0)}):Play()"});
  EXPECT_FALSE(both.scene[both.part].motion);
  EXPECT_EQ(both.scene.unmodelled("motion without a period"), 1u);
}

// The later of two scripts wins, like the later of two tweens of one property.
TEST(TweenOverlap, TheLastOfTwoScriptsMovingAPartWins) {
  const Overlap both({"tween(swing(2), to(20)):Play()", "tween(swing(2), to(-5)):Play()"});
  EXPECT_NEAR(both.z(2), -5, 0.1);
  EXPECT_NEAR(both.z(4), 0, 0.1);
}

TEST(ScriptedStart, OneScriptCanMoveAPartThatAnotherTurns) {
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
