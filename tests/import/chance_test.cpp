// Parts that depend on random numbers are marked as doubtful, and no other parts are.
#include "import/scene.h"
#include "import/spawns.h"

namespace obby::test {
namespace {

const char* kByChance = "part that varies at random";

bool isByChance(const PartDraft& part) {
  return std::count(part.doubts.begin(), part.doubts.end(), kByChance) > 0;
}

struct Panels {
  Scene scene;
  InstanceId left, right, floor;
  Panels() {
    scene.part("SpawnLocation", {}, scene.workspace, "SpawnLocation");
    floor = scene.part("Floor", {20, 0, 0});
    left = scene.part("L", {20, 0, 10});
    right = scene.part("R", {30, 0, 10});
  }
  void run(const std::string& source) { scene.script(source, scene.scripts); }
};

TEST(Chance, OneOfTwoPanelsIsNotSolid) {
  Panels panels;
  panels.run(
      "local all = {workspace.L, workspace.R}\n"
      "all[math.random(1, 2)].CanCollide = false\n");
  panels.scene.level();
  EXPECT_TRUE(isByChance(panels.scene[panels.left]));
  EXPECT_TRUE(isByChance(panels.scene[panels.right]));
  EXPECT_FALSE(isByChance(panels.scene[panels.floor]));
}

TEST(Chance, ARareDeathIsFound) {
  Panels panels;
  panels.run(
      "local random = Random.new()\n"
      "workspace.L.Touched:Connect(function(hit)\n"
      "  local human = hit.Parent:FindFirstChild('Humanoid')\n"
      "  if human and random:NextNumber() > 0.95 then human.Health = 0 end\n"
      "end)\n");
  panels.scene.level();
  EXPECT_TRUE(isByChance(panels.scene[panels.left]));
  EXPECT_FALSE(isByChance(panels.scene[panels.right]));
}

TEST(Chance, ClockSeedsAreRandomAndConstantsAreNot) {
  const std::string draw =
      "local all = {workspace.L, workspace.R}\n"
      "all[math.random(1, 2)].CanCollide = false\n";
  Panels byClock, byText;
  byClock.run("math.randomseed(tick())\n" + draw);
  byText.run("math.randomseed(7)\n" + draw);
  byClock.scene.level();
  byText.scene.level();
  EXPECT_TRUE(isByChance(byClock.scene[byClock.left]));
  EXPECT_FALSE(isByChance(byText.scene[byText.left]));
}

TEST(Chance, RandomColoursRaiseNoDoubt) {
  Panels panels;
  panels.run("workspace.L.Color = Color3.new(math.random(), math.random(), math.random())\n");
  panels.scene.level();
  EXPECT_EQ(panels.scene.unmodelled(kByChance), 0u);
}

TEST(Chance, EachRandomlyPositionedPartIsInDoubt) {
  Panels panels;
  panels.run(
      "for i = 1, 3 do\n"
      "  local part = Instance.new('Part')\n"
      "  part.Anchored = true\n"
      "  part.Position = Vector3.new(60 + 10 * i, i < 3 and math.random(1, 9) or 5, 0)\n"
      "  part.Parent = workspace\n"
      "end\n");
  const LevelDraft& level = panels.scene.level();
  size_t doubtful = 0;
  for (const PartDraft& part : level.parts) doubtful += isByChance(part);
  EXPECT_EQ(doubtful, 2u);
  EXPECT_TRUE(level.unmodelled.at(kByChance).anywhere);
}

TEST(Chance, ARandomWaitBeforeACycleRaisesNoDoubt) {
  Panels panels;
  panels.run(
      "task.wait(math.random() * 2)\n"
      "while true do\n"
      "  workspace.L.CanCollide = false\n"
      "  task.wait(1)\n"
      "  workspace.L.CanCollide = true\n"
      "  task.wait(2)\n"
      "end\n");
  panels.scene.level();
  EXPECT_EQ(panels.scene.unmodelled(kByChance), 0u);
}

}  // namespace
}  // namespace obby::test
