// Kill parts and damage parts, as real places script them.
#include <string>
#include <utility>

#include "import/scene.h"

namespace obby::test {
namespace {

const char* const kKillScript = R"(script.Parent.Touched:connect(function(hit)
	if hit and hit.Parent and hit.Parent:FindFirstChild("Humanoid") then
		hit.Parent.Humanoid.Health = 0
	end
end)
)";

TEST(Kill, ScriptInThePartWithItsLineAsEvidence) {
  Scene scene;
  const auto lava = scene.part("Smooth Block Model"), safe = scene.part("Part");
  scene.script(kKillScript, lava, "KillScript");
  scene.level();
  ASSERT_TRUE(scene[lava].kill);
  EXPECT_GE(scene[lava].kill->damage, 100);
  EXPECT_EQ(scene.evidence(lava, "kill"),
            "script KillScript line 3: hit.Parent.Humanoid.Health = 0");
  EXPECT_FALSE(scene[safe].kill);
}

TEST(Kill, EveryMethodOfTakingHealthIsRecognised) {
  const std::pair<const char*, float> statements[] = {
      {"h.Health = h.Health - 30", 30},
      {"h.Health -= 10", 10},
      {"h:TakeDamage(25)", 25},
      {"h:TakeDamage(script.Parent.Damage.Value)", 42},
      {"h:TakeDamage(script.Parent:GetAttribute('Harm'))", 7},
      {"h:TakeDamage(h.MaxHealth)", 100},
      {"h.Health = 0", 100},
      {"h.Health = h.Health - h.Health", 100},
      {"hit.Parent:BreakJoints()", 100}};
  for (const auto& [statement, damage] : statements) {
    Scene scene;
    const auto part = scene.part("Part");
    scene.value("NumberValue", "Damage", 42.0, part);
    scene.attribute(part, "Harm", 7.0);
    scene.script(
        "local function onTouch(hit)\n local h = hit.Parent:FindFirstChildOfClass('Humanoid')\n"
        " if h ~= nil then " +
            std::string(statement) +
            " end\nend\n"
            "script.Parent.Touched:Connect(onTouch)",
        part);
    scene.level();
    ASSERT_TRUE(scene[part].kill) << statement;
    EXPECT_FLOAT_EQ(scene[part].kill->damage, damage) << statement;
  }
}

TEST(Kill, PartsThatALoopSkipsAreSafe) {
  const char* const loops[] = {
      "for _, v in workspace.Stage:GetChildren() do if v.Name == 'Safe' then continue end "
      "v.Touched:Connect(kill) end",
      "local all = workspace.Stage:GetChildren() for i = 1, #all do "
      "if all[i].Name == 'Safe' then continue end all[i].Touched:Connect(kill) end",
      "for _, v in workspace.Stage:GetChildren() do repeat if v.Name == 'Safe' then break end "
      "v.Touched:Connect(kill) until true end"};
  for (const char* loop : loops) {
    Scene scene;
    const auto stage = scene.add("Folder", "Stage", scene.workspace);
    const auto first = scene.part("Red", {}, stage), safe = scene.part("Safe", {}, stage),
               last = scene.part("Red", {}, stage);
    scene.script("local function kill(h) h.Parent.Humanoid.Health = 0 end\n" + std::string(loop),
                 scene.scripts);
    scene.level();
    EXPECT_TRUE(scene[first].kill) << loop;
    EXPECT_FALSE(scene[safe].kill) << loop;
    EXPECT_TRUE(scene[last].kill) << loop;
  }
}

TEST(Kill, CodeAfterAWaitingLoopIsRead) {
  const std::string behind = "\nworkspace.Red.Touched:Connect(kill)";
  const std::string texts[] = {
      "repeat task.wait() until workspace:FindFirstChild('Red')" + behind,
      "repeat wait() until game:IsLoaded()" + behind,
      "while not game:IsLoaded() do task.wait() end" + behind,
      "for _, v in next, workspace:GetChildren() do v.Touched:Connect(kill) end"};
  for (const std::string& text : texts) {
    Scene scene;
    const auto red = scene.part("Red");
    scene.script("local function kill(h) h.Parent.Humanoid.Health = 0 end\n" + text, scene.scripts);
    scene.level();
    EXPECT_TRUE(scene[red].kill) << text;
  }
}

TEST(Kill, WaitAfterTheHitIsTheCooldown) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(R"(local debounce = false
script.Parent.Touched:Connect(function(hit)
  if debounce then return end
  local h = hit.Parent:FindFirstChild("Humanoid")
  if not h then return end
  debounce = true
  h:TakeDamage(20)
  task.wait(0.5)
  debounce = false
end))",
               part);
  scene.level();
  ASSERT_TRUE(scene[part].kill);
  EXPECT_FLOAT_EQ(scene[part].kill->damage, 20);
  EXPECT_NEAR(scene[part].kill->cooldown, 0.5f, 0.04f);
}

TEST(Kill, DisabledAndStoredScriptsDoNothing) {
  Scene scene;
  const auto part = scene.part("Part"), other = scene.part("Other");
  scene.set(scene.script(kKillScript, part), "Disabled", true);
  const auto local = scene.add("LocalScript", "Local", other);
  scene.set(local, "Source", std::string(kKillScript));
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  scene.script("workspace.Other.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 end)",
               storage);
  scene.level();
  EXPECT_FALSE(scene[part].kill);
  EXPECT_FALSE(scene[other].kill);
}

TEST(Kill, CommentsAndStringsAreNotCode) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script(
      "--[[ script.Parent.Touched:Connect(function(h) h.Health = 0 end) ]]\n"
      "-- script.Parent.Touched:Connect(function(h) h.Health = 0 end)\n"
      "print('script.Parent.Touched:Connect(function(h) h.Health = 0 end)')",
      part);
  scene.level();
  EXPECT_FALSE(scene[part].kill);
}

TEST(Kill, CentralScriptOverAFolder) {
  Scene scene;
  const auto folder = scene.add("Folder", "Bad", scene.workspace);
  const auto one = scene.part("A", {}, folder), two = scene.part("B", {}, folder);
  const auto free = scene.part("C");
  scene.script(R"(for _, part in pairs(workspace.Bad:GetChildren()) do
  if part:IsA("BasePart") then
    part.Touched:Connect(function(hit)
      local humanoid = hit.Parent:FindFirstChild("Humanoid")
      if humanoid then humanoid.Health = 0 end
    end)
  end
end)",
               scene.scripts, "Central");
  scene.level();
  EXPECT_TRUE(scene[one].kill);
  EXPECT_TRUE(scene[two].kill);
  EXPECT_FALSE(scene[free].kill);
  EXPECT_EQ(scene.evidence(two, "kill").rfind("script Central line 5", 0), 0u);
}

TEST(Kill, CentralScriptThatFiltersByName) {
  Scene scene;
  const auto stage = scene.add("Model", "Stage", scene.workspace);
  const auto kill = scene.part("Kill", {}, stage), plain = scene.part("Floor", {}, stage);
  scene.script(R"(local function setUp(part)
  part.Touched:Connect(function(hit)
    hit.Parent.Humanoid.Health = 0
  end)
end
for i, v in ipairs(workspace:GetDescendants()) do
  if v.Name == "Kill" and v:IsA("Part") then setUp(v) end
end)",
               scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[kill].kill);
  EXPECT_FALSE(scene[plain].kill);
}

TEST(Kill, ADotNameMeansTheFirstChildOnly) {
  Scene scene;
  const auto model = scene.add("Model", "KillBlocks", scene.workspace);
  scene.script(
      "workspace.KillBlocks.Part.Touched:Connect(function(hit)\n"
      "  if hit.Parent:FindFirstChild('Humanoid') then hit.Parent.Humanoid.Health = 0 end\n"
      "end)",
      model, "kill");
  const auto first = scene.part("Part", {}, model), second = scene.part("Part", {9, 0, 0}, model);
  const auto& level = scene.level();
  EXPECT_TRUE(scene[first].kill);
  EXPECT_FALSE(scene[second].kill);
  EXPECT_EQ(level.ignored.at("name that suggests a kill part").count, 1u);
}

TEST(Kill, PollingTheContentsOfAHazard) {
  Scene scene;
  const auto zone = scene.part("Zone"), other = scene.part("Other");
  scene.script(R"(local zone = workspace.Zone
while true do
  for _, part in workspace:GetPartsInPart(zone) do
    local humanoid = part.Parent:FindFirstChild("Humanoid")
    if humanoid then humanoid:TakeDamage(5) end
  end
  task.wait(0.5)
end)",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[zone].kill);
  EXPECT_FLOAT_EQ(scene[zone].kill->damage, 5);
  EXPECT_NEAR(scene[zone].kill->cooldown, 0.5, 0.04);
  EXPECT_FALSE(scene[other].kill);
}

TEST(Kill, HarmByExplosions) {
  const std::string made = "local e = Instance.new('Explosion') ";
  const std::pair<std::string, bool> cases[] = {
      {made + "e.Position = p.Position e.Parent = workspace p:Destroy()", true},
      {"local e = Instance.new('Explosion', workspace) e.Position = p.Position", true},
      {made + "e.Position = p.Position e.Parent = hit.Parent", true},
      {made + "e.Parent = workspace", false},  // at the origin
      {made + "e.Position = p.Position e.DestroyJointRadiusPercent = 0 e.Parent = workspace",
       false},
      {made + "e.Position = p.Position e.Parent = game.ServerStorage", false}};
  for (const auto& [text, harms] : cases) {
    Scene scene;
    const auto mine = scene.part("Mine", {40, 0, 0});
    scene.script("local p = script.Parent p.Touched:Connect(function(hit)\np.Transparency = 0.5 " +
                     text + " end)",
                 mine);
    scene.level();
    EXPECT_EQ(scene[mine].kill.has_value(), harms) << text;
  }
}

TEST(Kill, AScriptOverridesATag) {
  Scene scene;
  const auto part = scene.part("KillBrick");
  scene.tag(part, "DamageBrick");
  scene.attribute(part, "Damage", 3.0);
  scene.script(kKillScript, part);
  scene.level();
  EXPECT_FLOAT_EQ(scene[part].kill->damage, 100);
  EXPECT_EQ(scene[part].evidence.size(), 1u);
}

TEST(Kill, ACheckpointThatSendsThePlayerBackIsNoKillPart) {
  Scene scene;
  const auto part = scene.part("Checkpoint");
  scene.tag(part, "Checkpoint");
  scene.script(kKillScript, part);
  scene.level();
  EXPECT_FALSE(scene[part].kill);
}

}  // namespace
}  // namespace obby::test
