// Parts, listeners and speeds that appear some time after the start.
#include "import/lever_scene.h"
#include "import/records/queries.h"

namespace obby::test {
namespace {

const std::string kDeadly = ".Touched:Connect(function(hit)\n" + kKillHit + "end)";
const std::string kWall =
    "local w = Instance.new('Part') w.Name = 'Wall' w.Anchored = true w.CanCollide = false\n"
    "w.Size = Vector3.new(8, 8, 1) w.Position = Vector3.new(0, 4, 30) ";

// Returns the part that scripts have made.
const PartDraft* made(const LevelDraft& level) {
  for (const PartDraft& part : level.parts)
    if (part.pose.position == Vec3{0, 4, 30}) return &part;
  return nullptr;
}

TEST(LaterParts, ALatePartExistsFromItsCreation) {
  Scene scene;
  scene.part("Floor");
  scene.script("wait(8) " + kWall + "w" + kDeadly + " w.Parent = workspace", scene.scripts);
  const LevelDraft& level = scene.level();
  const PartDraft* const wall = made(level);
  ASSERT_TRUE(wall && wall->vanish && wall->kill);
  EXPECT_TRUE(wall->vanish->timer && wall->vanish->inverted);
  EXPECT_NEAR(wall->vanish->delay, 8, 0.1);
  EXPECT_FALSE(wall->solid);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(LaterParts, CopiesCanBePositionedAfterInsertion) {
  Scene scene;
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  scene.part("Plank", {}, storage);
  scene.script(
      "wait(6) local w = game.ServerStorage.Plank:Clone() w.Parent = workspace\n"
      "w.CFrame = CFrame.new(0, 4, 30)",
      scene.scripts);
  const LevelDraft& level = scene.level();
  const PartDraft* const plank = made(level);
  ASSERT_TRUE(plank && plank->vanish);
  EXPECT_TRUE(plank->solid);
  EXPECT_FALSE(plank->motion);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(LaterParts, ATemporaryPartIsReported) {
  Scene scene;
  scene.part("Floor");
  scene.script("while true do wait(4) " + kWall + " w.Parent = workspace wait(2) w:Destroy() end",
               scene.scripts);
  EXPECT_EQ(scene.level().parts.size(), 1u);
  EXPECT_EQ(scene.level().unmodelled.size(), 1u);
  EXPECT_EQ(scene.unmodelled("part that appears later"), 1u);
}

TEST(LaterParts, LateListenersAreGuessesAndReported) {
  Scene scene;
  const auto lava = scene.part("Slab");
  scene.script("wait(5) workspace.Slab" + kDeadly, scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[lava].kill);
  EXPECT_TRUE(isGuessedKill(scene, lava));
  ASSERT_EQ(scene.unmodelled(kMoreLater), 1u);
  EXPECT_EQ(noteOf(scene.level(), kMoreLater).rfind("some time after the start", 0), 0u);
}

TEST(LaterParts, ABrokenJointThatFreesItsPartIsReported) {
  for (const char* goes : {"workspace.Wall.Weld:Destroy()", "workspace.Wall:Destroy()"}) {
    Scene scene;
    const auto wall = scene.part("Wall"), ledge = scene.part("Ledge", {0, 2, 2});
    scene.set(ledge, "Anchored", false);
    const auto weld = scene.add("WeldConstraint", "Weld", wall);
    scene.set(weld, "Part0", Ref{wall});
    scene.set(weld, "Part1", Ref{ledge});
    scene.script(std::string("wait(6) ") + goes, scene.scripts);
    scene.level();
    EXPECT_EQ(scene.unmodelled("part that scripts release"), 1u) << goes;
  }
}

TEST(LaterParts, ARemovedModelTakesItsJointsWithIt) {
  Scene scene;
  const auto gate = scene.add("Model", "Gate", scene.workspace);
  const auto post = scene.part("Post", {}, gate), bar = scene.part("Bar", {0, 2, 2}, gate);
  scene.set(bar, "Anchored", false);
  const auto weld = scene.add("WeldConstraint", "Weld", gate);
  scene.set(weld, "Part0", Ref{post});
  scene.set(weld, "Part1", Ref{bar});
  scene.script("wait(6) workspace.Gate:Destroy()", scene.scripts);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(LaterParts, LaterStagesStartOnceTheirPartsExist) {
  Scene scene;
  for (const int stage : {1, 2, 3})
    scene.tag(scene.part("Checkpoint" + std::to_string(stage), {0, 0, 20 * float(stage)}),
              "Checkpoint");
  scene.script("wait(8) " + kWall + "w.Parent = workspace", scene.scripts);
  const importer::ObservedPlace place = importer::observePlace(scene.document);
  const importer::Tree tree(place.document);
  const auto queries = importer::stageQueries(importer::buildLevel(tree, place, "test"), tree);
  ASSERT_GE(queries.size(), 2u);
  EXPECT_EQ(queries.front().reader().getQuery().getStart().getTick(), 0u);
  EXPECT_NEAR(queries.back().reader().getQuery().getStart().getTick(), 480, 6);
}

TEST(LaterParts, ASpeedThatSettlesCountsAtItsFinalValue) {
  const char* const kSpeed = "speed that scripts change";
  const std::string join =
      "game.Players.PlayerAdded:Connect(function(p) p.CharacterAdded:Connect(function(c)\n"
      "local h = c:WaitForChild('Humanoid') ";
  Scene frozen, growing;
  for (Scene* scene : {&frozen, &growing}) scene->part("Spawn", {0, 0, 0});
  frozen.script(join + "h.WalkSpeed = 0 task.wait(5) h.WalkSpeed = 20 end) end)", frozen.scripts);
  EXPECT_EQ(frozen.level().world.walkSpeed, 20);
  EXPECT_EQ(frozen.unmodelled(kSpeed), 1u);
  growing.script(join + "while true do task.wait(1) h.WalkSpeed += 1 end end) end)",
                 growing.scripts);
  EXPECT_LT(growing.level().world.walkSpeed, 20);
  EXPECT_EQ(growing.unmodelled(kSpeed), 1u);
}

}  // namespace
}  // namespace obby::test
