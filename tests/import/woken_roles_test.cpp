// What scripts do that the file has disabled and that another script enables: guesses, and the
// level says so.
#include <string>

#include "import/woken_scene.h"

namespace obby::test {
namespace {

const char* const kEnabled = "script that another script enables";
const std::string kSwings =
    "local info = TweenInfo.new(2, Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1, true)\n"
    "game:GetService('TweenService'):Create(script.Parent, info, {Position = "
    "Vector3.new(9, 9, 0)}):Play()";

TEST(WokenRoles, HarmByTheContentsOfAPart) {
  for (const std::string& way : {kOn, pulled(kOn)}) {
    Sleeping scene(
        "while true do for _, part in workspace:GetPartsInPart(script.Parent) do\n"
        "local humanoid = part.Parent:FindFirstChild('Humanoid')\n"
        "if humanoid then humanoid:TakeDamage(5) end end task.wait(0.5) end");
    scene.run(way);
    scene.level();
    ASSERT_TRUE(scene[scene.trap].kill) << way;
    EXPECT_FLOAT_EQ(scene[scene.trap].kill->damage, 5) << way;
    EXPECT_TRUE(scene.isGuessed("kill")) << way;
    EXPECT_EQ(scene.unmodelled(kMayHarm), 1u) << way;
  }
}

TEST(WokenRoles, HarmByNoPartIsNamed) {
  const std::string hurts =
      "for _, player in game.Players:GetPlayers() do "
      "player.Character.Humanoid:TakeDamage(10) end end";
  for (const std::string& head :
       {std::string("while wait(1) do "),
        std::string("game:GetService('RunService').Heartbeat:Connect(function() ")})
    for (const std::string& way : {kOn, pulled(kOn)}) {
      const bool frame = head[0] == 'g';
      Sleeping scene(head + hurts + (frame ? ")" : ""));
      scene.run(way);
      scene.level();
      EXPECT_EQ(scene.unmodelled("damage by an unknown part"), 1u) << head << way;
    }
}

TEST(WokenRoles, AWokenScriptMayBeTheLeverOfATrap) {
  Sleeping scene("script.Parent.On.Value = true");
  scene.value("BoolValue", "On", false, scene.trap);
  scene.run(pulled(kOn));
  scene.run(
      "trap.Touched:Connect(function(hit) if trap.On.Value then "
      "hit.Parent.Humanoid.Health = 0 end end)",
      "Asks");
  scene.level();
  EXPECT_TRUE(scene[scene.trap].kill);
  EXPECT_EQ(scene.unmodelled(kMayHarm), 1u);
}

TEST(WokenRoles, AMotionFromTheStartIsAGuess) {
  for (const std::string& before : {std::string(), pulled(kOn)}) {
    Sleeping scene(kSwings);
    if (!before.empty()) scene.run(before, "First");
    scene.run("wait(3) " + kOn);
    scene.level();
    ASSERT_TRUE(scene[scene.trap].motion) << before;
    EXPECT_TRUE(scene.isGuessed("motion")) << before;
    ASSERT_EQ(scene.unmodelled(kEnabled), 1u) << before;
    const auto& entry = scene.level().unmodelled.at(kEnabled);
    EXPECT_EQ(entry.example, "Workspace/Trap");
    EXPECT_NE(entry.note.find("script Enabler line 1"), std::string::npos) << entry.note;
  }
}

TEST(WokenRoles, AMotionThatATouchWakesBeginsWithIt) {
  for (const bool link : {false, true}) {
    Sleeping scene(kSwings);
    if (link) scene.sleeps(kOn, "Link");
    scene.run(pulled(link ? "script.Parent.Link.Enabled = true " : kOn));
    scene.level();
    ASSERT_TRUE(scene[scene.trap].motion) << link;
    EXPECT_EQ(scene[scene.trap].motion->trigger, importer::MotionTrigger::signal) << link;
    EXPECT_TRUE(scene[scene.lever].button) << link;
    EXPECT_EQ(scene.unmodelled(kEnabled), 0u) << link;
  }
}

TEST(WokenRoles, ATimerIsAGuessOrAButton) {
  for (const bool touch : {false, true}) {
    Sleeping scene(
        "while true do script.Parent.CanCollide = false wait(2) "
        "script.Parent.CanCollide = true wait(2) end");
    scene.run(touch ? pulled(kOn) : kOn);
    scene.level();
    EXPECT_EQ(scene[scene.trap].vanish.has_value(), !touch);
    EXPECT_EQ(scene.isGuessed("vanish"), !touch);
    EXPECT_EQ(scene.unmodelled(kEnabled), touch ? 0u : 1u);
    EXPECT_EQ(scene.unmodelled("button"), touch ? 1u : 0u);
  }
}

TEST(WokenRoles, WhatItChangesAsItBeginsIsNamed) {
  Sleeping scene("script.Parent.CanCollide = false");
  scene.run(kOn);
  scene.level();
  EXPECT_TRUE(scene[scene.trap].solid);
  EXPECT_EQ(scene.unmodelled("part that a script may change"), 1u);
  EXPECT_EQ(scene.unmodelled(kEnabled), 0u);
}

TEST(WokenRoles, OtherTouchesAreGuesses) {
  const std::string touched = "local p = script.Parent p.Touched:Connect(function(hit) ";
  Sleeping pad(touched + "hit.Parent.HumanoidRootPart.Velocity = Vector3.new(0, 90, 0) end)");
  pad.run(pulled(kOn));
  pad.level();
  EXPECT_TRUE(pad[pad.trap].jumpPad);
  EXPECT_TRUE(pad.isGuessed("jumpPad"));
  EXPECT_EQ(pad.unmodelled("handler that a script may connect"), 1u);
  Sleeping checkpoint(touched + "_G.player.RespawnLocation = p end)");
  checkpoint.run(kOn);
  checkpoint.level();
  EXPECT_TRUE(checkpoint.isGuessed("checkpoint"));
}

// Whatever comes first in the file.
TEST(WokenRoles, WhatIsCertainComesBeforeTheirGuesses) {
  const std::string touched = "local p = script.Parent p.Touched:Connect(function() ";
  Sleeping vanishing(touched + "p.CanCollide = false end)");
  vanishing.run(kOn);
  vanishing.script(
      "local p = script.Parent while true do p.CanCollide = false wait(2) "
      "p.CanCollide = true wait(2) end",
      vanishing.trap, "Clock");
  vanishing.level();
  EXPECT_EQ(vanishing.evidence(vanishing.trap, "vanish").rfind("script Clock line 1", 0), 0u);

  Sleeping moving(kSwings);
  moving.run(kOn);
  moving.script(
      "local p = script.Parent for i = 1, 10 do p.Position = Vector3.new(9, i, 0) "
      "task.wait(0.1) end",
      moving.trap, "Steps");
  moving.level();
  EXPECT_EQ(moving.evidence(moving.trap, "motion").rfind("script Steps line 1", 0), 0u);
  EXPECT_EQ(moving.unmodelled("part that two scripts move"), 1u);

  Sleeping killing(touched + "_G.player.RespawnLocation = p end)");
  killing.run(kOn);
  killing.script(kKills, killing.trap, "Live");
  killing.level();
  EXPECT_EQ(killing.evidence(killing.trap, "kill").rfind("script Live line 2", 0), 0u);
  EXPECT_FALSE(killing[killing.trap].checkpoint);

  const std::string throws =
      "script.Parent.Touched:Connect(function(hit) "
      "hit.Parent.HumanoidRootPart.Velocity = Vector3.new(0, ";
  Sleeping throwing(throws + "90, 0) end)");
  throwing.run(kOn);
  throwing.script(throws + "50, 0) end)", throwing.trap, "Live");
  throwing.level();
  EXPECT_EQ(throwing.evidence(throwing.trap, "jumpPad").rfind("script Live line 1", 0), 0u);
}

TEST(WokenRoles, TheirCheckpointsLeaveThoseOfNames) {
  Sleeping scene(
      "local p = script.Parent p.Touched:Connect(function() _G.player.RespawnLocation = p end)");
  scene.run(kOn);
  const InstanceId called = scene.part("Checkpoint 2", {20, 0, 0});
  scene.level();
  EXPECT_TRUE(scene.isGuessed("checkpoint"));
  EXPECT_EQ(scene.evidence(called, "checkpoint"), "guessed: name Checkpoint 2");
}

}  // namespace
}  // namespace obby::test
