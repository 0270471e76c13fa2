// Parts that players pass through by their collision groups.
#include "import/parts/collision_groups.h"

#include "import/scene.h"
#include "support/place_columns.h"

namespace obby::test {
namespace {

using namespace importer;

struct Group {
  uint8_t id;
  uint32_t mask;
  std::string name;
};

std::string matrix(const std::vector<Group>& groups) {
  std::string out = {'\1', char(groups.size())};
  for (const Group& group : groups) {
    out += char(group.id);
    out += '\4';
    append(out, group.mask);
    out += char(group.name.size());
    out += group.name;
  }
  return out;
}

// Ghosts (1) do not collide with Default (0); Walls (2) do.
const std::string kMatrix = matrix({{0, ~2u, "Default"}, {1, ~1u, "Ghosts"}, {2, ~0u, "Walls"}});

TEST(CollisionGroups, APartInAPassableGroupIsNotSolid) {
  Scene scene;
  scene.set(scene.workspace, "CollisionGroupData", kMatrix);
  const auto ghost = scene.part("Ghost"), wall = scene.part("Wall"), old = scene.part("Old"),
             plain = scene.part("Plain");
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.set(wall, "CollisionGroup", std::string("Walls"));
  scene.set(old, "CollisionGroupId", int64_t{1});
  scene.level();
  EXPECT_FALSE(scene[ghost].solid);
  EXPECT_TRUE(scene[ghost].touch);
  EXPECT_EQ(scene.evidence(ghost, "collision"), "players pass through collision group Ghosts");
  EXPECT_FALSE(scene[old].solid);
  EXPECT_TRUE(scene[wall].solid);
  EXPECT_TRUE(scene[plain].solid);
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 0u);
  EXPECT_EQ(scene.unmodelled("collision group Walls"), 0u);
}

TEST(CollisionGroups, TouchesMayUseThemToo) {
  Scene scene;
  scene.set(scene.workspace, "CollisionGroupData", kMatrix);
  scene.set(scene.workspace, "TouchesUseCollisionGroups", true);
  const auto ghost = scene.part("Ghost");
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.level();
  EXPECT_FALSE(scene[ghost].touch);
}

TEST(CollisionGroups, ThePlacesCharacterDeterminesThePlayersGroup) {
  Scene scene;
  scene.set(scene.workspace, "CollisionGroupData",
            matrix({{0, ~0u, "Default"}, {1, ~4u, "Players"}, {2, ~2u, "Fog"}}));
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto model = scene.add("Model", "StarterCharacter", player);
  scene.set(scene.add("Part", "Torso", model), "CollisionGroup", std::string("Players"));
  const auto fog = scene.part("Fog"), floor = scene.part("Floor");
  scene.set(fog, "CollisionGroup", std::string("Fog"));
  scene.level();
  EXPECT_FALSE(scene[fog].solid);
  EXPECT_TRUE(scene[floor].solid);
}

TEST(CollisionGroups, AreUncertainWithoutAMatrixOrWithFailedScripts) {
  Scene scene;
  const auto ghost = scene.part("Ghost");
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 1u) << "no matrix";
  scene.set(scene.workspace, "CollisionGroupData", kMatrix);
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 0u);
  scene.script(
      "game:GetService('PhysicsService'):CollisionGroupSetCollidable('Ghosts', 'Default', true)",
      scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 0u) << "the script ran";
  EXPECT_TRUE(scene[ghost].solid);
  scene.set(ghost, "CollisionGroup", std::string("Unknown"));
  scene.level();
  EXPECT_TRUE(scene[ghost].solid);
  EXPECT_EQ(scene.unmodelled("collision group Unknown"), 1u);
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.script("workspace.Terain:Clear()", scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 1u) << "a script failed";
}

// Puts each new body into the group Players, which does not collide with Ghosts.
constexpr const char* kGhosts =
    "local service = game:GetService('PhysicsService')\n"
    "service:RegisterCollisionGroup('Players') service:RegisterCollisionGroup('Ghosts')\n"
    "service:CollisionGroupSetCollidable('Players', 'Ghosts', false)\n"
    "game.Players.PlayerAdded:Connect(function(player)\n"
    "  player.CharacterAdded:Connect(function(body)\n"
    "    for _, limb in body:GetDescendants() do\n"
    "      if limb:IsA('BasePart') then limb.CollisionGroup = 'Players' end\n"
    "    end\n"
    "  end)\n"
    "end)\n";

TEST(CollisionGroups, ScriptedGroupsDecideWhetherPlayersPassThrough) {
  Scene scene;
  const auto ghost = scene.part("Ghost"), wall = scene.part("Wall", {20, 0, 0});
  scene.script(std::string(kGhosts) + "workspace.Ghost.CollisionGroup = 'Ghosts'", scene.scripts);
  scene.level();
  EXPECT_FALSE(scene[ghost].solid);
  EXPECT_EQ(scene.evidence(ghost, "scripted"), "not solid; script Script");
  EXPECT_TRUE(scene[wall].solid);
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 0u);
}

TEST(CollisionGroups, AGroupOfSomeLimbsIsNamed) {
  Scene scene;
  const auto ghost = scene.part("Ghost");
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.script(
      "local service = game:GetService('PhysicsService')\n"
      "service:RegisterCollisionGroup('Players') service:RegisterCollisionGroup('Ghosts')\n"
      "service:CollisionGroupSetCollidable('Players', 'Ghosts', false)\n"
      "game.Players.PlayerAdded:Connect(function(player)\n"
      "  player.CharacterAdded:Connect(function(body)\n"
      "    body.HumanoidRootPart.CollisionGroup = 'Players'\n"
      "  end)\n"
      "end)",
      scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[ghost].solid);
  EXPECT_EQ(scene.unmodelled("collision group of some limbs"), 1u);
}

TEST(CollisionGroups, ScriptsCanOverrideTheSavedGroups) {
  Scene scene;
  scene.set(scene.workspace, "CollisionGroupData", kMatrix);
  const auto ghost = scene.part("Ghost");
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.script("print('hello')", scene.scripts);
  scene.level();
  EXPECT_FALSE(scene[ghost].solid);
  EXPECT_EQ(scene.evidence(ghost, "collision"), "players pass through collision group Ghosts");
  scene.script(
      "game:GetService('PhysicsService'):CollisionGroupSetCollidable('Ghosts', 'Default', true)",
      scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[ghost].solid);
}

TEST(CollisionGroups, ATouchThatChangesGroupsMakesPartsVanish) {
  Scene scene;
  scene.part("Floor", {0, -4, 0});
  const auto ghost = scene.part("Ghost", {40, 0, 0}), lever = scene.part("Lever", {20, 0, 0});
  scene.script(std::string(kGhosts) +
                   "workspace.Lever.Touched:Connect(function()\n"
                   "  workspace.Ghost.CollisionGroup = 'Ghosts' task.wait(3)\n"
                   "  workspace.Ghost.CollisionGroup = 'Default'\n"
                   "end)",
               scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[ghost].solid);
  ASSERT_TRUE(scene[ghost].vanish);
  EXPECT_NEAR(scene[ghost].vanish->away, 3, 0.1);
  EXPECT_TRUE(scene[lever].button);
}

TEST(CollisionGroups, AnAlternatingGroupIsATimer) {
  Scene scene;
  const auto ghost = scene.part("Ghost");
  scene.script(std::string(kGhosts) +
                   "while true do\n"
                   "  workspace.Ghost.CollisionGroup = 'Ghosts' task.wait(2)\n"
                   "  workspace.Ghost.CollisionGroup = 'Default' task.wait(4)\n"
                   "end",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[ghost].vanish);
  EXPECT_TRUE(scene[ghost].vanish->timer);
  EXPECT_NEAR(scene[ghost].vanish->away, 2, 0.1);
}

TEST(CollisionGroups, PassablePartsAreTouchedUnlessThePlaceForbidsIt) {
  for (const bool touchesUseGroups : {false, true}) {
    Scene scene;
    scene.set(scene.workspace, "CollisionGroupData", kMatrix);
    scene.set(scene.workspace, "TouchesUseCollisionGroups", touchesUseGroups);
    const auto ghost = scene.part("Ghost", {20, 0, 0});
    scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
    scene.script(
        "script.Parent.Touched:Connect(function(hit)\n"
        "  local human = hit.Parent:FindFirstChild('Humanoid')\n"
        "  if human then human.Health = 0 end\n"
        "end)",
        ghost);
    scene.level();
    EXPECT_FALSE(scene[ghost].solid);
    EXPECT_EQ(scene[ghost].touch, !touchesUseGroups);
    EXPECT_EQ(bool(scene[ghost].kill), !touchesUseGroups);
  }
}

TEST(CollisionGroups, APlayerCanBeInsideAPassablePart) {
  Scene scene;
  const auto ghost = scene.part("Ghost");
  scene.set(ghost, "Size", Vec3{4, 12, 4});
  scene.script(std::string(kGhosts) +
                   "workspace.Ghost.CollisionGroup = 'Ghosts'\n"
                   "while task.wait(0.1) do\n"
                   "  for _, hit in workspace:GetPartsInPart(workspace.Ghost) do\n"
                   "    local human = hit.Parent:FindFirstChild('Humanoid')\n"
                   "    if human then human.Health = 0 end\n"
                   "  end\n"
                   "end",
               scene.scripts);
  scene.level();
  EXPECT_FALSE(scene[ghost].solid);
  EXPECT_TRUE(scene[ghost].kill);
}

TEST(CollisionGroups, DamageIsNamed) {
  EXPECT_TRUE(engine::decodeGroups(kMatrix));
  for (size_t length = 0; length < kMatrix.size(); ++length)
    EXPECT_FALSE(engine::decodeGroups(kMatrix.substr(0, length))) << length;
  Scene scene;
  scene.part("Base");
  scene.set(scene.workspace, "CollisionGroupData", std::string("\2\1"));
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision groups"), 1u);
}

}  // namespace
}  // namespace obby::test
