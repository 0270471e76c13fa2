// Scripts that are disabled in the file and that other scripts enable.
#include <string>

#include "import/lever_scene.h"

namespace obby::test {
namespace {

const std::string kDisabledKills =
    "script.Parent.Touched:Connect(function(hit)\nhit.Parent.Humanoid.Health = 0 end)";
const std::string kDisabledOn = "p.Kill.Disabled = false ";

// The trap has a disabled script `Kill`.
struct Disabled : LeverScene {
  explicit Disabled(const std::string& text = kDisabledKills, const char* property = "Disabled")
      : kill(script(text, trap, "Kill")) {
    set(kill, property, property == std::string("Disabled"));
  }
  const InstanceId kill;
};

TEST(DisabledScripts, RunOnceAnotherScriptEnablesThem) {
  const std::string scripts[] = {
      kDisabledOn,
      "p.Kill.Enabled = true",
      "game.Players.PlayerAdded:Connect(function() " + kDisabledOn + "end)",
      "p.Kill.Disabled = not p.Kill.Disabled",
      "p:FindFirstChild('Kill').Disabled = false",
      "for _, s in workspace:GetDescendants() do if s:IsA('Script') then s.Disabled = false end "
      "end",
      "for _, s in pairs(p:GetChildren()) do if s.ClassName == 'Script' then s.Enabled = true "
      "end end"};
  for (const std::string& script : scripts) {
    Disabled scene;
    scene.run(script);
    scene.level();
    EXPECT_FALSE(scene[scene.lever].kill) << script;
    ASSERT_TRUE(scene[scene.trap].kill) << script;
    EXPECT_EQ(scene.evidence(scene.trap, "kill").rfind("script Kill line 2", 0), 0u) << script;
  }
}

TEST(DisabledScripts, EnabledIsTheOppositeProperty) {
  Disabled scene(kDisabledKills, "Enabled");
  scene.set(scene.kill, "Enabled", false);
  EXPECT_FALSE((scene.level(), scene[scene.trap].kill));
  scene.run(kDisabledOn);
  EXPECT_TRUE((scene.level(), scene[scene.trap].kill));
}

TEST(DisabledScripts, ALeverThatEnablesThemArmsTheTrap) {
  Disabled scene;
  scene.pulls(kDisabledOn);
  scene.run("p.Touched:Connect(function() end)");
  expectArmed(scene, "touch");
}

TEST(DisabledScripts, StayDisabledUnlessAScriptEnablesThem) {
  const std::string scripts[] = {"print(p.Kill.Disabled)",
                                 "p.Kill.Disabled = true",
                                 "p.Kill.Enabled = false",
                                 "p.Other.Disabled = false",
                                 "if false then " + kDisabledOn + "end",
                                 "local k = p.Kill:Clone() k.Disabled = false k.Parent = nil"};
  for (const std::string& script : scripts) {
    Disabled scene;
    scene.run(script);
    expectHarmless(scene, script);
  }
  Disabled itself("script.Disabled = false " + kDisabledKills);
  expectHarmless(itself, "itself");
}

TEST(DisabledScripts, AChainOfTwentyScriptsRuns) {
  constexpr int kLinks = 20;
  Disabled scene;
  for (int i = 0; i < kLinks; ++i) {
    const std::string next =
        "game:GetService('ServerScriptService').Link" + std::to_string(i - 1) + ".Disabled = false";
    const InstanceId link = scene.run(i == 0 ? kDisabledOn : next);
    scene.document.instances[link].name = "Link" + std::to_string(i);
    scene.set(link, "Disabled", true);
  }
  scene.run("script.Parent.Link19.Enabled = true");
  scene.level();
  EXPECT_TRUE(scene[scene.trap].kill);
}

TEST(DisabledScripts, TheirTimersAndMotionsCount) {
  Disabled timer(
      "while true do script.Parent.CanCollide = false wait(2) script.Parent.CanCollide = true "
      "wait(2) end");
  timer.run(kDisabledOn);
  timer.level();
  EXPECT_TRUE(timer[timer.trap].vanish);
  Disabled swing(
      "local info = TweenInfo.new(2, Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1, true)\n"
      "game:GetService('TweenService'):Create(script.Parent, info, {Position = "
      "Vector3.new(9, 9, 0)}):Play()");
  swing.run("wait(3) " + kDisabledOn);
  swing.level();
  EXPECT_TRUE(swing[swing.trap].motion);
}

}  // namespace
}  // namespace obby::test
