// Which scripts that the file has disabled run all the same: those that another script enables.
// What they do is in woken_roles_test.cpp.
#include <string>

#include "import/woken_scene.h"

namespace obby::test {
namespace {

void wokenScriptsExpectGuess(Sleeping& scene, const std::string& what) {
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

void expectWoken(Sleeping& scene, const std::string& what) {
  scene.level();
  EXPECT_FALSE(scene[scene.lever].kill) << what;
  ASSERT_TRUE(scene[scene.trap].kill) << what;
  EXPECT_GE(scene[scene.trap].kill->damage, 100) << what;
  EXPECT_EQ(scene.evidence(scene.trap, "kill").rfind("script Kill line 2", 0), 0u) << what;
}

void expectNothing(Sleeping& scene, const std::string& what) {
  scene.level();
  EXPECT_FALSE(scene[scene.trap].kill) << what;
}

TEST(WokenScripts, AnotherScriptWakesATrap) {
  const std::string ways[] = {
      kOn,
      "trap.Kill.Enabled = true",
      "game.Players.PlayerAdded:Connect(function() " + kOn + "end)",
      "trap.Kill.Disabled = not trap.Kill.Disabled",
      "trap.Kill.Enabled = not trap.Kill.Enabled",
      "trap:FindFirstChild('Kill').Disabled = false",
      "for _, s in workspace:GetDescendants() do if s:IsA('Script') then s.Disabled = false end "
      "end",
      "for _, s in pairs(trap:GetChildren()) do if s.ClassName == 'Script' then s.Enabled = true "
      "end end"};
  for (const std::string& way : ways) {
    Sleeping scene;
    scene.run(way);
    expectWoken(scene, way);
  }
}

TEST(WokenScripts, EnabledIsDisabledTheOtherWayRound) {
  for (const bool enabled : {false, true}) {
    Sleeping scene;
    scene.set(scene.kill, "Disabled", false);
    scene.set(scene.kill, "Enabled", false);
    scene.run(enabled ? "trap.Kill.Enabled = true" : kOn);
    expectWoken(scene, enabled ? "Enabled" : "Disabled");
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
  wokenScriptsExpectGuess(scene, "a chain");
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

TEST(WokenScripts, OneTrapMayRunInPlaceOfTheOther) {
  Sleeping scene;
  scene.run(kOn + "trap.Live.Disabled = true");
  scene.script(kKills, scene.trap, "Live");
  scene.level();
  ASSERT_TRUE(scene[scene.trap].kill);
  EXPECT_EQ(scene.evidence(scene.trap, "kill").rfind("script Kill line 2", 0), 0u);
}

}  // namespace
}  // namespace obby::test
