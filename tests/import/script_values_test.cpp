// Values that scripts compute. Known values are used; unknown values are noted, not guessed.
#include <string>
#include <utility>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

TEST(ScriptValues, NilIsNil) {
  const std::pair<const char*, bool> cases[] = {
      {"if workspace:FindFirstChild('Missing') ~= nil then p.CanCollide = false end", true},
      {"if workspace:FindFirstChild('Missing') == nil then p.CanCollide = false end", false},
      {"local x if x == nil then p.CanCollide = false end", false},
      {"local x, y if x ~= y then p.CanCollide = false end", true}};
  for (const auto& [text, solid] : cases) {
    ScriptedPart scene(text);
    EXPECT_EQ(scene[scene.self].solid, solid) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(ScriptValues, AFunctionCanReturnEitherOfTwoValues) {
  const char* const functions[] = {
      "if hit.Parent:FindFirstChild('Humanoid') then return true end return false",
      "if not hit.Parent:FindFirstChild('Humanoid') then return false end return true",
      "local m = hit.Parent if m:FindFirstChild('Humanoid') then return m.Humanoid end return nil"};
  for (const char* function : functions) {
    ScriptedPart scene("local function isPlayer(hit) " + std::string(function) +
                       " end\np.Touched:Connect(function(hit)\n"
                       "if isPlayer(hit) then hit.Parent.Humanoid.Health = 0 end end)");
    EXPECT_TRUE(scene[scene.self].kill) << function;
  }
  ScriptedPart early(
      "local function place() if _G.closed then return nil end return Vector3.new(0, 7, 0) end\n"
      "p.Position = place()");
  EXPECT_EQ(early[early.self].pose.position, (Vec3{0, 7, 0}));
}

TEST(ScriptValues, ClampedHealthReductionIsHarm) {
  const char* const statements[] = {"h.Health = math.max(0, h.Health - 30)",
                                    "h.Health = math.max(h.Health - 30, 0)",
                                    "h.Health = math.clamp(h.Health - 30, 0, h.MaxHealth)",
                                    "h.Health = math.min(h.Health - 30, h.MaxHealth)"};
  for (const char* statement : statements) {
    ScriptedPart scene("p.Touched:Connect(function(hit) local h = hit.Parent.Humanoid\n" +
                       std::string(statement) + " end)");
    ASSERT_TRUE(scene[scene.self].kill) << statement;
    EXPECT_FLOAT_EQ(scene[scene.self].kill->damage, 30) << statement;
  }
}

// Returns a script that runs the text `statement` when the part is touched. `h` is the character's
// humanoid.
std::string touchThat(const std::string& statement) {
  return "p.Touched:Connect(function(hit) local h = hit.Parent.Humanoid\n"
         "p.Transparency = 0.5 " +
         statement + " end)";
}

TEST(ScriptValues, ClampedHealingIsNotHarm) {
  const char* const statements[] = {"h.Health = math.min(h.Health + 20, h.MaxHealth)",
                                    "h.Health = math.min(h.MaxHealth, h.Health + 20)",
                                    "h.Health = math.min(h.Health + 20, 100)",
                                    "h.Health = math.clamp(h.Health + 20, 0, h.MaxHealth)"};
  for (const char* statement : statements) {
    ScriptedPart scene(touchThat(statement));
    EXPECT_FALSE(scene[scene.self].kill) << statement;
    EXPECT_EQ(scene.unmodelled("damage that a script computes"), 0u) << statement;
  }
}

TEST(ScriptValues, HarmCanBeAFractionOfHealth) {
  const std::pair<const char*, float> statements[] = {{"h:TakeDamage(h.MaxHealth / 4)", 25},
                                                      {"h.Health -= h.MaxHealth * 0.5", 50},
                                                      {"h:TakeDamage(h.MaxHealth)", 100},
                                                      {"h:TakeDamage(h.MaxHealth * 2)", 100},
                                                      {"h.Health -= h.MaxHealth", 100}};
  for (const auto& [statement, damage] : statements) {
    ScriptedPart scene("p.Touched:Connect(function(hit) local h = hit.Parent.Humanoid\n" +
                       std::string(statement) + " end)");
    ASSERT_TRUE(scene[scene.self].kill) << statement;
    EXPECT_FLOAT_EQ(scene[scene.self].kill->damage, damage) << statement;
  }
}

TEST(ScriptValues, APoseCanHaveSevenNumbers) {
  ScriptedPart scene("local s = math.sqrt(0.5) p.CFrame = CFrame.new(1, 2, 3, 0, s, 0, s)");
  expectNear(scene[scene.self].pose.position, {1, 2, 3}, 1e-4f);
  expectNear(scene[scene.self].pose.rotation.x, {0, 0, -1}, 1e-4f);
  expectNear(scene[scene.self].pose.rotation.y, {0, 1, 0}, 1e-4f);
}

TEST(ScriptValues, MinAndMaxTakeManyArguments) {
  ScriptedPart scene("p.Position = Vector3.new(math.min(4, 3, 2), math.max(1, 2, 7), 0)");
  EXPECT_EQ(scene[scene.self].pose.position, (Vec3{2, 7, 0}));
}

TEST(ScriptValues, ScriptedAttributesAreReadBack) {
  const std::pair<const char*, bool> cases[] = {
      {"p:SetAttribute('Open', true) p.CanCollide = not p:GetAttribute('Open')", false},
      {"p:SetAttribute('Shut', nil) if p:GetAttribute('Shut') then p.CanCollide = false end",
       true}};
  for (const auto& [text, solid] : cases) {
    Scene scene;
    const auto part = scene.part("Gate");
    scene.attribute(part, "Shut", true);
    scene.script("local p = workspace.Gate\n" + std::string(text), scene.scripts);
    scene.level();
    EXPECT_EQ(scene[part].solid, solid) << text;
  }
}

// The part is harmless at the moment when a player first arrives.
TEST(ScriptValues, IntermittentHarmIsHarm) {
  const char* const texts[] = {
      "task.spawn(function() while true do p:SetAttribute('On', true) wait(2)\n"
      "p:SetAttribute('On', false) wait(2) end end)\n"
      "p.Touched:Connect(function(h) if p:GetAttribute('On') then\n"
      "h.Parent.Humanoid.Health = 0 end end)",
      "p.Touched:Connect(function(hit) if p.BrickColor == BrickColor.new('Really red') then\n"
      "hit.Parent.Humanoid.Health = 0 end end)\n"
      "while true do p.BrickColor = BrickColor.new('Really red') wait(2)\n"
      "p.BrickColor = BrickColor.new('Lime green') wait(2) end"};
  for (const char* text : texts) {
    ScriptedPart scene(text);
    EXPECT_TRUE(scene[scene.self].kill) << text;
    EXPECT_EQ(scene.unmodelled("touch with a later effect"), 1u) << text;
  }
}

TEST(ScriptValues, ADelayedFunctionReceivesItsArguments) {
  const char* const calls[] = {"task.delay(3, back, p, true)",
                               "task.delay(3, function(part) part.CanCollide = true end, p)"};
  for (const char* call : calls) {
    ScriptedPart scene(
        "local function back(part, on) part.CanCollide = on end\n"
        "p.Touched:Connect(function() p.CanCollide = false " +
        std::string(call) + " end)");
    ASSERT_TRUE(scene[scene.self].vanish) << call;
    EXPECT_NEAR(scene[scene.self].vanish->away, 3, 1e-3) << call;
  }
}

// Scripts select parts by properties and tags, with and without the service in the file.
TEST(ScriptValues, MaterialsAndTagsOfPartsAreKnown) {
  const char* const asks[] = {"tags:HasTag(v, 'Ouchie')",
                              "v:HasTag('Ouchie')",
                              "v.Material == Enum.Material.CrackedLava",
                              "v.Material.Name == 'CrackedLava'",
                              "v.Material ~= Enum.Material.Plastic",
                              "table.find({'Lava', 'Red'}, v.Name)",
                              "not table.find({'Plain'}, v.Name)",
                              "v.Name:match('^R')",
                              "not v:IsDescendantOf(workspace.Safe)",
                              "string.find(v.Name, '^Re') == 1",
                              "v.BrickColor == BrickColor.new('Really red')",
                              "v.BrickColor ~= BrickColor.new(194)",
                              "v.BrickColor.Name == 'Really red'",
                              "v.Color == Color3.fromRGB(255, 0, 0)",
                              "v.Color == Color3.new(1, 0, 0)",
                              "v.Color ~= Color3.new(163 / 255, 162 / 255, 165 / 255)",
                              "v.Color == BrickColor.new('Really red').Color",
                              "v.Color.R == 1"};
  for (const char* ask : asks)
    for (const bool service : {false, true}) {
      Scene scene;
      if (service) scene.add("CollectionService", "CollectionService", kNoInstance);
      const auto safe = scene.add("Folder", "Safe", scene.workspace);
      const auto red = scene.part("Red"), plain = scene.part("Plain", {9, 0, 0}, safe);
      scene.tag(red, "Ouchie");
      scene.set(red, "Material", EnumItem{804, ""});
      scene.set(red, "Color", ColorRgb{255, 0, 0});
      scene.script(
          "local tags = game:GetService('CollectionService')\n"
          "for _, v in workspace:GetDescendants() do if v:IsA('BasePart') and " +
              std::string(ask) +
              " then\nv.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end) end end",
          scene.scripts);
      scene.level();
      EXPECT_TRUE(scene[red].kill) << ask;
      EXPECT_FALSE(scene[plain].kill) << ask;
      EXPECT_TRUE(scene.level().unmodelled.empty()) << ask;
    }
}

TEST(ScriptValues, ATweenedColourTakesTime) {
  ScriptedPart scene(
      "local red = Color3.fromRGB(255, 0, 0)\n"
      "game:GetService('TweenService'):Create(p, TweenInfo.new(9), {Color = red}):Play()\n"
      "if p.Color == red then p.Touched:Connect(function(hit)\n"
      "hit.Parent.Humanoid.Health = 0 end) end");
  EXPECT_FALSE(scene[scene.self].kill);
}

// The script treats the light as a signal that tells players when to walk.
TEST(ScriptValues, ALightKeepsItsScriptedColour) {
  Scene scene;
  const auto pad = scene.part("Pad");
  scene.add("PointLight", "Light", pad);
  scene.script(
      "local p, light = script.Parent, script.Parent.Light light.Color = Color3.new(0, 1, 0)\n"
      "p.Touched:Connect(function(hit) if light.Color == Color3.new(1, 0, 0) then\n"
      "hit.Parent.Humanoid.Health = 0 end end)",
      pad);
  scene.level();
  EXPECT_FALSE(scene[pad].kill);
}

// The script kills all players except those on a list, such as a door's owners.
TEST(ScriptValues, NoOwnerListContainsThePlayer) {
  const std::pair<std::string, bool> asks[] = {
      {"local owners = {[1234] = true} ^ if owners[player.UserId] then return", true},
      {"local owners = {[12] = true, [34] = true} ^ if owners[player.UserId] then return", true},
      {"local foes = {} ^ if not table.find(foes, player.Name) then return", false}};
  for (const auto& [ask, kills] : asks) {
    const size_t split = ask.find('^');
    ScriptedPart scene(ask.substr(0, split) + "p.Touched:Connect(function(hit)\n" +
                       "local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n" +
                       ask.substr(split + 1) + " end hit.Parent.Humanoid.Health = 0 end)");
    EXPECT_EQ(scene[scene.self].kill.has_value(), kills) << ask;
  }
}

TEST(ScriptValues, PartsCreatedInTheWorldAreBuilt) {
  const std::pair<const char*, uint32_t> cases[] = {
      {"local bridge = Instance.new('Part', workspace) bridge.Anchored = true", 1},
      {"local bridge = Instance.new('Part', p.Parent)", 1},
      {"local bridge = Instance.new('Part', game:GetService('ServerStorage'))", 0},
      {"local bridge = Instance.new('Part', script)", 1},
      {"local weld = Instance.new('Fire', p)", 0}};
  for (const auto& [text, count] : cases) {
    ScriptedPart scene(text);
    EXPECT_EQ(scene.level().parts.size(), 1 + count) << text;
  }
}

}  // namespace
}  // namespace obby::test
