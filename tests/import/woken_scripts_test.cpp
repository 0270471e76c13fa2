// Scripts that the file has disabled and that another script enables: what they do is a guess, and
// the level says so.
#include <string>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kMayHarm = "harm that a script may do";
const char* const kEnabled = "script that another one enables";
const char* const kByTouch = "motion that a touch or click starts";
const std::string kKills =
    "script.Parent.Touched:Connect(function(hit)\nhit.Parent.Humanoid.Health = 0 end)";
const std::string kOn = "trap.Kill.Disabled = false ";
const std::string kSwings =
    "local info = TweenInfo.new(2, Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1, true)\n"
    "game:GetService('TweenService'):Create(script.Parent, info, {Position = "
    "Vector3.new(9, 9, 0)}):Play()";

std::string pulled(const std::string& body) {
  return "lever.Touched:Connect(function() " + body + "end)";
}

// A trap with a disabled script `Kill`; other scripts call the parts `lever` and `trap`.
struct Sleeping : Scene {
  explicit Sleeping(const std::string& text = kKills) : kill(script(text, trap, "Kill")) {
    set(kill, "Disabled", true);
  }
  InstanceId run(const std::string& text, const std::string& name = "Enabler") {
    return script("local lever, trap = workspace.Lever, workspace.Trap " + text, scripts, name);
  }
  void sleeps(const std::string& text, const std::string& name) {
    set(run(text, name), "Disabled", true);
  }
  bool isGuessed(const std::string& role) const {
    return evidence(trap, role).rfind("guessed: script Kill line ", 0) == 0;
  }

  const InstanceId lever = part("Lever"), trap = part("Trap", {9, 0, 0});
  const InstanceId kill;
};

void expectGuess(Sleeping& scene, const std::string& what) {
  scene.level();
  EXPECT_FALSE(scene[scene.lever].kill) << what;
  ASSERT_TRUE(scene[scene.trap].kill) << what;
  EXPECT_GE(scene[scene.trap].kill->damage, 100) << what;
  EXPECT_TRUE(scene.isGuessed("kill")) << what;
  ASSERT_EQ(scene.level().unmodelled.size(), 1u) << what;
  ASSERT_EQ(scene.unmodelled(kMayHarm), 1u) << what;
  const auto& entry = scene.level().unmodelled.at(kMayHarm);
  EXPECT_EQ(entry.example, "Workspace/Trap") << what;
  EXPECT_NE(entry.note.find("script Kill line 2"), std::string::npos) << entry.note;
}

void expectNothing(Sleeping& scene, const std::string& what) {
  EXPECT_TRUE(scene.level().unmodelled.empty()) << what;
  EXPECT_FALSE(scene[scene.trap].kill) << what;
}

TEST(WokenScripts, AnotherScriptWakesATrap) {
  const std::string ways[] = {
      kOn,
      "trap.Kill.Enabled = true",
      "wait(5) " + kOn,
      "if math.random() > 0.5 then " + kOn + "end",
      pulled(kOn),
      pulled("wait(1) trap.Kill.Enabled = true "),
      "game.Players.PlayerAdded:Connect(function() " + kOn + "end)",
      "while true do " + kOn + "wait(2) trap.Kill.Disabled = true wait(2) end",
      "trap.Kill.Disabled = not trap.Kill.Disabled",
      "trap.Kill.Enabled = not trap.Kill.Enabled",
      "trap:FindFirstChild('Kill').Disabled = _G.off",
      "for _, s in workspace:GetDescendants() do if s:IsA('Script') then s.Disabled = false end "
      "end",
      "for _, s in pairs(trap:GetChildren()) do if s.ClassName == 'Script' then s.Enabled = true "
      "end end"};
  for (const std::string& way : ways) {
    Sleeping scene;
    scene.run(way);
    expectGuess(scene, way);
  }
}

TEST(WokenScripts, EnabledIsDisabledTheOtherWayRound) {
  for (const bool enabled : {false, true}) {
    Sleeping scene;
    scene.set(scene.kill, "Disabled", false);
    scene.set(scene.kill, "Enabled", false);
    scene.run(enabled ? "trap.Kill.Enabled = true" : kOn);
    expectGuess(scene, enabled ? "Enabled" : "Disabled");
  }
}

TEST(WokenScripts, WhatNoneEnablesSleepsOn) {
  const std::string ways[] = {"print(trap.Kill.Disabled)",
                              "trap.Kill.Disabled = true",
                              "trap.Kill.Enabled = false",
                              "trap.Other.Disabled = false",
                              "lever.Disabled = false",
                              "if false then " + kOn + "end",
                              pulled("trap.Kill.Disabled = true "),
                              "local k = trap.Kill:Clone() k.Disabled = false k.Parent = lever"};
  for (const std::string& way : ways) {
    Sleeping scene;
    scene.run(way);
    expectNothing(scene, way);
  }
  Sleeping itself("script.Disabled = false " + kKills);
  expectNothing(itself, "itself");
}

TEST(WokenScripts, WhatIsStoredSleepsOn) {
  Sleeping scene;
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  scene.set(scene.script("workspace.Trap.Touched:Connect(function(hit) "
                         "hit.Parent.Humanoid.Health = 0 end)",
                         storage, "Stored"),
            "Disabled", true);
  scene.run("game:GetService('ServerStorage').Stored.Disabled = false");
  expectNothing(scene, "stored");
}

// Against the order of the file.
TEST(WokenScripts, OneWakesTheOther) {
  constexpr int kLinks = 20;
  Sleeping scene;
  for (int i = 0; i < kLinks; ++i) {
    const std::string next = "script.Parent.Link" + std::to_string(i - 1) + ".Disabled = false";
    scene.sleeps(i == 0 ? kOn : next, "Link" + std::to_string(i));
  }
  scene.run("script.Parent.Link19.Enabled = true");
  expectGuess(scene, "a chain");
}

TEST(WokenScripts, ThoseThatWakeEachOtherAloneSleepOn) {
  Sleeping scene;
  scene.sleeps(kOn + "script.Parent.B.Disabled = false", "A");
  scene.sleeps(kOn + "script.Parent.A.Disabled = false", "B");
  expectNothing(scene, "a ring");
}

// The server finds nothing of what a client sets; a client finds what the server sets.
TEST(WokenScripts, AClientWakesOnlyClients) {
  for (const bool enabler : {false, true})
    for (const bool trap : {false, true}) {
      Sleeping scene("print(script)");
      const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
      const auto client = scene.add("StarterPlayerScripts", "StarterPlayerScripts", player);
      const auto add = [&](bool ofClient, const char* name, const std::string& text) {
        const auto id =
            scene.add(ofClient ? "LocalScript" : "Script", name, ofClient ? client : scene.scripts);
        scene.set(id, "Source", text);
        return id;
      };
      const std::string kills =
          "workspace.Trap.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end)";
      scene.set(add(trap, "Sleeper", kills), "Disabled", true);
      const std::string from = trap ? "game:GetService('StarterPlayer').StarterPlayerScripts"
                                    : "game:GetService('ServerScriptService')";
      add(enabler, "Enabler", from + ".Sleeper.Disabled = false");
      scene.level();
      const bool wakes = trap || !enabler;
      EXPECT_EQ(scene[scene.trap].kill.has_value(), wakes) << enabler << trap;
      EXPECT_EQ(scene.unmodelled(kMayHarm), wakes ? 1u : 0u) << enabler << trap;
    }
}

TEST(WokenScripts, WhatSurelyKillsStaysCertain) {
  Sleeping scene;
  scene.run(kOn + "trap.Live.Disabled = true");
  scene.script(kKills, scene.trap, "Live");
  scene.level();
  ASSERT_TRUE(scene[scene.trap].kill);
  EXPECT_EQ(scene.evidence(scene.trap, "kill").rfind("script Live line 2", 0), 0u);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(WokenScripts, HarmByTheContentsOfAPart) {
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

TEST(WokenScripts, HarmByNoPartIsNamed) {
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
      EXPECT_EQ(scene.unmodelled("harm of a part that is not known"), 1u) << head << way;
    }
}

TEST(WokenScripts, AWokenScriptMayBeTheLeverOfATrap) {
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

TEST(WokenScripts, AMotionFromTheStartIsAGuess) {
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

TEST(WokenScripts, AMotionThatATouchWakesIsNamed) {
  for (const bool link : {false, true}) {
    Sleeping scene(kSwings);
    if (link) scene.sleeps(kOn, "Link");
    scene.run(pulled(link ? "script.Parent.Link.Enabled = true " : kOn));
    scene.level();
    EXPECT_FALSE(scene[scene.trap].motion) << link;
    EXPECT_EQ(scene.unmodelled(kByTouch), 1u) << link;
    EXPECT_EQ(scene.unmodelled(kEnabled), 0u) << link;
  }
}

TEST(WokenScripts, ATimerIsAGuessOrAButton) {
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

TEST(WokenScripts, WhatItChangesAsItBeginsIsNamed) {
  Sleeping scene("script.Parent.CanCollide = false");
  scene.run(kOn);
  scene.level();
  EXPECT_TRUE(scene[scene.trap].solid);
  EXPECT_EQ(scene.unmodelled("part that a script may change"), 1u);
  EXPECT_EQ(scene.unmodelled(kEnabled), 0u);
}

TEST(WokenScripts, OtherTouchesAreGuesses) {
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
TEST(WokenScripts, WhatIsCertainComesBeforeTheirGuesses) {
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
}

TEST(WokenScripts, TheirCheckpointsLeaveThoseOfNames) {
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
