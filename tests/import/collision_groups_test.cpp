// Parts that players pass through by their collision groups.
#include "import/collision_groups.h"

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

TEST(CollisionGroups, APartThatPlayersPassThroughIsNotSolid) {
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

TEST(CollisionGroups, ThePlacesOwnCharacterSaysWhichGroupIsThePlayers) {
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

TEST(CollisionGroups, WhatScriptsSetOrNoMatrixNamesIsNotSettled) {
  Scene scene;
  const auto ghost = scene.part("Ghost");
  scene.set(ghost, "CollisionGroup", std::string("Ghosts"));
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 1u) << "no matrix";
  scene.set(scene.workspace, "CollisionGroupData", kMatrix);
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 0u);
  scene.script("game.PhysicsService:CollisionGroupSetCollidable('Ghosts', 'Default', true)",
               scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision group Ghosts"), 1u);
  scene.set(ghost, "CollisionGroup", std::string("Unknown"));
  scene.level();
  EXPECT_TRUE(scene[ghost].solid);
  EXPECT_EQ(scene.unmodelled("collision group Unknown"), 1u);
}

TEST(CollisionGroups, DamageIsNamed) {
  EXPECT_TRUE(decodeGroups(kMatrix));
  for (size_t length = 0; length < kMatrix.size(); ++length)
    EXPECT_FALSE(decodeGroups(kMatrix.substr(0, length))) << length;
  Scene scene;
  scene.part("Base");
  scene.set(scene.workspace, "CollisionGroupData", std::string("\2\1"));
  scene.level();
  EXPECT_EQ(scene.unmodelled("collision groups"), 1u);
}

}  // namespace
}  // namespace obby::test
