// Handlers of touches that harm nobody as their script has begun, but may do so later on: a kill
// part all the same, as a guess, and the level says so.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kSecondReadingMayHarm = "damage that a script may deal";
const std::string kSecondReadingKills = "then\nhit.Parent.Humanoid.Health = 0 end ";
const std::string kSecondReadingTouch = "p.Touched:Connect(function(hit) ";

bool isGuessed(const Scene& scene, InstanceId part) {
  return scene.evidence(part, "kill").rfind("guessed: ", 0) == 0;
}

void secondReadingExpectGuess(const std::string& text) {
  ScriptedPart scene(text);
  ASSERT_TRUE(scene[scene.self].kill) << text;
  EXPECT_TRUE(isGuessed(scene, scene.self)) << text;
  EXPECT_EQ(scene.unmodelled(kSecondReadingMayHarm), 1u) << text;
}

// Two parts, and a script with a value object `On` that connects one function to both.
struct LeverAndTrap : Scene {
  LeverAndTrap(const std::string& before, const std::string& body) {
    std::string text = before + "\nfor _, part in workspace.Set:GetChildren() do\n";
    text += "part.Touched:Connect(function(hit) " + body + "end) end";
    value("BoolValue", "On", false, script(text, scripts));
    level();
  }
  const InstanceId folder = add("Folder", "Set", workspace);
  const InstanceId lever = part("Lever", {}, folder), trap = part("Trap", {9, 0, 0}, folder);
};

void expectTrap(const std::string& before, const std::string& body) {
  LeverAndTrap scene(before, body);
  EXPECT_FALSE(scene[scene.lever].kill) << body;
  ASSERT_TRUE(scene[scene.trap].kill) << body;
  EXPECT_GE(scene[scene.trap].kill->damage, 100) << body;
  EXPECT_TRUE(isGuessed(scene, scene.trap)) << body;
  ASSERT_EQ(scene.unmodelled(kSecondReadingMayHarm), 1u) << body;
  const auto& entry = scene.level().unmodelled.at(kSecondReadingMayHarm);
  EXPECT_EQ(entry.example, "Workspace/Set/Trap");
  EXPECT_NE(entry.note.find("script Script line 4"), std::string::npos) << entry.note;
}

TEST(SecondReading, ALeverThatTheSameBodySetsWakesTheTrap) {
  struct Case {
    std::string before, sets, asks;
  };
  const Case cases[] = {{"local on = false", "on = true ", "on "},
                        {"local on", "on = 'yes' ", "on == 'yes' "},
                        {"local state = {on = false}", "state.on = true ", "state.on "},
                        {"", "script.On.Value = true ", "script.On.Value "},
                        {"", "script:SetAttribute('On', true) ", "script:GetAttribute('On') "}};
  for (const Case& now : cases) {
    const std::string sets = "if part.Name == 'Lever' then " + now.sets;
    expectTrap(now.before, sets + "elseif " + now.asks + kSecondReadingKills);
    expectTrap(now.before,
               "if part.Name == 'Trap' and " + now.asks + kSecondReadingKills + sets + "end ");
  }
}

TEST(SecondReading, WhatHarmsFromTheSecondTouchOnIsAGuess) {
  const std::string off = "local on = false " + kSecondReadingTouch;
  secondReadingExpectGuess(off + "if not on then on = true return end if on " +
                           kSecondReadingKills + "end)");
  secondReadingExpectGuess(off + "if on " + kSecondReadingKills +
                           "on = true wait(1) on = false end)");
  secondReadingExpectGuess(off + "if not on then on = true elseif on " + kSecondReadingKills +
                           "end)");
  const std::string first =
      "local n = 0 " + kSecondReadingTouch + "if n == 0 then n = 1 elseif n == 1 ";
  secondReadingExpectGuess(first + kSecondReadingKills + "end)");
  secondReadingExpectGuess(first + "then n = 2 elseif n == 2 " + kSecondReadingKills + "end)");
}

TEST(SecondReading, ANameMayBeALever) {
  secondReadingExpectGuess(kSecondReadingTouch + "if p.Name == 'Deadly' " + kSecondReadingKills +
                           "p.Name = 'Deadly' end)");
  ScriptedPart same(kSecondReadingTouch + "if p.Name == 'Deadly' " + kSecondReadingKills +
                    "p.Name = 'Pad' end)");
  EXPECT_FALSE(same[same.self].kill);
}

// As who carries a shield is not harmed.
TEST(SecondReading, WhatABranchSetsThatMayNotBeTakenIsOneOfTwo) {
  const std::string asks = "if hit.Parent:FindFirstChild('Shield') then ";
  const std::string shields = asks + "safe = true end if not safe " + kSecondReadingKills + "end)";
  secondReadingExpectGuess(kSecondReadingTouch + "local safe = false " + shields);
  secondReadingExpectGuess("local safe = false " + kSecondReadingTouch + shields);
  const std::string takes = "hit.Parent.Humanoid:TakeDamage(harm) end)";
  secondReadingExpectGuess(kSecondReadingTouch + "local harm = 10 " + asks + "harm = 0 end\n" +
                           takes);
  secondReadingExpectGuess(kSecondReadingTouch + "local harm " + asks +
                           "harm = 10 else harm = 0 end\n" + takes);
  const std::string human = "local human = hit.Parent:FindFirstChild('Humanoid') ";
  secondReadingExpectGuess(kSecondReadingTouch + human + asks +
                           "human = nil end\nif human then human.Health = 0 end end)");
}

// As of the one tile of a row that carries, or a trap that only some parts are.
TEST(SecondReading, WhatASetUpMayHaveSetIsOneOfTwo) {
  const std::string touch =
      kSecondReadingTouch + "if not p:GetAttribute('Safe') " + kSecondReadingKills + "end)";
  const std::string safe = "p:SetAttribute('Safe', true) ";
  secondReadingExpectGuess("if math.random() > 0.5 then " + safe + "end " + touch);
  secondReadingExpectGuess("for i = 1, 2 do if math.random() > 0.5 then continue end " + safe +
                           "end " + touch);
  ScriptedPart sure(safe + touch);
  EXPECT_FALSE(sure[sure.self].kill);
  EXPECT_EQ(sure.unmodelled(kSecondReadingMayHarm), 0u);
}

TEST(SecondReading, AStateInWhichThePlayerIsDeadIsHarm) {
  secondReadingExpectGuess(
      "local on = false " + kSecondReadingTouch +
      "if on then\nhit.Parent.Humanoid:ChangeState(Enum.HumanoidStateType.Dead) end\n"
      "on = true end)");
}

TEST(SecondReading, WhatAScriptTurnsInPlayMayWakeATrap) {
  const std::string touch =
      kSecondReadingTouch + "if p.Transparency > 0.5 " + kSecondReadingKills + "end)\n";
  const std::string flickers =
      "while true do p.Transparency = 1 wait(2) p.Transparency = 0 wait(2) end";
  secondReadingExpectGuess("p.Transparency = 0 " + touch + flickers);
  secondReadingExpectGuess("p.Transparency = 0 task.spawn(function() " + flickers + " end) " +
                           touch);
  secondReadingExpectGuess("p.Transparency = 1 " + touch + "wait(5) p.Transparency = 0");
  const std::string changes = "workspace.Changed:Connect(function() p.Transparency = 1 end)";
  secondReadingExpectGuess("p.Transparency = 0 " + touch + changes);
  const std::string fades =
      "local info = TweenInfo.new(1, Enum.EasingStyle.Linear, Enum.EasingDirection.In, -1, true)\n"
      "game:GetService('TweenService'):Create(p, info, {Transparency = 0.9}):Play() ";
  secondReadingExpectGuess(fades + "p.Transparency = 0 " + touch);
}

TEST(SecondReading, WhatNothingWakesIsHarmless) {
  const std::string off = "local on = false " + kSecondReadingTouch,
                    kills = kSecondReadingKills + "end)\n";
  const std::string texts[] = {
      off + "if on " + kills,
      off + "on = false if on " + kills,
      off + "on = true if not on " + kills,
      off + "if on then on = false hit.Parent.Humanoid.Health += 20 else on = true end end)",
      "p.Transparency = 1 " + kSecondReadingTouch + "if p.Transparency < 0.5 " + kills,
      "p.Transparency = 0 " + kSecondReadingTouch + "if p.Transparency > 0.5 " + kills +
          "while true do p.Transparency = 0 wait(1) end"};
  for (const std::string& text : texts) {
    ScriptedPart scene(text);
    EXPECT_FALSE(scene[scene.self].kill) << text;
    EXPECT_EQ(scene.unmodelled(kSecondReadingMayHarm), 0u) << text;
  }
}

// Whoever is hurt is told by the first reading.
TEST(SecondReading, WhatHurtsOneOfTwoOthersHurtsNoPlayer) {
  Scene scene;
  const auto pad = scene.part("Pad");
  for (const char* name : {"One", "Two"})
    scene.add("Humanoid", "Humanoid", scene.add("Model", name, scene.workspace));
  scene.script("local p, boss = script.Parent, workspace.One\n" + kSecondReadingTouch +
                   "if hit.Parent:FindFirstChild('Key') then boss = workspace.Two end\n"
                   "boss.Humanoid:TakeDamage(25) end)",
               pad);
  scene.level();
  EXPECT_FALSE(scene[pad].kill);
}

// A branch that sets what was there wakes nothing.
TEST(SecondReading, WhatABranchLeavesAsItWasIsNoOther) {
  const std::string asks = "if hit.Parent:FindFirstChild('Key') then ";
  const std::string texts[] = {"local on = false " + kSecondReadingTouch + asks +
                                   "on = false end if on " + kSecondReadingKills + "end)",
                               "local gain = 10 " + kSecondReadingTouch + asks +
                                   "gain = 25 end hit.Parent.Humanoid:TakeDamage(-gain) end)"};
  for (const std::string& text : texts) {
    ScriptedPart scene(text);
    EXPECT_FALSE(scene[scene.self].kill) << text;
    EXPECT_EQ(scene.unmodelled(kSecondReadingMayHarm), 0u) << text;
  }
}

TEST(SecondReading, WhatASetUpSetsAfterAWaitIsKnown) {
  ScriptedPart scene("p.Transparency = 0 wait(2) p.Transparency = 1 " + kSecondReadingTouch +
                     "if p.Transparency < 0.5 " + kSecondReadingKills + "end)");
  EXPECT_FALSE(scene[scene.self].kill);
}

// As one that harms who comes too late.
TEST(SecondReading, AGoalByItsNameStaysOne) {
  for (const char* name : {"Finish", "Pad"}) {
    Scene scene;
    const auto pad = scene.part(name);
    scene.script("local over, p = false, script.Parent\n" + kSecondReadingTouch + "if over " +
                     kSecondReadingKills + "over = true end)",
                 pad);
    scene.level();
    EXPECT_EQ(scene[pad].goal.has_value(), name[0] == 'F');
    EXPECT_EQ(scene[pad].kill.has_value(), name[0] != 'F');
  }
}

TEST(SecondReading, IsNamedBesideWhatComesButOnce) {
  secondReadingExpectGuess("local on, gone = false, false\n" + kSecondReadingTouch + "if on " +
                           kSecondReadingKills +
                           "on = true if gone then return end gone = true\n"
                           "p.CanCollide = false wait(3) p.CanCollide = true end)");
}

// Whichever script comes first.
TEST(SecondReading, WhatSurelyHarmsCountsBeforeWhatMay) {
  const std::string own = "local p = script.Parent\n" + kSecondReadingTouch;
  const std::string does = own + "if hit " + kSecondReadingKills + "end)";
  const std::string may = "on = false\n" + own +
                          "if on then hit.Parent.Humanoid:TakeDamage(10) else on = true end end)";
  for (const bool turned : {false, true}) {
    Scene scene;
    const auto pad = scene.part("Pad");
    scene.script(turned ? does : may, pad);
    scene.script(turned ? may : does, pad);
    scene.level();
    ASSERT_TRUE(scene[pad].kill) << turned;
    EXPECT_GE(scene[pad].kill->damage, 100) << turned;
    EXPECT_FALSE(isGuessed(scene, pad)) << turned;
    EXPECT_EQ(scene.unmodelled(kSecondReadingMayHarm), 0u) << turned;
  }
}

// What it would do besides is as the first reading has it.
TEST(SecondReading, OnlyHarmCounts) {
  const std::string opens =
      "local on = false " + kSecondReadingTouch + "if on then p.CanCollide = false end ";
  ScriptedPart scene(opens + "if on " + kSecondReadingKills + "on = true end)");
  EXPECT_TRUE(scene[scene.self].kill);
  EXPECT_FALSE(scene[scene.self].vanish);
}

TEST(SecondReading, HarmByAPartThatIsNotKnownIsNamed) {
  Scene scene;
  scene.part("Part");
  std::string text = "local on = false for _, part in require(script.Parts) do\n";
  text += "part.Touched:Connect(function(hit) if on " + kSecondReadingKills + "on = true end) end";
  scene.script(text, scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("damage by an unknown part"), 1u);
}

}  // namespace
}  // namespace obby::test
