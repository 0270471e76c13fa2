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

}  // namespace
}  // namespace obby::test
