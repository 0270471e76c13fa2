// Conditions: scripts take the branch that the engine's values select.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kWait = "wait that a script computes";

// A barrier, and a script in which the barrier is `b`.
struct Barred : Scene {
  explicit Barred(const std::string& text) {
    script("local b = workspace.Barrier\n" + text, scripts);
  }
  const InstanceId barrier = part("Barrier");
};

TEST(Doubt, UndefinedNamesAreNil) {
  const std::pair<const char*, bool> texts[] = {
      {"if DEBUG then b.CanCollide = false end", true},
      {"if not DEBUG then b.CanCollide = false end", false},
      {"if DEBUG == nil then b.CanCollide = false end", false},
      {"if Settings.open then b.CanCollide = false end", true},
      {"if workspace.Barrier and DEBUG then b.CanCollide = false end", true},
      {"b.CanCollide = not DEBUG", true},
      {"if workspace:FindFirstChild(`Key{1}`) then b.CanCollide = false end", true},
      {"if b.Name == `Bar{'rier'}` then b.CanCollide = false end", false},
      {"if b.Name == 'Barrier' .. `{''}` then b.CanCollide = false end", false}};
  for (const auto& [text, solid] : texts) {
    Barred scene(text);
    scene.level();
    EXPECT_EQ(scene[scene.barrier].solid, solid) << text;
  }
}

TEST(Doubt, EngineNamesAreDefined) {
  const char* const texts[] = {
      "if game and workspace and script and task.wait and Enum.Material "
      "then b.CanCollide = false end",
      "DEBUG = true if DEBUG then b.CanCollide = false end",
      "if Enum.Material.Ice ~= Enum.Material.Wood then b.CanCollide = "
      "false end"};
  for (const char* text : texts) {
    Barred scene(text);
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
    EXPECT_FALSE(scene[scene.barrier].solid) << text;
  }
}

TEST(Doubt, AVariableHasTheValueOfTheTakenBranch) {
  const char* const cases[] = {
      "local y = 5 local function rise() y = 9 end if _G.high then rise() end",
      "local y = 5 if _G.high then if _G.higher then y = 9 end end",
      "local t = {y = 5} if _G.high then t.y = 9 end local y = t.y",
      "local y if _G.high then y = 9 else y = 5 end",
      "local y = _G.height if not y then y = 5 end",
      "local y = _G.height if y == nil then y = 5 end",
      "local y = 5 if math.random() > 0.5 then y = 5 end",
      "local y = 9 if b.Name == 'Barrier' then y = 5 end",
      "local y = 5 for i = 1, 2 do if _G.high then y = 9 break end end"};
  for (const char* text : cases) {
    Barred scene(std::string(text) + "\nb.Position = Vector3.new(0, y, 0)");
    scene.level();
    EXPECT_EQ(scene[scene.barrier].pose.position, (Vec3{0, 5, 0})) << text;
  }
}

TEST(Doubt, AHandlerIsConnectedOnlyIfItsConditionHolds) {
  const std::pair<const char*, bool> cases[] = {
      {"if v.BrickColor == _G.red then v.Touched:Connect(kill) end", false},
      {"if v.Name:match('B[aeiou]r') then v.Touched:Connect(kill) end", true},
      {"if v.Name == _G.name then continue end v.Touched:Connect(kill)", true},
      {"task.spawn(function() if _G.late then v.Touched:Connect(kill) end end)", false},
      {"if _G.client then return end v.Touched:Connect(kill)", true},
      {"if _G.client then return end task.spawn(function() v.Touched:Connect(kill) end)", true},
      {"if v.Name == 'Barrier' then v.Touched:Connect(kill) end", true},
      {"if v.Name ~= 'Barrier' then continue end v.Touched:Connect(kill)", true}};
  for (const auto& [text, kills] : cases) {
    Barred scene(
        "local function kill(hit) local h = hit.Parent:FindFirstChild('Humanoid')\n"
        "if h then h.Health = 0 end end\n"
        "for _, v in workspace:GetChildren() do " +
        std::string(text) + " end");
    scene.level();
    EXPECT_EQ(scene[scene.barrier].kill.has_value(), kills) << text;
  }
}

TEST(Doubt, AValueThatAllBranchesShareIsKnown) {
  const char* const values[] = {"if math.random() > 0.5 then 30 else 30",
                                "math.random() > 0.5 and 30 or 30",
                                "nothing or 30",
                                "script:GetAttribute('Missing') or 30",
                                "workspace and 30 or 99",
                                "nil and 99 or 30"};
  for (const char* value : values) {
    Scene scene;
    const auto part = scene.part("Part");
    scene.script("local n = " + std::string(value) +
                     "\nscript.Parent.Touched:Connect(function(h) h.Parent.Humanoid:TakeDamage(n) "
                     "end)",
                 part);
    scene.level();
    ASSERT_TRUE(scene[part].kill) << value;
    EXPECT_FLOAT_EQ(scene[part].kill->damage, 30) << value;
  }
}

TEST(Doubt, ReturnAndBreakEndOnlyTheirFunctionOrLoop) {
  const char* const texts[] = {
      "local function f() if math.random() > 0.5 then return end end f() b:Destroy()",
      "for i = 1, 2 do if math.random() > 0.5 then break end end b:Destroy()",
      "for i = 1, 2 do if i > 5 then return end end b:Destroy()"};
  for (const char* text : texts) {
    Barred scene(text);
    EXPECT_TRUE(scene.level().parts.empty()) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(Doubt, IsStudioIsFalseForPlayers) {
  const char* const texts[] = {
      "if game:GetService('RunService'):IsStudio() then return end b.CanCollide = false",
      "local run = game:GetService('RunService') b.CanCollide = run:IsStudio()"};
  for (const char* text : texts) {
    Barred scene(text);
    scene.level();
    EXPECT_FALSE(scene[scene.barrier].solid) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(Doubt, AListKeepsElementsAtCountedIndices) {
  Scene scene;
  const auto first = scene.part("R1"), second = scene.part("R2", {9, 0, 0});
  const auto other = scene.part("S", {18, 0, 0});
  scene.script(
      "local n, list = 0, {} for _, v in pairs(workspace:GetChildren()) do "
      "if v.Name:match('R[%d]') then n = n + 1 list[n] = v end end "
      "for _, v in ipairs(list) do v.Touched:Connect(function(hit) "
      "hit.Parent.Humanoid.Health = 0 end) end",
      scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[first].kill);
  EXPECT_TRUE(scene[second].kill);
  EXPECT_FALSE(scene[other].kill);
}

TEST(Doubt, AHandlerConnectedOnceIsCertain) {
  const char* const conditions[] = {
      "local hooked = {} local function setup(v) if not hooked[v] then hooked[v] = true ",
      "local function setup(v) if typeof(v) == 'Instance' and v:IsA('BasePart') then ",
      "local function setup(v) if v.Name:sub(1, #'Barr') == 'Barr' then "};
  for (const char* text : conditions) {
    Barred scene(std::string(text) +
                 "v.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end) end end "
                 "setup(b)");
    scene.level();
    EXPECT_TRUE(scene[scene.barrier].kill) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(Doubt, AScriptKnowsWhetherItRunsOnTheServer) {
  const char* const texts[] = {
      "local run = game:GetService('RunService') if run:IsServer() then b.CanCollide = false end",
      "if game:GetService('RunService'):IsClient() then return end b.CanCollide = false"};
  for (const char* text : texts) {
    Barred scene(text);
    scene.level();
    EXPECT_FALSE(scene[scene.barrier].solid) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
  Barred scene("if game:GetService('RunService'):IsClient() then b.CanCollide = false end");
  EXPECT_TRUE(scene.level().unmodelled.empty());
  EXPECT_TRUE(scene[scene.barrier].solid);
}

TEST(Doubt, ACharacterScriptThatFindsItsHumanoidIsCertain) {
  Scene scene;
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto folder = scene.add("StarterCharacterScripts", "StarterCharacterScripts", player);
  scene.script(
      "local h = script.Parent:WaitForChild('Humanoid')\nif not h then return end\n"
      "h.WalkSpeed = 30",
      folder);
  EXPECT_FLOAT_EQ(scene.level().world.walkSpeed, 30);
}

TEST(Doubt, AClickedMotionBelongsToItsButton) {
  Scene scene;
  const auto lift = scene.part("Lift", {20, 0, 0});
  scene.add("ClickDetector", "ClickDetector", lift);
  scene.script(
      "workspace.Lift.ClickDetector.MouseClick:Wait()\n"
      "game:GetService('TweenService'):Create(workspace.Lift, TweenInfo.new(2), "
      "{Position = Vector3.new(0, 50, 0)}):Play()",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[lift].motion);
  EXPECT_EQ(scene[lift].motion->trigger, importer::MotionTrigger::signal);
}

TEST(Doubt, KnownWaitsRaiseNoDoubt) {
  const char* const texts[] = {
      "wait() p.Touched:Connect(function() wait(p.Pause.Value) p.CanCollide = false end)",
      "game.Players.PlayerAdded:Wait() game:GetService('RunService').Heartbeat:Wait() "
      "while true do wait(2) p.CanCollide = false wait(1) p.CanCollide = true end"};
  for (const char* text : texts) {
    Scene scene;
    const auto part = scene.part("Part");
    scene.value("NumberValue", "Pause", 2.0, part);
    scene.script("local p = script.Parent " + std::string(text), part);
    scene.level();
    ASSERT_TRUE(scene[part].vanish) << text;
    EXPECT_EQ(scene.evidence(part, "vanish").rfind("script", 0), 0u) << text;
    EXPECT_EQ(scene.unmodelled(kWait), 0u) << text;
  }
}

// Polling once a second is slower than a player who crosses the part.
TEST(Doubt, PollingADistanceHarmsNearThePart) {
  Scene scene;
  const auto part = scene.part("Part", {20, 0, 0});
  scene.script(
      "while wait(1) do for _, player in game.Players:GetPlayers() do\n"
      "if (player.Character.HumanoidRootPart.Position - workspace.Part.Position).Magnitude < 5 "
      "then player.Character.Humanoid:TakeDamage(10) end end end",
      scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[part].kill);
  EXPECT_FLOAT_EQ(scene[part].kill->damage, 10);
  EXPECT_NEAR(scene[part].kill->cooldown, 1, 0.05);
}

TEST(Doubt, AScriptWithoutItsModuleIsNamed) {
  Scene scene;
  scene.part("Part", {20, 0, 0});
  scene.script("for _, p in pairs(require(script.Parts)) do p.Touched:Connect(print) end",
               scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("script that fails"), 1u);
}

}  // namespace
}  // namespace obby::test
