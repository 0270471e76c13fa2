// Whatever is not simulated is named, with counts.
#include <memory>
#include <string>
#include <utility>

#include "import/explain.h"
#include "import/scene.h"

namespace obby::test {
namespace {

// A part whose script moves who touches it by `value`.
InstanceId teleporter(Scene& scene, const std::string& value) {
  const auto from = scene.part("teleporter1a");
  scene.part("teleporter1b", {50, 0, 0});
  scene.script(
      "script.Parent.Touched:Connect(function(hit)\n"
      " local root = hit.Parent:FindFirstChild('HumanoidRootPart')\n"
      " if root then root.CFrame = " +
          value + " end\nend)",
      from);
  return from;
}

TEST(Teleport, ToAPlaceThatTheScriptStates) {
  Scene scene;
  const auto from = teleporter(scene, "workspace.teleporter1b.CFrame + Vector3.new(0, 5, 0)");
  scene.level();
  EXPECT_EQ(scene.unmodelled("teleporter"), 0u);
  ASSERT_TRUE(scene[from].teleport);
  EXPECT_NEAR(scene[from].teleport->position.x, 50, 1e-4);
  EXPECT_NEAR(scene[from].teleport->position.y, 2, 1e-4) << "the root is 3 above the feet";
  EXPECT_TRUE(scene[from].teleport->turns);
}

TEST(Teleport, ToAPlaceFromWhichItLooksBack) {
  Scene scene;
  const auto from = teleporter(scene, "CFrame.new(workspace.teleporter1b.Position, hit.Position)");
  scene.level();
  EXPECT_EQ(scene.unmodelled("teleporter"), 0u);
  ASSERT_TRUE(scene[from].teleport);
  EXPECT_NEAR(scene[from].teleport->position.x, 50, 1e-4);
  EXPECT_TRUE(scene[from].teleport->turns);
}

TEST(Seat, IsOfItsClassUnlessDisabled) {
  Scene scene;
  const auto chair = scene.part("Chair", {}, scene.workspace, "Seat");
  const auto broken = scene.part("Broken", {}, scene.workspace, "Seat");
  scene.set(broken, "Disabled", true);
  scene.level();
  EXPECT_TRUE(scene[chair].seat);
  EXPECT_FALSE(scene[broken].seat);
}

TEST(Unmodelled, ButtonsThatOpenSomethingElse) {
  Scene scene;
  const auto button = scene.part("Button");
  const auto wall = scene.part("Wall");
  scene.script(
      "local wall = workspace.Wall\nscript.Parent.Touched:Connect(function(hit)\n"
      " wall.CanCollide = false\n for i = 10, 1, -1 do task.wait(1) end\n"
      " wall.CanCollide = true\nend)",
      button);
  scene.level();
  EXPECT_EQ(scene.unmodelled("button"), 1u);
  EXPECT_FALSE(scene[wall].vanish);
  EXPECT_FALSE(scene[button].vanish);
}

TEST(Unmodelled, SpeedPadsSeatsToolsTerrainGroups) {
  Scene scene;
  const auto pad = scene.part("Speed");
  scene.script(
      "script.Parent.Touched:Connect(function(hit)\n"
      " hit.Parent.Humanoid.WalkSpeed = 50\n wait(7)\n hit.Parent.Humanoid.WalkSpeed = 16\nend)",
      pad);
  scene.part("Wheel", {}, scene.workspace, "VehicleSeat");
  scene.set(scene.part("Ghost"), "CollisionGroup", std::string("Ghosts"));
  scene.add("Tool", "Sword", scene.workspace);
  const auto terrain = scene.add("Terrain", "Terrain", scene.workspace);
  scene.set(terrain, "SmoothGrid", std::string(1000, 'x'));
  scene.level();
  for (const char* kind :
       {"speed or jump booster", "vehicle seat", "collision group Ghosts", "tool", "terrain"})
    EXPECT_EQ(scene.unmodelled(kind), 1u) << kind;
  const auto voxels = std::make_shared<const std::string>(1000, 'x');
  scene.set(terrain, "SmoothGrid", SharedBlob{voxels});
  scene.level();
  EXPECT_EQ(scene.unmodelled("terrain"), 1u) << "in a shared string";
}

TEST(Unmodelled, StagesBuiltAtRunTimeAndForeignCode) {
  Scene scene;
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  scene.add("Model", "Stage1", storage);
  scene.script(
      "require(123456)\nlocal stage = game.ServerStorage.Stage1:Clone()\n"
      "stage.Parent = workspace\nloadstring('x')()",
      scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("parts that a script builds"), 1u);
  EXPECT_EQ(scene.unmodelled("require of an asset"), 1u);
  EXPECT_EQ(scene.unmodelled("code loaded at run time"), 1u);
}

TEST(Unmodelled, ModulesKitTagsAndTellingNames) {
  Scene scene;
  const auto module = scene.add("ModuleScript", "Traps", scene.scripts);
  scene.set(module, "Source", std::string("return function(p) p.Touched:Connect(print) end"));
  scene.tag(scene.part("Gate"), "OneWayPlatform");
  scene.part("Jump Pad");
  scene.level();
  EXPECT_EQ(scene.unmodelled("module script"), 1u);
  EXPECT_EQ(scene.unmodelled("tag OneWayPlatform"), 1u);
  EXPECT_EQ(scene.unmodelled("name that suggests a jump pad"), 1u);
}

TEST(Unmodelled, HarmByExplosions) {
  const std::string made = "local e = Instance.new('Explosion') ";
  const std::pair<std::string, uint32_t> cases[] = {
      {made + "e.Position = p.Position e.Parent = workspace p:Destroy()", 1},
      {"local e = Instance.new('Explosion', workspace) e.Position = p.Position", 1},
      {made + "e.Parent = hit.Parent", 1},
      {made + "e.Parent = workspace hit.Parent.Humanoid.Health = 0", 0},
      {made + "e.DestroyJointRadiusPercent = 0 e.Parent = workspace", 0},
      {made + "e.Parent = game.ServerStorage", 0}};
  for (const auto& [text, count] : cases) {
    Scene scene;
    const auto mine = scene.part("Mine");
    scene.script("local p = script.Parent p.Touched:Connect(function(hit)\np.Transparency = 0.5 " +
                     text + " end)",
                 mine);
    scene.level();
    EXPECT_EQ(scene.unmodelled("damage that a script computes"), count) << text;
  }
}

TEST(Unmodelled, HarmToWhoEntersTheZoneOfAModule) {
  const std::pair<const char*, uint32_t> signals[] = {
      {"playerEntered", 1}, {"localPlayerEntered", 1}, {"playerExited", 0}};
  for (const auto& [signal, count] : signals) {
    Scene scene;
    scene.part("Sea");
    scene.script("local zone = require(script.Zone).new(workspace.Sea)\nzone." +
                     std::string(signal) +
                     ":Connect(function(player) player.Character.Humanoid.Health = 0 end)",
                 scene.scripts);
    scene.level();
    EXPECT_EQ(scene.unmodelled("damage by an unknown part"), count) << signal;
  }
}

TEST(Unmodelled, ConstraintsWithoutMotorAreLoose) {
  Scene scene;
  const auto ball = scene.part("Ball");
  scene.set(ball, "Anchored", false);
  const auto attachment = scene.add("Attachment", "A", ball);
  const auto other = scene.add("Attachment", "B", scene.part("Hook"));
  const auto rope = scene.add("RopeConstraint", "Rope", ball);
  scene.set(rope, "Attachment0", Ref{attachment});
  scene.set(rope, "Attachment1", Ref{other});
  scene.level();
  EXPECT_EQ(scene.unmodelled("constraint RopeConstraint"), 1u);
  EXPECT_FALSE(scene[ball].anchored);
}

size_t columns(const std::string& line) {
  size_t count = 0;
  for (const char c : line) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return count;
}

TEST(Explain, FitsAHundredColumnsAndNamesEvidenceAndGuesses) {
  Scene scene;
  const auto folder = scene.add("Folder", std::string(150, 'F'), scene.workspace);
  for (int i = 0; i < 5; ++i) scene.part("Lava", {}, folder);
  const auto odd = scene.part("Lava \xc3\xa9\n\x01\xff");
  scene.script("script.Parent.Touched:Connect(function(h) h.Parent.Humanoid.Health = 0 " +
                   std::string(200, ' ') + " end)",
               odd);
  scene.add("Tool", "Sword", scene.workspace);
  const auto& level = scene.level();
  const std::string text = importer::explain(level, importer::Tree(scene.document));
  size_t begin = 0, lines = 0;
  for (size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1, ++lines)
    EXPECT_LE(columns(text.substr(begin, end - begin)), 100u) << text.substr(begin, end - begin);
  EXPECT_EQ(begin, text.size()) << "ends with a whole line";
  EXPECT_NE(text.find("x5"), std::string::npos);
  EXPECT_NE(text.find("guessed: name Lava"), std::string::npos);
  EXPECT_NE(text.find("script Script line 1"), std::string::npos);
  EXPECT_NE(text.find("tool"), std::string::npos);
  EXPECT_GT(lines, 5u);
}

}  // namespace
}  // namespace obby::test
