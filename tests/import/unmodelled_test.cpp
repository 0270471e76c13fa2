// Features that are not simulated are noted, with counts.
#include <memory>
#include <string>
#include <utility>

#include "import/records/explain.h"
#include "import/scene.h"

namespace obby::test {
namespace {

// Adds a part whose script moves the touching player by `value`.
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

TEST(Teleport, GoesToTheScriptedPosition) {
  Scene scene;
  const auto from = teleporter(scene, "workspace.teleporter1b.CFrame + Vector3.new(0, 5, 0)");
  scene.level();
  EXPECT_EQ(scene.unmodelled("teleporter"), 0u);
  ASSERT_TRUE(scene[from].teleport);
  EXPECT_NEAR(scene[from].teleport->position.x, 50, 1e-4);
  EXPECT_NEAR(scene[from].teleport->position.y, 2, 1e-4) << "the root is 3 above the feet";
  EXPECT_TRUE(scene[from].teleport->turns);
}

TEST(Teleport, CanTurnThePlayerToTheHitPart) {
  Scene scene;
  const auto from = teleporter(scene, "CFrame.new(workspace.teleporter1b.Position, hit.Position)");
  scene.level();
  EXPECT_EQ(scene.unmodelled("teleporter"), 0u);
  ASSERT_TRUE(scene[from].teleport);
  EXPECT_NEAR(scene[from].teleport->position.x, 50, 1e-4);
  EXPECT_TRUE(scene[from].teleport->turns);
}

TEST(Seat, IsRecognisedByItsClassUnlessDisabled) {
  Scene scene;
  const auto chair = scene.part("Chair", {}, scene.workspace, "Seat");
  const auto broken = scene.part("Broken", {}, scene.workspace, "Seat");
  scene.set(broken, "Disabled", true);
  scene.level();
  EXPECT_TRUE(scene[chair].seat);
  EXPECT_FALSE(scene[broken].seat);
}

TEST(Unmodelled, SeatsToolsTerrainGroups) {
  Scene scene;
  scene.part("Wheel", {}, scene.workspace, "VehicleSeat");
  scene.set(scene.part("Ghost"), "CollisionGroup", std::string("Ghosts"));
  scene.add("Tool", "Sword", scene.workspace);
  const auto terrain = scene.add("Terrain", "Terrain", scene.workspace);
  scene.set(terrain, "SmoothGrid", std::string(1000, 'x'));
  scene.level();
  for (const char* kind : {"vehicle seat", "collision group Ghosts", "tool", "terrain"})
    EXPECT_EQ(scene.unmodelled(kind), 1u) << kind;
  const auto voxels = std::make_shared<const std::string>(1000, 'x');
  scene.set(terrain, "SmoothGrid", SharedBlob{voxels});
  scene.level();
  EXPECT_EQ(scene.unmodelled("terrain"), 1u) << "in a shared string";
}

TEST(Unmodelled, ForeignCode) {
  for (const char* text : {"require(123456)", "loadstring('x')()"}) {
    Scene scene;
    scene.part("Part");
    scene.script(text, scene.scripts);
    scene.level();
    EXPECT_EQ(scene.unmodelled("script that fails"), 1u) << text;
  }
}

TEST(Unmodelled, KitTagsAndTellingNames) {
  Scene scene;
  scene.tag(scene.part("Gate"), "WallJump");
  scene.part("Jump Pad");
  scene.level();
  EXPECT_EQ(scene.unmodelled("tag walljump"), 1u);
  EXPECT_EQ(scene.unmodelled("name that suggests a jump pad"), 1u);
}

TEST(Unmodelled, ConstraintsWithoutAMotorLeaveThePartDynamic) {
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
  scene.script("error('leaves names as guesses')", scene.scripts);
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
