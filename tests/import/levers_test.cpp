// Traps that another touch arms, and doors that several touches open.
#include <string>
#include <utility>

#include "import/lever_scene.h"

namespace obby::test {
namespace {

TEST(Levers, AnyCheckedEffectOfALeverArmsTheTrap) {
  const std::pair<std::string, std::string> cases[] = {
      {"p.On.Value = true", "p.On.Value"},
      {"p.On.Value = not p.On.Value", "p.On.Value"},
      {"p.Mode.Value = 'wild'", "p.Mode.Value == 'wild'"},
      {"p:SetAttribute('Armed', true)", "p:GetAttribute('Armed')"},
      {"p.Transparency = 1", "p.Transparency > 0.5"},
      {"p.Name = 'Trap2'", "p.Name == 'Trap2'"},
      {"_G.armed = true", "_G.armed"},
      {"shared.armed = true", "shared.armed"}};
  for (const auto& [sets, condition] : cases)
    for (const bool trapFirst : {false, true}) {
      LeverScene scene;
      if (trapFirst) scene.asks(condition);
      // The script counts a touch once, even if several limbs touch.
      scene.run(
          "local last = -9 lever.Touched:Connect(function() if time() - last < 1 then\n"
          "return end last = time() " +
          sets + " end)");
      if (!trapFirst) scene.asks(condition);
      expectArmed(scene, sets);
    }
}

TEST(Levers, OneFunctionCanServeLeverAndTrap) {
  const std::pair<const char*, const char*> cases[] = {
      {"on = true ", "on "}, {"state.on = true ", "state.on "}, {"armed[p] = true ", "armed[p] "}};
  for (const auto& [sets, asks] : cases) {
    LeverScene scene;
    scene.run(
        "local on, state, armed = false, {}, {}\n"
        "for _, part in {lever, p} do part.Touched:Connect(function(hit)\n"
        "if part == lever then " +
        std::string(sets) + "elseif " + asks + "then " + kKillHit + "end end) end");
    expectArmed(scene, sets);
  }
}

TEST(Levers, ClicksAndTemporaryLeversArmTrapsToo) {
  LeverScene clicked;
  clicked.run("lever.ClickDetector.MouseClick:Connect(function() p.On.Value = true end)");
  clicked.asks("p.On.Value");
  expectArmed(clicked, "click");
  LeverScene connects;
  connects.run(
      "local done lever.Touched:Connect(function() if done then return end done = true\n"
      "p.Touched:Connect(function(hit) " +
      kKillHit + "end) end)");
  connects.run("p.Touched:Connect(function() end)");
  expectArmed(connects, "connects");
}

TEST(Levers, TwoLeversTogetherAreNamedAsOtherParts) {
  LeverScene scene;
  scene.part("Other", {60, 0, 0});
  scene.run(
      "local a, b lever.Touched:Connect(function() a = true end)\n"
      "workspace.Other.Touched:Connect(function() b = true end)\n"
      "p.Touched:Connect(function(hit) if a and b then " +
      kKillHit + "end end)");
  expectArmed(scene, "two levers", "once other parts have been touched or used");
}

TEST(Levers, ADoorThatNeedsTwoButtonsOpensInDoubt) {
  LeverScene scene;
  const InstanceId door = scene.part("Door", {60, 0, 0});
  scene.run(
      "local a, b\nlocal function open() if a and b then workspace.Door:Destroy() end end\n"
      "lever.Touched:Connect(function() a = true open() end)\n"
      "p.Touched:Connect(function() b = true open() end)");
  scene.level();
  ASSERT_TRUE(scene[door].vanish);
  EXPECT_NE(scene.evidence(door, "vanish").find("guessed: "), std::string::npos);
  EXPECT_GE(scene.unmodelled(kMoreLater), 1u);
}

TEST(Levers, ALeverThatDisarmsATrapIsNamed) {
  LeverScene scene;
  scene.pulls("p.On.Value = true");
  scene.asks("not p.On.Value");
  scene.level();
  ASSERT_TRUE(scene[scene.trap].kill);
  EXPECT_FALSE(isGuessedKill(scene, scene.trap));
  EXPECT_EQ(noteOf(scene.level(), kLessLater).rfind("once 'Lever' has been", 0), 0u);
}

TEST(Levers, ATrapThatNoLeverArmsIsHarmless) {
  const std::pair<std::string, std::string> cases[] = {
      {"p.On.Value = false", "p.On.Value"},
      {"p.Count.Value = 3", "p.On.Value"},
      {"p.Count.Value = 0", "p.Count.Value >= 3"},
      {"lever:SetAttribute('Armed', true)", "p:GetAttribute('Armed')"},
      {"p:SetAttribute('Armed', nil)", "p:GetAttribute('Armed')"},
      {"p.Transparency = 0", "p.Transparency > 0.5"},
      {"print(p.On.Value)", "p.On.Value"}};
  for (const auto& [sets, condition] : cases) {
    LeverScene scene;
    scene.pulls(sets);
    scene.asks(condition);
    expectHarmless(scene, sets);
  }
}

TEST(Levers, ServersAndClientsSeeEachOthersChanges) {
  for (const bool lever : {false, true})
    for (const bool trap : {false, true}) {
      if (lever && !trap)
        continue;  // the real engine keeps the change on the client, but the twin has one world
      LeverScene scene;
      scene.pulls("p.On.Value = true", lever);
      scene.asks("p.On.Value", trap);
      expectArmed(scene, "lever and trap");
    }
}

TEST(Levers, HealingIsNoHarm) {
  for (const char* heals : {"h:TakeDamage(-p.Count.Value)", "h.Health += p.Count.Value",
                            "h.Health = math.min(h.Health + p.Count.Value, h.MaxHealth)"}) {
    LeverScene scene;
    scene.pulls("p.Count.Value = 25");
    scene.run(
        "p.Count.Value = 10 p.Touched:Connect(function(hit)\n"
        "local h = hit.Parent.Humanoid " +
        std::string(heals) + " end)");
    expectHarmless(scene, heals);
  }
}

TEST(Levers, AHarmlessTagOverridesALever) {
  LeverScene scene;
  scene.tag(scene.trap, "Harmless");
  scene.pulls("p.On.Value = true");
  scene.asks("p.On.Value");
  scene.level();
  EXPECT_FALSE(scene[scene.trap].kill);
}

TEST(Levers, APartNamedAsAGoalStaysTheGoal) {
  Scene scene;
  const auto pad = scene.part("Finish", {20, 0, 0});
  scene.script("local over = false script.Parent.Touched:Connect(function(hit) if over then " +
                   kKillHit + "end task.delay(1, function() over = true end) end)",
               pad);
  scene.level();
  EXPECT_TRUE(scene[pad].goal);
  EXPECT_FALSE(scene[pad].kill);
}

TEST(Levers, HarmThatDependsOnTimeIsFoundInDoubt) {
  const std::string touch = "p.Touched:Connect(function(hit) if on then " + kKillHit + "end end)\n";
  const std::pair<std::string, bool> texts[] = {
      {"local on = false\n" + touch + "while true do on = true wait(1) on = false wait(1) end",
       true},
      {"local on = false\n" + touch + "wait(5) on = true", true},
      {"local on = false\n" + touch + "while true do wait(1) on = false end", false}};
  for (const auto& [text, kills] : texts) {
    LeverScene scene;
    scene.run(text);
    scene.level();
    EXPECT_EQ(scene[scene.trap].kill.has_value(), kills) << text;
  }
}

}  // namespace
}  // namespace obby::test
