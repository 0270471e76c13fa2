// What handlers find in variables that other handlers, or endless loops, set.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const std::string kHandlerValuesKill = "hit.Parent.Humanoid.Health = 0 ";

// Two handlers of one script, in either order, and what is declared before them.
std::string inOrder(bool turned, const std::string& before, const std::string& a,
                    const std::string& b) {
  return before + "\n" + (turned ? b + "\n" + a : a + "\n" + b);
}

TEST(HandlerValues, WhatAnotherHandlerSetsMayBeEither) {
  struct Case {
    const char *before, *other, *touch;
  };
  const Case cases[] = {
      {"local dead = false", "dead = true", "if dead then return end "},
      {"local dead = false", "dead = true", "if not dead then "},
      {"local armed = false", "armed = true", "if armed then "},
      {"local armed", "armed = true", "if armed then "},
      {"local armed = false", "armed = not armed", "if armed then "},
      {"local mode = 'calm'", "mode = 'wild'", "if mode == 'wild' then "},
      {"local count = 0", "count += 1", "if count >= 3 then "},
      {"local state = {dead = false}", "state.dead = true", "if state.dead then return end "},
      {"local state = {}", "state.armed = true", "if state.armed then "},
      {"local state = {armed = false}", "state['armed'] = true", "if state.armed then "},
      {"local armed = false local function arm() armed = true end", "arm()", "if armed then "},
      {"local armed = false local function arm() armed = true end", "task.spawn(arm)",
       "if armed then "},
      {"local armed = false local function arm() armed = true end\n"
       "local function all() pcall(arm) end",
       "all()", "if armed then "}};
  for (const Case& now : cases)
    for (const bool turned : {false, true}) {
      const std::string touch(now.touch);
      const bool open = touch.find("return") == std::string::npos;
      ScriptedPart scene(
          inOrder(turned, now.before,
                  "workspace.Changed:Connect(function() " + std::string(now.other) + " end)",
                  "p.Touched:Connect(function(hit) " + touch + kHandlerValuesKill +
                      (open ? "end " : "") + "end)"));
      EXPECT_TRUE(scene[scene.self].kill) << now.before << ": " << now.touch << turned;
    }
}

TEST(HandlerValues, WhatAllHandlersSetAlikeIsKnown) {
  for (const bool turned : {false, true}) {
    ScriptedPart scene(inOrder(
        turned, "local armed = false", "workspace.Changed:Connect(function() armed = false end)",
        "p.Touched:Connect(function(hit) if armed then " + kHandlerValuesKill + "end end)"));
    EXPECT_FALSE(scene[scene.self].kill) << turned;
  }
}

TEST(HandlerValues, WhatAnEndlessLoopSetsToAndFroMayBeEither) {
  const std::string touch =
      "p.Touched:Connect(function(hit) if on then " + kHandlerValuesKill + "end end)\n";
  const std::string loop = "while true do on = true wait(1) on = false wait(1) end";
  const std::pair<std::string, bool> texts[] = {
      {touch + loop, true},
      {touch + "task.spawn(function() " + loop + " end)", true},
      {"local function flip() on = not on end\n" + touch + "while true do flip() wait(1) end",
       true},
      {touch + "while true do wait(1) on = false end", false}};
  for (const auto& [text, kills] : texts) {
    ScriptedPart scene("local on = false\n" + text);
    EXPECT_EQ(scene[scene.self].kill.has_value(), kills) << text;
  }
}

// In whatever order the parts come: one counter for all.
TEST(HandlerValues, ACounterOfManyPartsLeavesThemAlike) {
  for (const char* order : {"1, 3", "3, 1, -1"}) {
    Scene scene;
    const InstanceId pads[] = {scene.part("1"), scene.part("2", {9, 0, 0}),
                               scene.part("3", {18, 0, 0})};
    scene.script("local last = 0\nfor i = " + std::string(order) +
                     " do workspace[tostring(i)].Touched:Connect(function(hit)\n"
                     "if i == last + 1 then last = i " +
                     kHandlerValuesKill + "end end) end",
                 scene.scripts);
    scene.level();
    for (const InstanceId pad : pads) EXPECT_TRUE(scene[pad].kill) << order;
  }
}

TEST(HandlerValues, AHandlerOfEachFrameCountsByWhatItHasSetItself) {
  ScriptedPart scene(
      "local t = 0 game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
      "t = t + dt p.Position = Vector3.new(0, 5 * math.sin(t), 0) end)\n"
      "workspace.Changed:Connect(function() t = 1 end)");
  ASSERT_TRUE(scene[scene.self].motion);
  EXPECT_EQ(scene.unmodelled("motion that a script computes"), 0u);
}

TEST(HandlerValues, AHandlerOfEachFrameFindsTheNumbersOfTheOneThatMakesIt) {
  ScriptedPart scene(
      "local t, high = 0, 0 workspace.Changed:Connect(function() high = 5\n"
      "game:GetService('RunService').Heartbeat:Connect(function(dt)\n"
      "t = t + dt p.Position = Vector3.new(0, high * math.sin(t), 0) end) end)");
  ASSERT_TRUE(scene[scene.self].motion);
  EXPECT_NEAR(at(scene[scene.self], 1.57f).y, 5, 0.2);
  EXPECT_EQ(scene.unmodelled("motion that a script computes"), 0u);
}

TEST(HandlerValues, AHandlerFindsThePlaceThatTheOneThatMakesItHasSet) {
  ScriptedPart scene(
      "local place = CFrame.new(0, 9, 0) workspace.Changed:Connect(function()\n"
      "place = CFrame.new(0, 9, 50) p.Touched:Connect(function(hit)\n"
      "hit.Parent.HumanoidRootPart.CFrame = place end) end)");
  ASSERT_TRUE(scene[scene.self].teleport);
  EXPECT_NEAR(scene[scene.self].teleport->position.z, 50, 1e-3);
}

TEST(HandlerValues, WhatAHandlerDeclaresIsAsItLeavesIt) {
  ScriptedPart scene(
      "workspace.Changed:Connect(function() local seconds, state = 1, {back = false}\n"
      "seconds = 5 state.back = true p.Touched:Connect(function(hit) p.CanCollide = false\n"
      "if state.back then wait(seconds) p.CanCollide = true end end) end)");
  ASSERT_TRUE(scene[scene.self].vanish);
  EXPECT_NEAR(scene[scene.self].vanish->away, 5, 1e-3);
}

TEST(HandlerValues, WhatABranchDeclaresIsAsItLeavesIt) {
  ScriptedPart scene(
      "if _G.on then local seconds, state = 1, {} seconds = 5 state.back = true\n"
      "p.Touched:Connect(function(hit) p.CanCollide = false\n"
      "if state.back then wait(seconds) p.CanCollide = true end end) end");
  ASSERT_TRUE(scene[scene.self].vanish);
  EXPECT_NEAR(scene[scene.self].vanish->away, 5, 1e-3);
}

// As of two pads that send a player to each other.
TEST(HandlerValues, AFlagThatAllHandlersSetForATimeIsAsTheyLeaveIt) {
  const std::pair<std::string, bool> cases[] = {
      {"wait(1) busy = false ", false},
      {"task.delay(1, function() busy = false end) ", false},
      {"local t = game:GetService('TweenService'):Create(p, TweenInfo.new(1), {Transparency = 1})\n"
       "t.Completed:Connect(function() busy = false end) t:Play() ",
       false},
      {"if _G.over then return end busy = false ", true},
      {"if _G.over then busy = false end ", true},
      {"", true}};
  for (const auto& [back, guessed] : cases) {
    const std::string body =
        "(function(hit) if not busy then busy = true\n"
        "hit.Parent.HumanoidRootPart.CFrame = CFrame.new(0, 9, 0) " +
        back + "end end)\n";
    ScriptedPart scene("local busy = false p.Touched:Connect" + body + "workspace.Changed:Connect" +
                       body);
    ASSERT_TRUE(scene[scene.self].teleport) << back;
    EXPECT_EQ(scene.evidence(scene.self, "teleport").rfind("guessed: ", 0) == 0, guessed) << back;
  }
}

// The handler does not set it: it works while the other one has.
TEST(HandlerValues, AFlagThatAnotherHandlerSetsForATimeMayBeEither) {
  ScriptedPart scene(
      "local armed = false workspace.Changed:Connect(function() armed = true wait(3)\n"
      "armed = false end) p.Touched:Connect(function(hit) if armed then " +
      kHandlerValuesKill + "end end)");
  EXPECT_TRUE(scene[scene.self].kill);
}

TEST(HandlerValues, ALoopOfAHandlerCountsFromWhereTheScriptHasBegun) {
  const char* const loops[] = {"while fade < 10 do fade += 1 wait(0.1) end",
                               "repeat fade = fade + 1 wait(0.1) until fade >= 10"};
  for (const char* loop : loops) {
    ScriptedPart scene("local fade = 0 p.Touched:Connect(function(hit) " + std::string(loop) +
                       " p.CanCollide = false wait(3) p.CanCollide = true fade = 0 end)");
    ASSERT_TRUE(scene[scene.self].vanish) << loop;
    EXPECT_NEAR(scene[scene.self].vanish->delay, 1, 0.05) << loop;
  }
}

// It begins to turn at some time: as a guess it always does.
TEST(HandlerValues, AThreadMayFindWhatAHandlerSets) {
  ScriptedPart scene(
      "local on = false workspace.Changed:Connect(function() on = true end)\n"
      "task.spawn(function() while true do\n"
      "if on then p.CFrame = p.CFrame * CFrame.Angles(0, 0.1, 0) end task.wait() end end)");
  ASSERT_TRUE(scene[scene.self].motion);
  EXPECT_EQ(scene.evidence(scene.self, "motion").rfind("guessed: ", 0), 0u);
}

// A list may be full by then, and a trap's material another one.
TEST(HandlerValues, WhatTurnsBetweenTouchesIsNotKnown) {
  const char* const kills[] = {
      "local active = {} p.Touched:Connect(function(hit) if table.find(active, p) then\n"
      "hit.Parent.Humanoid.Health = 0 end end)\n"
      "workspace.Changed:Connect(function() table.insert(active, p) end)",
      "p.Touched:Connect(function(hit) if p.Material == Enum.Material.Neon then\n"
      "hit.Parent.Humanoid.Health = 0 end end)"};
  for (const char* text : kills) {
    ScriptedPart scene(text);
    EXPECT_TRUE(scene[scene.self].kill) << text;
  }
}

TEST(HandlerValues, AThrowOfUnknownHeightIsNamed) {
  const std::string throws =
      "p.Touched:Connect(function(hit)\n"
      "hit.Parent.HumanoidRootPart.AssemblyLinearVelocity = Vector3.new(0, power, 0) end)";
  ScriptedPart known("local power = 90 " + throws);
  EXPECT_TRUE(known[known.self].jumpPad);
  EXPECT_EQ(known.unmodelled("push that a script computes"), 0u);
  ScriptedPart turns(
      "local power = 90 workspace.Changed:Connect(function() power = _G.power end) " + throws);
  EXPECT_FALSE(turns[turns.self].jumpPad);
  EXPECT_EQ(turns.unmodelled("push that a script computes"), 1u);
}

// The handler of the first touch makes the connection that the second one ends.
TEST(HandlerValues, AThingThatAHandlerMakesIsThereForOthers) {
  ScriptedPart scene(
      "local c\nworkspace.Changed:Connect(function()\n"
      "c = p.Touched:Connect(function(hit) p.CanCollide = false wait(3) p.CanCollide = true end)\n"
      "end)\nworkspace.ChildAdded:Connect(function() c:Disconnect() end)");
  EXPECT_EQ(scene.unmodelled("handler that a script disconnects"), 1u);
}

}  // namespace
}  // namespace obby::test
