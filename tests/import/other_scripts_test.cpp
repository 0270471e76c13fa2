// Traps that wake by what another script sets: kill parts, as guesses, and the level says so.
#include <string>
#include <utility>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kMayHarm = "damage that a script may deal";
const char* const kTooMuch = "script that sets too much";
const std::string kLongest(100, 'a');  // that the engine lets the name of an attribute be
const std::string kPulls = "lever.Touched:Connect(function() p.On.Value = true end)";
const std::string kKills = "then\nhit.Parent.Humanoid.Health = 0 end end)";

// What a handler of the trap does, which is `p`.
std::string touched(const std::string& body) {
  return "local p = workspace.Trap p.Touched:Connect(function(hit) " + body;
}

// A lever, and a trap with three values; scripts call them `lever` and `p`.
struct Trapped : Scene {
  Trapped() {
    add("ClickDetector", "ClickDetector", lever);
    value("BoolValue", "On", false, trap);
    value("NumberValue", "Count", 0.0, trap);
    value("StringValue", "Mode", std::string("calm"), trap);
  }
  void pulls(const std::string& text, bool ofClient = false) {
    run("local lever, p = workspace.Lever, workspace.Trap " + text, ofClient);
  }
  void asks(const std::string& condition, bool ofClient = false) {
    run(touched("if " + condition + " " + kKills), ofClient);
  }
  void run(const std::string& text, bool ofClient = false) {
    const InstanceId id =
        add(ofClient ? "LocalScript" : "Script", "Script", ofClient ? client : scripts);
    set(id, "Source", text);
  }

  const InstanceId lever = part("Lever"), trap = part("Trap", {9, 0, 0});
  const InstanceId client = add("StarterPlayerScripts", "StarterPlayerScripts",
                                add("StarterPlayer", "StarterPlayer", kNoInstance));
};

void expectGuess(Trapped& scene, const std::string& what) {
  scene.level();
  EXPECT_FALSE(scene[scene.lever].kill) << what;
  ASSERT_TRUE(scene[scene.trap].kill) << what;
  EXPECT_GE(scene[scene.trap].kill->damage, 100) << what;
  EXPECT_EQ(scene.evidence(scene.trap, "kill").rfind("guessed: ", 0), 0u) << what;
  ASSERT_EQ(scene.unmodelled(kMayHarm), 1u) << what;
  const auto& entry = scene.level().unmodelled.at(kMayHarm);
  EXPECT_EQ(entry.example, "Workspace/Trap") << what;
  EXPECT_NE(entry.note.find("script Script line 2"), std::string::npos) << entry.note;
}

void expectHarmless(Trapped& scene, const std::string& what) {
  scene.level();
  EXPECT_FALSE(scene[scene.trap].kill) << what;
  EXPECT_EQ(scene.unmodelled(kMayHarm), 0u) << what;
}

TEST(OtherScripts, ALeverOfAnotherScriptWakesTheTrap) {
  const std::pair<std::string, std::string> cases[] = {
      {"p.On.Value = true", "p.On.Value"},
      {"p.On.Value = not p.On.Value", "p.On.Value"},
      {"p.Count.Value += 1", "p.Count.Value >= 3"},
      {"p.Mode.Value = 'wild'", "p.Mode.Value == 'wild'"},
      {"p:SetAttribute('Armed', true)", "p:GetAttribute('Armed')"},
      {"p:SetAttribute('" + kLongest + "', true)", "p:GetAttribute('" + kLongest + "')"},
      {"p.Transparency = 1", "p.Transparency > 0.5"},
      {"p.CanCollide = false", "not p.CanCollide"},
      {"p.Name = 'Deadly'", "p.Name == 'Deadly'"}};
  for (const auto& [sets, condition] : cases)
    for (const bool trapFirst : {false, true}) {
      Trapped scene;
      if (trapFirst) scene.asks(condition);
      scene.pulls("lever.Touched:Connect(function() " + sets + " end)");
      if (!trapFirst) scene.asks(condition);
      expectGuess(scene, sets + (trapFirst ? ", the trap first" : ""));
    }
}

// Nobody knows when the trap is touched, nor which script comes first.
TEST(OtherScripts, ItCountsWheneverItIsSet) {
  const std::string set = "p.On.Value = true ";
  const std::string ways[] = {
      set,
      "wait(5) " + set,
      "while wait(5) do " + set + "end",
      "if math.random() > 0.5 then " + set + "end",
      "lever.ClickDetector.MouseClick:Connect(function() " + set + "end)",
      "lever.Touched:Connect(function() " + set + "wait(3) p.On.Value = false end)",
      "local function pull() " + set + "end lever.Touched:Connect(function() pull() end)"};
  for (const std::string& way : ways) {
    Trapped scene;
    scene.pulls(way);
    scene.asks("p.On.Value");
    expectGuess(scene, way);
  }
}

TEST(OtherScripts, TwoLeversWakeATrapTogether) {
  Trapped scene;
  scene.pulls(kPulls);
  scene.run("local on = false " +
            touched("if not on then on = true return end\nif p.On.Value " + kKills));
  scene.level();
  ASSERT_TRUE(scene[scene.trap].kill);
  EXPECT_EQ(scene.unmodelled(kMayHarm), 1u);
}

// The steps of the place are gone before the trap's script is read anew.
TEST(OtherScripts, WhatTheFirstReadingHasFoundStays) {
  Trapped scene;
  const auto big = scene.add("Folder", "Big", scene.workspace);
  for (int i = 0; i < 50000; ++i) scene.add("Folder", "Folder", big);
  scene.pulls(kPulls);
  scene.run("for i = 1, 1e6 do workspace.Trap.Count.Value = 1 end local on = false " +
            touched("if p.On.Value then print(p) end if not on then on = true return end if on " +
                    kKills));
  for (int i = 0; i < 21; ++i)
    scene.run("local big = workspace.Big for i = 1, 9 do big:ClearAllChildren() end");
  scene.level();
  EXPECT_TRUE(scene[scene.trap].kill);
  EXPECT_EQ(scene.unmodelled(kMayHarm), 1u);
}

TEST(OtherScripts, WhatNoOtherScriptTurnsIsAsSaved) {
  const std::pair<std::string, std::string> cases[] = {
      {"p.On.Value = false", "p.On.Value"},
      {"p.Count.Value = 3", "p.On.Value"},
      {"p.Count.Value = 0", "p.Count.Value >= 3"},
      {"lever:SetAttribute('Armed', true)", "p:GetAttribute('Armed')"},
      {"p:SetAttribute('Armed', nil)", "p:GetAttribute('Armed')"},
      {"p:SetAttribute('a" + kLongest + "', true)", "p:GetAttribute('a" + kLongest + "')"},
      {"p.Transparency = 0", "p.Transparency > 0.5"},
      {"lever.Name = 'Deadly'", "p.Name == 'Deadly'"},
      {"p.Name = 'Trap'", "p.Name == 'Deadly'"},
      {"print(p.On.Value)", "p.On.Value"}};
  for (const auto& [sets, condition] : cases) {
    Trapped scene;
    scene.pulls("lever.Touched:Connect(function() " + sets + " end)");
    scene.asks(condition);
    expectHarmless(scene, sets);
  }
}

// A folder, and a script that sets more than half as much of what is in it as is kept of a place.
void addFlood(Trapped& scene, const std::string& name) {
  const auto folder = scene.add("Folder", name, scene.workspace);
  for (int i = 0; i < 130; ++i) scene.add("Folder", "Folder", folder);
  std::string text = "for _, f in workspace." + name + ":GetChildren() do ";
  for (int i = 0; i < 1000; ++i) text += "f:SetAttribute('a" + std::to_string(i) + "', 1) ";
  scene.run(text + "end");
}

TEST(OtherScripts, WhatIsTooMuchToKeepIsNamed) {
  Trapped half;
  addFlood(half, "One");
  half.pulls(kPulls);
  half.asks("p.On.Value");
  half.level();
  EXPECT_TRUE(half[half.trap].kill);
  EXPECT_EQ(half.unmodelled(kTooMuch), 0u);

  for (const bool leverFirst : {false, true}) {
    Trapped scene;
    if (leverFirst) scene.pulls(kPulls);
    addFlood(scene, "One");
    addFlood(scene, "Two");
    if (!leverFirst) scene.pulls(kPulls);
    scene.asks("p.On.Value");
    scene.level();
    EXPECT_EQ(scene[scene.trap].kill.has_value(), leverFirst);
    EXPECT_EQ(scene.unmodelled(kTooMuch), leverFirst ? 1u : 2u);
    EXPECT_EQ(scene.unmodelled("very long script"), 0u);
  }
}

// Without room for what its handlers ask for a script is read anew all the same.
TEST(OtherScripts, ATrapThatAsksForTooMuchToKeepIsFound) {
  Trapped scene;
  const auto folder = scene.add("Folder", "Many", scene.workspace);
  for (int i = 0; i < 40; ++i) scene.add("Folder", "Folder", folder);
  std::string asks = "for _, f in workspace.Many:GetChildren() do local a = f.a0";
  for (int i = 1; i < 1000; ++i) asks += ", f.a" + std::to_string(i);
  asks += " end ";
  scene.pulls(kPulls);
  for (int i = 0; i < 6; ++i) scene.run(touched(asks + "print('Health') end)"));
  scene.run(touched(asks + "if p.On.Value " + kKills));
  scene.level();
  EXPECT_TRUE(scene[scene.trap].kill);
  EXPECT_EQ(scene.unmodelled(kMayHarm), 1u);
  EXPECT_EQ(scene.unmodelled("very long script"), 0u);
}

// What the trap's script leaves there itself as it begins: the text of one script tells its order.
TEST(OtherScripts, WhatTheOnlyScriptSetsIsKnown) {
  Trapped scene;
  scene.run(touched("if p.On.Value " + kKills));
  scene.run("print(workspace.Trap.On.Value)");
  expectHarmless(scene, "none sets it");
  Trapped own;
  own.run("workspace.Trap.Count.Value = 3 " + touched("if p.Count.Value == 0 " + kKills));
  expectHarmless(own, "the trap's own script");
}

TEST(OtherScripts, WhatTheHandlerHasSetItselfIsKnown) {
  Trapped scene;
  scene.pulls(kPulls);
  scene.run(touched("p.On.Value = false if p.On.Value " + kKills));
  expectHarmless(scene, "set back before it is asked for");
}

TEST(OtherScripts, ALeverWakesItsOwnTrapAlone) {
  Trapped scene;
  const auto other = scene.part("Other", {18, 0, 0});
  scene.value("BoolValue", "On", false, other);
  scene.pulls(kPulls);
  scene.run(
      "for _, p in {workspace.Trap, workspace.Other} do p.Touched:Connect(function(hit) "
      "if p.On.Value " +
      kKills + " end");
  expectGuess(scene, "one of two");
  EXPECT_FALSE(scene[other].kill);
}

TEST(OtherScripts, WhatSurelyHarmsStaysCertain) {
  for (const bool trapFirst : {false, true}) {
    Trapped scene;
    if (trapFirst) scene.asks("not p.On.Value");
    scene.pulls(kPulls);
    if (!trapFirst) scene.asks("not p.On.Value");
    scene.level();
    ASSERT_TRUE(scene[scene.trap].kill);
    EXPECT_EQ(scene.evidence(scene.trap, "kill").rfind("script ", 0), 0u);
    EXPECT_EQ(scene.unmodelled(kMayHarm), 0u);
  }
}

// The server finds nothing of what a client sets; a client finds what the server sets.
TEST(OtherScripts, WhatAClientSetsStaysThere) {
  for (const bool lever : {false, true})
    for (const bool trap : {false, true}) {
      Trapped scene;
      scene.pulls(kPulls, lever);
      scene.asks("p.On.Value", trap);
      if (lever && !trap)
        expectHarmless(scene, "a lever for one player");
      else
        expectGuess(scene, lever ? "both of the client" : "a lever for all");
    }
}

TEST(OtherScripts, HealingOfAnotherAmountIsNoHarm) {
  const char* const ways[] = {"h:TakeDamage(-p.Count.Value)", "h.Health += p.Count.Value",
                              "h.Health = math.min(h.Health + p.Count.Value, h.MaxHealth)"};
  for (const char* way : ways) {
    Trapped scene;
    scene.pulls("lever.Touched:Connect(function() p.Count.Value = 25 end)");
    scene.run("workspace.Trap.Count.Value = 10 " +
              touched("local h = hit.Parent.Humanoid " + std::string(way) + " end)"));
    expectHarmless(scene, way);
  }
}

TEST(OtherScripts, ATagSaysThatItIsHarmless) {
  Trapped scene;
  scene.tag(scene.trap, "Harmless");
  scene.pulls(kPulls);
  scene.asks("p.On.Value");
  expectHarmless(scene, "tag");
}

// What all scripts share is never known.
TEST(OtherScripts, FieldsOfAllScriptsMayBeEither) {
  for (const char* shared : {"_G", "shared"}) {
    Trapped scene;
    scene.pulls("lever.Touched:Connect(function() " + std::string(shared) + ".armed = true end)");
    scene.asks(std::string(shared) + ".armed");
    scene.level();
    EXPECT_TRUE(scene[scene.trap].kill) << shared;
  }
}

}  // namespace
}  // namespace obby::test
