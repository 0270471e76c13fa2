// Effects of a part at its second touch, and effects that occur only once.
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

// A touch has several limbs, so the script tells touches apart by time.
TEST(LaterTouches, HarmFromTheSecondTouchIsFound) {
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
  EXPECT_EQ(noteOf(scene.level(), kLessLater).rfind("from the second touch on", 0), 0u) << text;
}

TEST(LaterTouches, EffectsBehindAPermanentFlagOccurOnce) {
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

TEST(LaterTouches, EffectsOfDisconnectingHandlersOccurOnce) {
  const std::string texts[] = {
      "local c c = p.Touched:Connect(function(hit)\nc:Disconnect() " + kLaterAway + "end)",
      "p.Touched:Once(function(hit)\n" + kLaterAway + "end)",
      "local c c = p.Touched:connect(function(hit)\nlocal h = hit.Parent:FindFirstChild("
      "'Humanoid') if h then h.Health = 0 c:disconnect() end end)"};
  for (const std::string& text : texts) expectComesOnce(text);
}

TEST(LaterTouches, EffectsRepeatAfterTheDebounce) {
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

TEST(LaterTouches, PermanentEffectsNeedNoSecondTouch) {
  const char* const texts[] = {
      "local c c = p.Touched:Connect(function() c:Disconnect() p.CanCollide = false end)",
      ("local done = false p.Touched:Connect(function() if done then return end done = true\n"
       "p:Destroy() end)"),
      "p.Touched:Once(function() p.Color = Color3.new(1, 0, 0) end)"};
  for (const char* text : texts) {
    ScriptedPart scene(text);
    EXPECT_EQ(scene.unmodelled(kLessLater), 0u) << text;
  }
}

// A handler without a visible effect may count touches for something unknown.
TEST(LaterTouches, ListenersWithoutAVisibleEffectAreNamed) {
  const char* const kHidden = "input without a visible effect";
  ScriptedPart counts("local n = 0 p.Touched:Connect(function() n += 1 end)");
  EXPECT_EQ(counts.unmodelled(kHidden), 1u);
  ScriptedPart kills("p.Touched:Connect(function(hit) " + std::string(kKillHit) + " end)");
  EXPECT_EQ(kills.unmodelled(kHidden), 0u);
  ScriptedPart silent("p.Color = Color3.new(1, 0, 0)");
  EXPECT_EQ(silent.unmodelled(kHidden), 0u);
}

// The pads must be touched in an order that differs from their order in the file.
TEST(LaterTouches, PadsThatNeedAnOrderAreFound) {
  Scene scene;
  for (const char* name : {"C", "A", "B"}) scene.part(name, {20.0f * float(name[0] - '@'), 0, 0});
  const auto bridge = scene.part("Bridge", {200, 0, 0});
  scene.set(bridge, "CanCollide", false);
  scene.script(
      "local order, done = { 'A', 'B', 'C' }, 0\n"
      "for i, name in order do\n workspace[name].Touched:Connect(function()\n"
      "  if done == i - 1 then done = i end\n"
      "  if done == 3 then workspace.Bridge.CanCollide = true end\n end)\nend",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[bridge].vanish);
  EXPECT_TRUE(scene[bridge].vanish->inverted);
}

// Effects after the longest probe, or after the run, may help a player.
TEST(LaterTouches, ScriptsStillWaitingAreReported) {
  const char* const kWaits = "script still waiting at the end of the run";
  ScriptedPart touched("p.Touched:Connect(function() task.wait(20) p.CanCollide = false end)");
  EXPECT_EQ(touched.unmodelled(kWaits), 1u);
  ScriptedPart late("task.wait(90) p.CanCollide = false");
  EXPECT_EQ(late.unmodelled(kWaits), 1u);
  ScriptedPart loop("while true do task.wait(2) p.CanCollide = not p.CanCollide end");
  EXPECT_EQ(loop.unmodelled(kWaits), 0u);
  ScriptedPart soon("p.Touched:Connect(function() task.wait(3) p.CanCollide = false end)");
  EXPECT_EQ(soon.unmodelled(kWaits), 0u);
}

TEST(LaterTouches, EffectsOfSeveralClicksAreFound) {
  Scene scene;
  const auto button = scene.part("Button", {20, 0, 0});
  scene.add("ClickDetector", "ClickDetector", button);
  const auto door = scene.part("Door", {200, 0, 0});
  scene.script(
      "local n = 0\nscript.Parent.ClickDetector.MouseClick:Connect(function()\n n += 1\n"
      " if n == 3 then workspace.Door.CanCollide = false end\nend)",
      button);
  scene.level();
  EXPECT_TRUE(scene[door].vanish);
}

// A flag of the character does not protect a player's next body, or the next player.
TEST(LaterTouches, ACharacterScriptKillsInEveryLife) {
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

TEST(Touches, APartUnanchoredByATouchFalls) {
  ScriptedPart scene("p.Touched:Connect(function() task.wait(0.5) p.Anchored = false end)");
  ASSERT_TRUE(scene[scene.self].vanish);
  EXPECT_NEAR(scene[scene.self].vanish->delay, 0.5, 0.05);
}

TEST(Touches, AClickThatMovesThePlayerIsReported) {
  Scene scene;
  const auto button = scene.part("Button", {20, 0, 0});
  scene.add("ClickDetector", "ClickDetector", button);
  scene.script(
      "script.Parent.ClickDetector.MouseClick:Connect(function(player)\n"
      "player.Character:PivotTo(CFrame.new(0, 99, 0)) end)",
      button);
  scene.level();
  EXPECT_EQ(scene.unmodelled("interaction that affects the player"), 1u);
}

TEST(Touches, ATagKillsUnlessAScriptListens) {
  Scene scene;
  const auto heard = scene.part("Heard", {20, 0, 0}), other = scene.part("Other", {40, 0, 0});
  scene.tag(heard, "KillBrick");
  scene.tag(other, "KillBrick");
  scene.script("script.Parent.Touched:Connect(function() print('x') end)", heard);
  scene.level();
  EXPECT_FALSE(scene[heard].kill);
  EXPECT_TRUE(scene[other].kill);
}

// Poison continues after the player has left.
TEST(Touches, LastingHarmCountsForOneTouch) {
  Scene scene;
  const auto poison = scene.part("Poison", {20, 0, 0});
  scene.script(
      "local poisoned = false\nscript.Parent.Touched:Connect(function(hit)\n"
      " local human = hit.Parent:FindFirstChild('Humanoid')\n"
      " if not human or poisoned then return end\n poisoned = true\n"
      " for i = 1, 10 do human:TakeDamage(8) task.wait(0.5) end\n poisoned = false\nend)",
      poison);
  scene.level();
  ASSERT_TRUE(scene[poison].kill);
  EXPECT_NEAR(scene[poison].kill->damage, 80, 8);
}

TEST(Touches, HarmThatKillsAfterThePlayerLeavesIsLethal) {
  Scene scene;
  const auto fire = scene.part("Fire", {20, 0, 0});
  scene.script(
      "local burns = false\nscript.Parent.Touched:Connect(function(hit)\n"
      " local human = hit.Parent:FindFirstChild('Humanoid')\n"
      " if not human or burns then return end\n burns = true\n"
      " for i = 1, 6 do human:TakeDamage(25) task.wait(0.5) end\n burns = false\nend)",
      fire);
  scene.level();
  ASSERT_TRUE(scene[fire].kill);
  EXPECT_NEAR(scene[fire].kill->damage, 100, 1);
}

TEST(Touches, AProximityPromptOpensADoor) {
  Scene scene;
  const auto panel = scene.part("Panel", {20, 0, 0});
  scene.add("ProximityPrompt", "ProximityPrompt", panel);
  const auto door = scene.part("Door", {40, 0, 0});
  scene.script(
      "game:GetService('ProximityPromptService').PromptTriggered:Connect(function(prompt)\n"
      " if prompt.Parent.Name == 'Panel' then workspace.Door.CanCollide = false end\nend)",
      scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[door].vanish);
}

// A plate holds a door open. The door shuts when the player leaves.
TEST(Touches, AHeldPlateOpensADoorWhileTouched) {
  Scene scene;
  const auto plate = scene.part("Plate", {20, 0, 0}), door = scene.part("Door", {40, 0, 0});
  scene.script(
      "local door, count = workspace.Door, 0\n"
      "local function set() door.CanCollide = count == 0 end\n"
      "script.Parent.Touched:Connect(function() count += 1 set() end)\n"
      "script.Parent.TouchEnded:Connect(function() count -= 1 set() end)",
      plate);
  scene.level();
  ASSERT_TRUE(scene[door].vanish);
  ASSERT_TRUE(scene[plate].button);
  EXPECT_TRUE(scene[plate].button->restarts);
  EXPECT_LT(scene[plate].button->seconds, 0.2);
}

TEST(Touches, APolledFloorMaterialKills) {
  Scene scene;
  const auto lava = scene.part("Floor", {20, 0, 0});
  scene.set(lava, "Material", EnumItem{848, {}});
  scene.script(
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " player.CharacterAdded:Connect(function(character)\n"
      "  local human = character:WaitForChild('Humanoid')\n"
      "  while task.wait(0.1) do\n"
      "   if human.FloorMaterial == Enum.Material.Brick then human.Health = 0 end\n  end\n"
      " end)\nend)",
      scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[lava].kill);
}

TEST(Touches, ASearchBoxWithoutAPartIsReported) {
  Scene scene;
  scene.script(
      "while task.wait(0.1) do\n"
      " for _, part in workspace:GetPartBoundsInBox(CFrame.new(60, 3, 0), Vector3.new(8, 8, 8)) "
      "do\n"
      "  local human = part.Parent:FindFirstChild('Humanoid')\n"
      "  if human then human.Health = 0 end\n end\nend",
      scene.scripts);
  scene.part("Floor", {90, 0, 0});
  scene.level();
  EXPECT_EQ(scene.unmodelled("region where scripts look for players"), 1u);
}

// A velocity held for a while reaches as high as one set once.
TEST(Touches, ALastingPushIsReported) {
  Scene scene;
  const auto pad = scene.part("Pad", {20, 0, 0});
  scene.script(
      "script.Parent.Touched:Connect(function(hit)\n"
      " local root = hit.Parent:FindFirstChild('HumanoidRootPart')\n"
      " if not root or root:FindFirstChild('Push') then return end\n"
      " local push = Instance.new('BodyVelocity') push.Name = 'Push'\n"
      " push.Velocity = Vector3.new(0, 60, 0) push.MaxForce = Vector3.new(0, 1e5, 0)\n"
      " push.Parent = root task.wait(0.6) push:Destroy()\nend)",
      pad);
  scene.level();
  ASSERT_TRUE(scene[pad].jumpPad);
  EXPECT_NEAR(scene[pad].jumpPad->velocity.y, 133, 3);
  EXPECT_EQ(scene.unmodelled("push that lasts"), 1u);
}

TEST(Touches, ASearchBoxOfAPartIsThePart) {
  const char* const looks[] = {
      "workspace:GetPartBoundsInBox(frame, size)",
      "workspace:FindPartsInRegion3(Region3.new(frame.Position - size / 2, "
      "frame.Position + size / 2), nil, 50)"};
  for (const char* look : looks) {
    Scene scene;
    const auto zone = scene.part("Zone", {20, 3, 0});
    scene.set(zone, "Size", Vec3{6, 6, 6});
    scene.set(zone, "CanCollide", false);
    scene.script(
        "local frame, size = script.Parent.CFrame, script.Parent.Size\n"
        "while task.wait(0.1) do\n for _, part in " +
            std::string(look) +
            " do\n  local human = part.Parent:FindFirstChild('Humanoid')\n"
            "  if human then human.Health = 0 end\n end\nend",
        zone);
    scene.level();
    EXPECT_TRUE(scene[zone].kill) << look;
  }
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
