// Handlers that scripts disconnect: what they did goes on in the level, which says so.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kEnded = "handler that a script disconnects";

TEST(EndedHandlers, WhatComesAtTheFirstTouchOnlyIsNamed) {
  const char* const touches[] = {
      "local c c = p.Touched:Connect(function(hit)\nc:Disconnect() p.CanCollide = false wait(3) "
      "p.CanCollide = true end)",
      "p.Touched:Once(function(hit)\np.CanCollide = false wait(3) p.CanCollide = true end)",
      "local c c = p.Touched:connect(function(hit)\nlocal h = "
      "hit.Parent:FindFirstChild('Humanoid') "
      "if h then h.Health = 0 c:disconnect() end end)",
      "local c = p.Touched:Connect(function(hit)\nhit.Velocity = Vector3.new(0, 90, 0) end) wait(9)"
      " c:Disconnect()"};
  for (const char* touch : touches) {
    ScriptedPart scene(touch);
    const PartDraft& pad = scene[scene.self];
    EXPECT_TRUE(pad.vanish || pad.kill || pad.jumpPad) << touch;
    ASSERT_EQ(scene.unmodelled(kEnded), 1u) << touch;
    const auto& entry = scene.level().unmodelled.at(kEnded);
    EXPECT_EQ(entry.example, "Workspace/Pad") << touch;
    EXPECT_NE(entry.note.find("script Script line "), std::string::npos) << entry.note;
  }
}

TEST(EndedHandlers, WhatMayComeButOnceIsNotNamed) {
  const char* const touches[] = {
      "local c c = p.Touched:Connect(function() c:Disconnect() p.CanCollide = false end)",
      "local c c = p.Touched:Connect(function() c:Disconnect() p:Destroy() end)",
      "p.Touched:Once(function() p.Color = Color3.new(1, 0, 0) end)",
      "local c = p.Touched:Connect(function() p.CanCollide = false wait(3) p.CanCollide = true end)"
      " p.Destroying:Connect(function() c:Disconnect() end)",
      "local other = workspace.Changed:Connect(print) p.Touched:Connect(function() "
      "other:Disconnect() p.CanCollide = false wait(3) p.CanCollide = true end)"};
  for (const char* touch : touches) {
    ScriptedPart scene(touch);
    EXPECT_EQ(scene.unmodelled(kEnded), 0u) << touch;
  }
}

// As scripts keep a part from being touched again while it is away.
TEST(EndedHandlers, WhatIsConnectedAnewGoesOn) {
  const char* const touches[] = {
      "local c local function go() c:Disconnect() p.CanCollide = false wait(3)\n"
      "p.CanCollide = true c = p.Touched:Connect(go) end c = p.Touched:Connect(go)",
      "local function go() p.CanCollide = false wait(3) p.CanCollide = true\n"
      "p.Touched:Once(go) end p.Touched:Once(go)",
      "local function arm() local c c = p.Touched:Connect(function() c:Disconnect()\n"
      "p.CanCollide = false wait(3) p.CanCollide = true arm() end) end arm()"};
  for (const char* touch : touches) {
    ScriptedPart scene(touch);
    ASSERT_TRUE(scene[scene.self].vanish) << touch;
    EXPECT_NEAR(scene[scene.self].vanish->away, 3, 0.04) << touch;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << touch;
  }
}

TEST(EndedHandlers, AHandlerOfEachFrameEndsWhereItDisconnectsItself) {
  ScriptedPart scene(
      "local t, c = 0, nil\nc = game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
      "t = t + dt p.Position = Vector3.new(0, t * 4, 0)\nif t >= 2 then c:Disconnect() end end)");
  const PartDraft& pad = scene[scene.self];
  ASSERT_TRUE(pad.motion);
  EXPECT_EQ(pad.motion->repeat, importer::Repeat::once);
  EXPECT_NEAR(pad.motion->keys.back().time, 2, 0.06);
  expectNear(pad.motion->keys.back().pose.position, {0, 8, 0}, 0.1f);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(EndedHandlers, WhatComesAtOneFrameIsNoLoop) {
  ScriptedPart scene(
      "game:GetService('RunService').Heartbeat:Once(function()\n"
      "p.CFrame = p.CFrame * CFrame.Angles(0, 1, 0) end)");
  EXPECT_FALSE(scene[scene.self].motion);
}

// Whether the signal ever comes nobody knows.
TEST(EndedHandlers, WhatComesAtOneFrameAfterASignalIsNotDoneAtTheStart) {
  const std::string goes =
      "game:GetService('RunService').Heartbeat:Once(function() p:Destroy() end)";
  EXPECT_TRUE(ScriptedPart(goes).level().parts.empty());
  for (const char* signal : {"workspace.Changed", "game:GetService('RunService').Heartbeat"}) {
    ScriptedPart scene(std::string(signal) + ":Connect(function() " + goes + " end)");
    EXPECT_EQ(scene.level().parts.size(), 1u) << signal;
  }
}

TEST(EndedHandlers, AHandlerGoesOnUntilAThreadOfItsEndsIt) {
  for (const char* later : {"task.spawn(function() task.wait(5) c:Disconnect() end)",
                            "task.delay(5, function() c:Disconnect() end)"}) {
    ScriptedPart scene(
        "local started, c = false, nil\nc = "
        "game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
        "p.CFrame = p.CFrame * CFrame.Angles(0, dt, 0)\nif not started then started = true " +
        std::string(later) + " end end)");
    ASSERT_TRUE(scene[scene.self].motion) << later;
    EXPECT_TRUE(scene[scene.self].motion->spin) << later;
    EXPECT_EQ(scene.unmodelled(kEnded), 1u) << later;
  }
}

TEST(EndedHandlers, AMotionThatAnotherThreadEndsIsNamed) {
  const char* const ends[] = {"wait(5) c:Disconnect()",
                              "task.delay(5, function() c:Disconnect() end)",
                              "if math.random() > 0.5 then c:Disconnect() end"};
  for (const char* end : ends) {
    ScriptedPart scene(
        "local c = game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
        "p.CFrame = p.CFrame * CFrame.Angles(0, dt, 0) end)\n" +
        std::string(end));
    EXPECT_TRUE(scene[scene.self].motion) << end;
    EXPECT_EQ(scene.unmodelled(kEnded), 1u) << end;
  }
}

}  // namespace
}  // namespace obby::test
