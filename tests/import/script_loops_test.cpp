// Loops that end by their own effects, recursive functions, and lists and strings that scripts
// build. The importer also reads the code after these.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

TEST(ScriptLoops, CodeAfterATerminatingLoopIsRead) {
  struct Case {
    const char* text;
    float delay;
  };
  const Case cases[] = {
      {"local i = 0 repeat i = i + 1 p.Transparency = i / 10 wait(0.1) until i >= 10", 1},
      {"repeat p.Transparency = p.Transparency + 0.25 wait(0.5) until p.Transparency >= 1", 2},
      {"while p.Transparency < 1 do p.Transparency += 0.5 task.wait(1) end", 2},
      {"local n = 3 while n > 0 do n -= 1 p.Transparency = n wait(1) end", 3},
      {"local t = tick() while tick() - t < 1.8 do p.Transparency = 0.5 wait(0.5) end", 2},
      {"local n = 5 while true do n -= 1 wait(1) if n == 0 then break end end", 5},
      {"local n = 0 while wait(0.5) do n += 1 if n >= 4 then break end end", 2},
      {"while true do p.Transparency += 0.25 wait(0.5) if p.Transparency >= 1 then break end end",
       2}};
  for (const Case& now : cases) {
    Scene scene;
    const auto part = scene.part("Fading");
    scene.script(
        "local p, on = script.Parent, false\np.Touched:Connect(function()\n"
        "if on then return end on = true\n" +
            std::string(now.text) +
            "\np.CanCollide = false wait(3) p.CanCollide = true on = false end)",
        part);
    scene.level();
    ASSERT_TRUE(scene[part].vanish) << now.text;
    // Each wait may be up to 1/30 s too long.
    EXPECT_GE(scene[part].vanish->delay, now.delay - 0.04f) << now.text;
    EXPECT_LE(scene[part].vanish->delay, now.delay + 0.4f) << now.text;
    EXPECT_NEAR(scene[part].vanish->away, 3, 0.06) << now.text;
  }
}

TEST(ScriptLoops, EveryIterationOfACountingLoopRuns) {
  const char* const texts[] = {
      "local i = 1 while i <= #all do all[i].Touched:Connect(kill) i = i + 1 end",
      "local i = 0 repeat i += 1 all[i].Touched:Connect(kill) until i == #all",
      "local list = {} for i, v in pairs(all) do list[#list + 1] = v end "
      "for _, v in ipairs(list) do v.Touched:Connect(kill) end",
      "local list = {} list[1] = all[3] list[2] = all[1] list[1] = all[2] list[3] = all[3] "
      "for _, v in ipairs(list) do v.Touched:Connect(kill) end",
      "local list = {} for i = 1, 3 do table.insert(list, 1, all[i]) end "
      "for _, v in ipairs(list) do v.Touched:Connect(kill) end",
      "local list = {[1] = all[1], [2] = all[2], [3] = all[3]} "
      "for _, v in pairs(list) do v.Touched:Connect(kill) end",
      "for i = 1, 3 do workspace.Red:FindFirstChild(tostring(i)).Touched:Connect(kill) end",
      "for i = 1, 3 do workspace.Red['' .. i].Touched:Connect(kill) end",
      "for i = 1, 3 do pcall(function(v) v.Touched:Connect(kill) end, all[i]) end"};
  for (const char* text : texts) {
    Scene scene;
    const auto folder = scene.add("Folder", "Red", scene.workspace);
    const InstanceId parts[] = {scene.part("1", {}, folder), scene.part("2", {9, 0, 0}, folder),
                                scene.part("3", {18, 0, 0}, folder)};
    scene.script(
        "local function kill(h) h.Parent.Humanoid.Health = 0 end\n"
        "local all = workspace.Red:GetChildren()\n" +
            std::string(text),
        scene.scripts);
    scene.level();
    for (const InstanceId part : parts) EXPECT_TRUE(scene[part].kill) << part << ": " << text;
  }
}

TEST(ScriptLoops, RemovedFieldsAreNotIterated) {
  ScriptedPart scene(
      "local t = {a = 1, b = 2} t.a = nil t.b = nil for k, v in pairs(t) do p.CanCollide = false "
      "end");
  EXPECT_TRUE(scene[scene.self].solid);
}

TEST(ScriptLoops, InsertedElementsKeepTheirPositions) {
  ScriptedPart scene(
      "local list = {5, 9} table.insert(list, 2, 7) table.insert(list, 1, 3) "
      "table.insert(list, 11) p.Position = Vector3.new(list[1], list[3], list[5])");
  expectNear(scene[scene.self].pose.position, {3, 7, 11});
}

TEST(ScriptLoops, ConditionalLoopsBackAndForthAreAMotion) {
  Scene scene;
  const auto lift = scene.part("Lift");
  scene.script(R"(local p = script.Parent
while true do
  while p.Position.Y < 10 do p.Position = p.Position + Vector3.new(0, 0.5, 0) task.wait() end
  while p.Position.Y > 0 do p.Position = p.Position - Vector3.new(0, 0.5, 0) task.wait() end
end)",
               lift);
  scene.level();
  ASSERT_TRUE(scene[lift].motion);
  EXPECT_EQ(scene.evidence(lift, "motion").rfind("script", 0), 0u);
  EXPECT_NEAR(scene[lift].motion->keys.back().time, 40 / 60.0, 0.05);
  expectNear(poseAt(scene[lift], 1 / 3.0).position, {0, 10, 0}, 0.6f);
}

TEST(ScriptLoops, AnEndlesslyRecursiveFunctionIsALoop) {
  Scene scene;
  const auto lift = scene.part("Lift");
  scene.script(R"(local ts = game:GetService("TweenService")
local there = ts:Create(script.Parent, TweenInfo.new(2), {Position = Vector3.new(0, 8, 0)})
local back = ts:Create(script.Parent, TweenInfo.new(4), {Position = Vector3.new(0, 0, 0)})
local function go()
  there:Play() there.Completed:Wait()
  back:Play() back.Completed:Wait()
  go()
end
task.wait(1)
go())",
               lift);
  scene.level();
  ASSERT_TRUE(scene[lift].motion);
  EXPECT_NEAR(scene[lift].motion->keys.back().time, 6, 0.05);
  for (const auto& [time, y] : {std::pair(2, 6), {3, 8}, {5, 2}, {7, 0}, {8, 6}})
    EXPECT_NEAR(poseAt(scene[lift], time).position.y, float(y), 0.25) << time;
}

TEST(ScriptLoops, RecursionOverChildrenIsNotALoop) {
  Scene scene;
  const auto inner = scene.add("Folder", "Inner", scene.add("Folder", "Outer", scene.workspace));
  const auto part = scene.part("Part", {}, inner);
  scene.script(R"(local function visit(it)
  wait(0.1)
  if it:IsA("BasePart") then it.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end) end
  for _, child in it:GetChildren() do visit(child) end
end
visit(workspace.Outer))",
               scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[part].kill);
}

TEST(ScriptLoops, ChangingVelocitiesAreReported) {
  const char* const texts[] = {
      "p.Velocity = Vector3.new(9, 0, 0) wait(5) p.Velocity = Vector3.new(-9, 0, 0)",
      "while true do p.Velocity = Vector3.new(9, 0, 0) wait(3) p.Velocity = Vector3.new(0, 0, 0) "
      "wait(3) end",
      "p.Velocity = Vector3.new(9, 0, 0) p.Touched:Connect(function() "
      "p.Velocity = Vector3.new(0, 0, 0) end)"};
  for (const char* text : texts) {
    Scene scene;
    const auto part = scene.part("Belt");
    scene.script("local p = script.Parent " + std::string(text), part);
    scene.level();
    ASSERT_TRUE(scene[part].conveyor) << text;
    EXPECT_EQ(scene[part].conveyor->velocity, (Vec3{9, 0, 0})) << text;
    EXPECT_EQ(scene.unmodelled("conveyor that a script changes") +
                  scene.unmodelled("conveyor that a touch changes"),
              1u)
        << text;
  }
}

// The handler acts every half second, as with `if passed < 0.5 then return end`.
TEST(ScriptLoops, AHandlerThatReturnsEarlyIsCalledAgain) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "local p, passed = script.Parent, 0\n"
      "game:GetService('RunService').Heartbeat:Connect(function(step)\n"
      " passed = passed + step\n"
      " if passed < 0.5 then return end\n"
      " passed = 0\n"
      " p.Position = Vector3.new(0, p.Position.Y > 1 and 0 or 8, 0)\n"
      "end)",
      part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  EXPECT_NEAR(scene[part].motion->keys.back().time, 1, 0.1);
  EXPECT_NEAR(poseAt(scene[part], 0.3).position.y, 0, 0.1);
  EXPECT_NEAR(poseAt(scene[part], 0.8).position.y, 8, 0.1);
}

// Stepped passes the time and the duration of the last frame to its handlers.
TEST(ScriptLoops, AStepHandlerReceivesTheClock) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "local p = script.Parent\n"
      "game:GetService('RunService').Stepped:Connect(function(now, step)\n"
      " p.Position = Vector3.new(0, 5 * math.sin(now), 0)\n"
      "end)",
      part);
  scene.level();
  ASSERT_TRUE(scene[part].motion);
  EXPECT_NEAR(poseAt(scene[part], 1.57).position.y, 5, 0.2);
  EXPECT_NEAR(poseAt(scene[part], 4.71).position.y, -5, 0.2);
}

TEST(ScriptLoops, HandlersThatDoNothingCostLittle) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "local p, on, run = script.Parent, false, game:GetService('RunService')\n"
      "for i = 1, 200 do run.Heartbeat:Connect(function() if not on then return end end) end\n"
      "run.Heartbeat:Connect(function(step) p.CFrame = p.CFrame * CFrame.Angles(0, step, 0) end)",
      part);
  scene.level();
  EXPECT_TRUE(scene[part].motion);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(ScriptLoops, ATouchCanStartAPerFrameEffect) {
  for (const char* signal : {"Touched", "ClickDetector.MouseClick"}) {
    Scene scene;
    const auto part = scene.part("Part", {20, 0, 0});
    scene.add("ClickDetector", "ClickDetector", part);
    scene.script("local p, on = script.Parent, false\np." + std::string(signal) +
                     ":Connect(function()\n"
                     " if on then return end on = true\n"
                     " game:GetService('RunService').Heartbeat:Connect(function(step)\n"
                     "  p.CFrame = p.CFrame * CFrame.Angles(0, step, 0) end) end)",
                 part);
    scene.level();
    ASSERT_TRUE(scene[part].motion) << signal;
    ASSERT_TRUE(scene[part].motion->spin) << signal;
    EXPECT_NEAR(scene[part].motion->spin->speed, 1, 1e-3) << signal;
    EXPECT_NE(scene[part].motion->trigger, importer::MotionTrigger::always) << signal;
  }
}

TEST(ScriptLoops, CodeAfterAnEndlessWaitNeverRuns) {
  const char* const waits[] = {
      "while true do wait() if workspace:FindFirstChild('Ready') then break end end",
      "while true do wait() if _G.ready then break end end",
      "local function ready() while true do wait() if _G.ready then return end end end ready()"};
  for (const char* text : waits) {
    ScriptedPart kills(std::string(text) +
                       " p.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)");
    EXPECT_FALSE(kills[kills.self].kill) << text;
    ScriptedPart opens("p.Touched:Connect(function() " + std::string(text) +
                       " p.CanCollide = false wait(3) p.CanCollide = true end)");
    EXPECT_FALSE(opens[opens.self].vanish) << text;
  }
  ScriptedPart ever(
      "while true do wait() end p.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)");
  EXPECT_FALSE(ever[ever.self].kill);
}

TEST(ScriptLoops, ALoopThatReturnsIsNotEndless) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "local p = script.Parent\n"
      "local function rise()\n"
      " local n = 0\n"
      " while true do n = n + 1 p.Position = Vector3.new(0, n * 4, 0) task.wait(1)\n"
      "  if n > 1 then return end\n"
      " end\n"
      "end\n"
      "rise()",
      part);
  scene.level();
  EXPECT_FALSE(scene[part].motion);
  EXPECT_EQ(scene[part].pose.position, (Vec3{0, 8, 0}));
}

}  // namespace
}  // namespace obby::test
