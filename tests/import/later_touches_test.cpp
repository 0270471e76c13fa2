// What a part does at its second touch, and what comes only once.
#include <string>

#include "import/lever_scene.h"

namespace obby::test {
namespace {

const std::string kLaterAway = "p.CanCollide = false wait(3) p.CanCollide = true ";

void expectSecondTouchKills(const std::string& text) {
  ScriptedPart scene(text);
  ASSERT_TRUE(scene[scene.self].kill) << text;
  EXPECT_TRUE(isGuessedKill(scene, scene.self)) << text;
  EXPECT_EQ(scene.unmodelled(kMoreLater), 1u) << text;
}

// A touch has several limbs: a script tells touches apart by time.
TEST(LaterTouches, HarmFromTheSecondTouchOnIsFound) {
  const std::string later = "task.delay(1, function() on = true end) ";
  const std::string touch = "local on = false p.Touched:Connect(function(hit) ";
  expectSecondTouchKills(touch + "if on then\n" + kKillHit + "end " + later + "end)");
  expectSecondTouchKills(
      touch + "if on then hit.Parent.Humanoid:ChangeState(Enum.HumanoidStateType.Dead) end " +
      later + "end)");
  expectSecondTouchKills("p.Touched:Connect(function(hit) if p.Name == 'Deadly' then\n" + kKillHit +
                         "end task.delay(1, function() p.Name = 'Deadly' end) end)");
}

void expectComesOnce(const std::string& text) {
  ScriptedPart scene(text);
  const PartDraft& pad = scene[scene.self];
  EXPECT_TRUE(pad.vanish || pad.kill || pad.jumpPad) << text;
  ASSERT_EQ(scene.unmodelled(kLessLater), 1u) << text;
  EXPECT_EQ(scene.level().unmodelled.at(kLessLater).example, "Workspace/Pad") << text;
  EXPECT_EQ(noteOf(scene.level(), kLessLater).rfind("from its second touch on", 0), 0u) << text;
}

TEST(LaterTouches, FlagsThatNobodyTurnsBackLetItComeOnce) {
  const std::string touch = "p.Touched:Connect(function(hit)\n";
  const std::string texts[] = {
      "local done = false " + touch + "if done then return end done = true " + kLaterAway + "end)",
      "local used " + touch +
          "local h = hit.Parent:FindFirstChild('Humanoid')\n"
          "if h and not used then used = true h.Health = 0 end end)",
      "local done = false " + touch +
          "if done then return end done = true\n"
          "hit.Velocity = Vector3.new(0, 90, 0) end)",
      touch + "if p:GetAttribute('Done') then return end p:SetAttribute('Done', true) " +
          kLaterAway + "end)",
      "local open = true " + touch + "if open ~= nil then open = nil task.spawn(function() " +
          kLaterAway + "end) end end)"};
  for (const std::string& text : texts) expectComesOnce(text);
}

TEST(LaterTouches, HandlersThatDisconnectThemselvesComeOnce) {
  const std::string texts[] = {
      "local c c = p.Touched:Connect(function(hit)\nc:Disconnect() " + kLaterAway + "end)",
      "p.Touched:Once(function(hit)\n" + kLaterAway + "end)",
      "local c c = p.Touched:connect(function(hit)\nlocal h = hit.Parent:FindFirstChild("
      "'Humanoid') if h then h.Health = 0 c:disconnect() end end)"};
  for (const std::string& text : texts) expectComesOnce(text);
}

TEST(LaterTouches, DebouncesThatEndLetItComeAgain) {
  const std::string begin = "local busy = false p.Touched:Connect(function(hit)\n";
  const std::string guarded = "if busy then return end busy = true " + kLaterAway;
  const std::string texts[] = {
      begin + guarded + "busy = false end)",
      begin + guarded + "task.delay(1, function() busy = false end) end)",
      begin + guarded + "end) p.TouchEnded:Connect(function() busy = false end)",
      begin + guarded + "end) while true do wait(5) busy = false end",
      "p.Touched:Connect(function(hit) local busy = false " + guarded + "end)",
      "local function go() " + kLaterAway + "\np.Touched:Once(go) end p.Touched:Once(go)",
      "local function arm() local c c = p.Touched:Connect(function() c:Disconnect()\n" +
          kLaterAway + "arm() end) end arm()"};
  for (const std::string& text : texts) {
    ScriptedPart scene(text);
    ASSERT_TRUE(scene[scene.self].vanish) << text;
    EXPECT_NEAR(scene[scene.self].vanish->away, 3, 0.04) << text;
    EXPECT_EQ(scene.unmodelled(kLessLater), 0u) << text << noteOf(scene.level(), kLessLater);
  }
}

TEST(LaterTouches, WhatIsGoneForGoodNeedsNoSecondTouch) {
  const char* const texts[] = {
      "local c c = p.Touched:Connect(function() c:Disconnect() p.CanCollide = false end)",
      "local done = false p.Touched:Connect(function() if done then return end done = true\n"
      "p:Destroy() end)",
      "p.Touched:Once(function() p.Color = Color3.new(1, 0, 0) end)"};
  for (const char* text : texts) {
    ScriptedPart scene(text);
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

// A player's next body, or the next player, is not spared by a flag of the character.
TEST(LaterTouches, AKillThatACharacterScriptDealsComesWithEachLife) {
  for (const bool ofCharacter : {false, true}) {
    Scene scene;
    const auto red = scene.part("Red", {20, 0, 0});
    const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
    const auto folder = scene.add("StarterCharacterScripts", "StarterCharacterScripts", player);
    scene.script(
        "local dead = false workspace.Red.Touched:Connect(function(hit)\n"
        "if dead then return end dead = true " +
            kKillHit + "end)",
        ofCharacter ? folder : scene.scripts);
    scene.level();
    EXPECT_TRUE(scene[red].kill) << ofCharacter;
    EXPECT_EQ(scene.unmodelled(kLessLater), ofCharacter ? 0u : 1u);
  }
}

TEST(Touches, APartThatATouchLetsLooseFallsAway) {
  ScriptedPart scene("p.Touched:Connect(function() task.wait(0.5) p.Anchored = false end)");
  ASSERT_TRUE(scene[scene.self].vanish);
  EXPECT_NEAR(scene[scene.self].vanish->delay, 0.5, 0.05);
}

TEST(Touches, AClickThatMovesThePlayerIsNamed) {
  Scene scene;
  const auto button = scene.part("Button", {20, 0, 0});
  scene.add("ClickDetector", "ClickDetector", button);
  scene.script(
      "script.Parent.ClickDetector.MouseClick:Connect(function(player)\n"
      "player.Character:PivotTo(CFrame.new(0, 99, 0)) end)",
      button);
  scene.level();
  EXPECT_EQ(scene.unmodelled("use that acts on the player"), 1u);
}

TEST(Touches, ATagKillsWhereScriptsDoNothing) {
  Scene scene;
  const auto part = scene.part("Part", {20, 0, 0});
  scene.tag(part, "KillBrick");
  scene.script("script.Parent.Touched:Connect(function() print('x') end)", part);
  scene.level();
  EXPECT_TRUE(scene[part].kill);
}

TEST(LaterTouches, ALoopBeforeTheChangeDelaysIt) {
  for (const char* loop : {"while fade < 10 do fade += 1 wait(0.1) end",
                           "repeat fade = fade + 1 wait(0.1) until fade >= 10"}) {
    ScriptedPart scene(
        "local busy p.Touched:Connect(function(hit) if busy then return end\n"
        "busy = true local fade = 0 " +
        std::string(loop) + " p.CanCollide = false wait(3) p.CanCollide = true busy = false end)");
    ASSERT_TRUE(scene[scene.self].vanish) << loop;
    EXPECT_NEAR(scene[scene.self].vanish->delay, 1, 0.05) << loop;
  }
}

}  // namespace
}  // namespace obby::test
