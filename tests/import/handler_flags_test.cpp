// Handlers that a flag keeps from a second time: what they did goes on in the level, which says so.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kOnce = "handler that works only once";

const std::string kGoesAndComesBack = "p.CanCollide = false wait(3) p.CanCollide = true ";

TEST(HandlerFlags, WhatIsNeverSetBackIsNamed) {
  const std::string touches[] = {
      "local done = false p.Touched:Connect(function(hit)\nif done then return end done = true " +
          kGoesAndComesBack + "end)",
      "local ready = true p.Touched:Connect(function(hit)\nif not ready then return end " +
          kGoesAndComesBack + "ready = false end)",
      "local used p.Touched:Connect(function(hit)\nlocal h = hit.Parent:FindFirstChild('Humanoid') "
      "if h and not used then used = true h.Health = 0 end end)",
      "debounce = false function onTouch(hit)\nif debounce == false then debounce = true "
      "hit.Velocity = Vector3.new(0, 90, 0) end end p.Touched:connect(onTouch)",
      "local done = false p.Touched:Connect(function(hit)\nif done or not hit.Parent then return "
      "end if hit.Parent:FindFirstChild('Humanoid') then done = true " +
          kGoesAndComesBack + "end end)",
      "local open = true p.Touched:Connect(function(hit)\nif open ~= nil then open = nil "
      "task.spawn(function() " +
          kGoesAndComesBack + "end) end end)"};
  for (const std::string& touch : touches) {
    ScriptedPart scene(touch);
    const PartDraft& pad = scene[scene.self];
    EXPECT_TRUE(pad.vanish || pad.kill || pad.jumpPad) << touch;
    ASSERT_EQ(scene.unmodelled(kOnce), 1u) << touch;
    const auto& entry = scene.level().unmodelled.at(kOnce);
    EXPECT_EQ(entry.example, "Workspace/Pad") << touch;
    EXPECT_NE(entry.note.find("script Script line 3"), std::string::npos) << entry.note;
  }
}

TEST(HandlerFlags, WhatIsSetBackComesAgain) {
  const std::string begin = "local busy = false p.Touched:Connect(function(hit)\n";
  const std::string guarded = "if busy then return end busy = true " + kGoesAndComesBack;
  const std::string touches[] = {
      begin + guarded + "busy = false end)",
      begin + guarded + "task.delay(1, function() busy = false end) end)",
      begin + guarded + "end) p.TouchEnded:Connect(function() busy = false end)",
      begin + guarded + "end) while true do wait(9) busy = false end",
      begin + guarded + "end) local function reset() busy = not busy end spawn(reset)",
      begin + "if not busy then busy = true " + kGoesAndComesBack + "wait(1) busy = false end end)",
      "p.Touched:Connect(function(hit) local busy = false " + guarded + "end)",
      "local busy = false p.Touched:Connect(function(hit) local busy = busy " + guarded + "end)"};
  for (const std::string& touch : touches) {
    ScriptedPart scene(touch);
    ASSERT_TRUE(scene[scene.self].vanish) << touch;
    EXPECT_NEAR(scene[scene.self].vanish->away, 3, 0.04) << touch;
    EXPECT_EQ(scene.unmodelled(kOnce), 0u) << touch;
  }
}

TEST(HandlerFlags, WhatNoFlagGuardsComesAgain) {
  const std::string touches[] = {
      "local seen = false p.Touched:Connect(function(hit) if not seen then seen = true print('x') "
      "end " +
          kGoesAndComesBack + "end)",
      "local seen = false local function greet() if seen then return end seen = true print('x') "
      "end p.Touched:Connect(function(hit) greet() " +
          kGoesAndComesBack + "end)",
      "local kOn = true p.Touched:Connect(function(hit) if not kOn then return end " +
          kGoesAndComesBack + "end)",
      "local open = false workspace.Changed:Connect(function() open = true end) "
      "p.Touched:Connect(function(hit) if open then return end " +
          kGoesAndComesBack + "end)",
      "local done = false p.Touched:Connect(function(hit) if done then return end done = true "
      "p:Destroy() end)"};
  for (const std::string& touch : touches) {
    ScriptedPart scene(touch);
    EXPECT_EQ(scene.unmodelled(kOnce), 0u) << touch;
  }
}

// A part, and a script on it with a value object `Done`, which calls the part `p`.
struct Valued : Scene {
  explicit Valued(const std::string& text) {
    const auto own = script("local p = script.Parent\n" + text, self);
    value("BoolValue", "Done", false, own);
    level();
  }
  const InstanceId self = part("Pad");
};

TEST(HandlerFlags, TheyMayBeFieldsValuesAndAttributes) {
  struct Case {
    std::string before, asks, sets, setsBack;
  };
  const Case cases[] = {
      {"local s = {done = false}", "s.done", "s.done = true", "s.done = false"},
      {"local s = {}", "s['done']", "s.done = true", "s['done'] = nil"},
      {"local s = {done = false}", "s.done == true", "s.done = true", "s = {done = false}"},
      {"local s = {at = {}}", "s.at.done", "s.at.done = true", "s.at.done = false"},
      {"", "script.Done.Value", "script.Done.Value = true", "script.Done.Value = false"},
      {"local done = script:WaitForChild('Done')", "done.Value", "done.Value = true",
       "script:FindFirstChild('Done').Value = false"},
      {"", "p:GetAttribute('Done')", "p:SetAttribute('Done', true)",
       "p:SetAttribute('Done', nil)"}};
  for (const Case& now : cases) {
    const std::string touch = now.before + " p.Touched:Connect(function(hit)\nif " + now.asks +
                              " then return end " + now.sets + " " + kGoesAndComesBack;
    Valued once(touch + "end)");
    EXPECT_TRUE(once[once.self].vanish) << touch;
    EXPECT_EQ(once.unmodelled(kOnce), 1u) << touch;
    Valued again(touch + now.setsBack + " end)");
    EXPECT_TRUE(again[again.self].vanish) << touch;
    EXPECT_EQ(again.unmodelled(kOnce), 0u) << touch << now.setsBack;
    Valued later(touch + "end) workspace.Changed:Connect(function() " + now.setsBack + " end)");
    EXPECT_EQ(later.unmodelled(kOnce), 0u) << touch << now.setsBack;
  }
}

TEST(HandlerFlags, WhatEachTouchMakesAnewKeepsItFromNothing) {
  const char* const touches[] = {
      "p.Touched:Connect(function(hit) local s = {} if s.done then return end s.done = true ",
      "p.Touched:Connect(function(hit) if hit.Parent:GetAttribute('Done') then return end\n"
      "hit.Parent:SetAttribute('Done', true) "};
  for (const char* touch : touches) {
    ScriptedPart scene(touch + kGoesAndComesBack + "end)");
    EXPECT_TRUE(scene[scene.self].vanish) << touch;
    EXPECT_EQ(scene.unmodelled(kOnce), 0u) << touch;
  }
}

// Which of them comes first nobody knows.
TEST(HandlerFlags, PartsThatShareAFlagAreReadAlike) {
  for (const char* flag : {"done", "state.done"}) {
    Scene scene;
    const auto folder = scene.add("Folder", "Pads", scene.workspace);
    const InstanceId pads[] = {scene.part("A", {}, folder), scene.part("B", {9, 0, 0}, folder)};
    scene.script(
        "local done, state = false, {} for _, p in workspace.Pads:GetChildren() do\n"
        "p.Touched:Connect(function() if " +
            std::string(flag) + " then return end " + flag + " = true " + kGoesAndComesBack +
            "end) end",
        scene.scripts);
    scene.level();
    for (const InstanceId pad : pads) EXPECT_TRUE(scene[pad].vanish) << flag << pad;
    EXPECT_EQ(scene.unmodelled(kOnce), 2u) << flag;
  }
}

// It begins anew with the next life.
TEST(HandlerFlags, WhatKillsOnceEachCharacterKills) {
  for (const bool ofCharacter : {false, true}) {
    Scene scene;
    const auto red = scene.part("Red");
    const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
    const auto folder = scene.add("StarterCharacterScripts", "StarterCharacterScripts", player);
    scene.script(
        "local dead = false workspace.Red.Touched:Connect(function(hit) if dead then return end "
        "dead = true hit.Parent.Humanoid.Health = 0 end)",
        ofCharacter ? folder : scene.scripts);
    scene.level();
    EXPECT_TRUE(scene[red].kill) << ofCharacter;
    EXPECT_EQ(scene.unmodelled(kOnce), ofCharacter ? 0u : 1u);
  }
}

TEST(HandlerFlags, FlagsOfEachCharacterAreNone) {
  ScriptedPart scene(
      "game.Players.PlayerAdded:Connect(function(player) player.CharacterAdded:Connect(function()\n"
      "local done = false p.Touched:Connect(function() if done then return end done = true " +
      kGoesAndComesBack + "end) end) end)");
  EXPECT_TRUE(scene[scene.self].vanish);
  EXPECT_EQ(scene.unmodelled(kOnce), 0u);
}

}  // namespace
}  // namespace obby::test
