// PhysicsService and the collision groups of parts, as scripts see them.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/place.h"

namespace obby::test {
namespace {

TEST(CollisionGroupsApi, PairsCollideUntilAScriptSaysOtherwise) {
  EXPECT_EQ(resultOf("local s = game:GetService('PhysicsService')\n"
                     "s:RegisterCollisionGroup('A') s:RegisterCollisionGroup('B')\n"
                     "local before = s:CollisionGroupsAreCollidable('A', 'B')\n"
                     "s:CollisionGroupSetCollidable('B', 'A', false)\n"
                     "local result = tostring(before) .. ' '\n"
                     "  .. tostring(s:CollisionGroupsAreCollidable('A', 'B')) .. ' '\n"
                     "  .. tostring(s:CollisionGroupsAreCollidable('A', 'A')) .. ' '\n"
                     "  .. tostring(s:CollisionGroupsAreCollidable('A', 'Unknown'))"),
            "true false true true");
}

TEST(CollisionGroupsApi, NamesAndNumbersOfPartsAgree) {
  EXPECT_EQ(resultOf("local s = game:GetService('PhysicsService')\n"
                     "local id = s:CreateCollisionGroup('A')\n"
                     "local a, b = Instance.new('Part'), Instance.new('Part')\n"
                     "s:SetPartCollisionGroup(a, 'A') b.CollisionGroupId = id\n"
                     "local result = id .. ' ' .. a.CollisionGroupId .. ' ' .. b.CollisionGroup\n"
                     "  .. ' ' .. s:GetCollisionGroupName(id)\n"
                     "b.CollisionGroup = 'Default'\n"
                     "result = result .. ' ' .. b.CollisionGroupId\n"
                     "  .. ' ' .. tostring(s:CollisionGroupContainsPart('A', a))\n"
                     "  .. ' ' .. #s:GetRegisteredCollisionGroups()"),
            "1 1 A A 0 true 2");
}

// Returns "solid" or "passed" by the last observed value of CanCollide, or "untold" if none was
// observed.
std::string lastSolid(const engine::Observation& seen, InstanceId part) {
  std::string last = "untold";
  for (const engine::Change& change : seen.changes)
    if (change.target == part && change.property == "CanCollide")
      last = std::get<bool>(change.value) ? "solid" : "passed";
  return last;
}

std::string solidWith(const std::string& script, uint32_t frames = 120) {
  Place place;
  const InstanceId part = place.part("Wall", {20, 0, 0});
  place.script(
      "local s, wall = game:GetService('PhysicsService'), workspace.Wall\n"
      "s:RegisterCollisionGroup('Players') s:RegisterCollisionGroup('Ghosts')\n"
      "s:CollisionGroupSetCollidable('Players', 'Ghosts', false)\n"
      "local function join(body, ...)\n"
      "  for _, name in { ... } do body[name].CollisionGroup = 'Players' end\n"
      "end\n"
      "local function onBody(act)\n"
      "  game.Players.PlayerAdded:Connect(function(player)\n"
      "    player.CharacterAdded:Connect(act)\n"
      "  end)\n"
      "end\n" +
          script,
      place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(frames);
  EXPECT_EQ(problems(stage.observation()), "");
  return lastSolid(stage.observation(), part);
}

TEST(CollisionGroupsApi, PlayersPassThroughIfAllTheirLimbsDo) {
  const std::string all =
      "onBody(function(body) join(body, 'Head', 'UpperTorso', 'LowerTorso',\n"
      "  'HumanoidRootPart') end) ";
  EXPECT_EQ(solidWith(all + "wall.CollisionGroup = 'Ghosts'"), "passed");
  EXPECT_EQ(solidWith(all), "untold") << "the wall is in no group";
  EXPECT_EQ(solidWith("wall.CollisionGroup = 'Ghosts'"), "untold") << "the body is in no group";
  EXPECT_EQ(solidWith("onBody(function(body) join(body, 'HumanoidRootPart') end)\n"
                      "wall.CollisionGroup = 'Ghosts'"),
            "untold");
  EXPECT_EQ(solidWith(all + "wall.CollisionGroup = 'Ghosts' wall.CanCollide = false"), "passed");
  EXPECT_EQ(solidWith(all + "wall.CollisionGroup = 'Ghosts'\n"
                            "task.wait(1.5) wall.CollisionGroup = 'Default'"),
            "solid");
  EXPECT_EQ(
      solidWith(all + "wall.CollisionGroup = 'Ghosts'\n"
                      "task.wait(1.5) s:CollisionGroupSetCollidable('Players', 'Ghosts', true)"),
      "solid");
  EXPECT_EQ(solidWith(all + "wall.CollisionGroup = 'Ghosts'\n"
                            "task.wait(1.5) s:UnregisterCollisionGroup('Ghosts')"),
            "solid");
  EXPECT_EQ(solidWith("wall.CollisionGroup = 'Late'\n"
                      "s:CollisionGroupSetCollidable('Late', 'Default', false)\n"
                      "task.wait(1) s:RegisterCollisionGroup('Late')"),
            "passed");
}

TEST(CollisionGroupsApi, ANewBodyCountsOnceScriptsHaveSetItsGroups) {
  Place place;
  const InstanceId part = place.part("Wall", {20, 0, 0});
  place.script(
      "local s = game:GetService('PhysicsService')\n"
      "s:RegisterCollisionGroup('Players')\n"
      "s:CollisionGroupSetCollidable('Players', 'Default', false)\n"
      "game.Players.PlayerAdded:Connect(function(player)\n"
      "  player.CharacterAdded:Connect(function(body)\n"
      "    task.wait(0.5)\n"
      "    for _, limb in body:GetDescendants() do\n"
      "      if limb:IsA('BasePart') then limb.CollisionGroup = 'Players' end\n"
      "    end\n"
      "  end)\n"
      "  task.wait(2) player:LoadCharacter()\n"
      "end)",
      place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(300);
  const engine::Observation& seen = stage.observation();
  EXPECT_EQ(problems(seen), "");
  EXPECT_EQ(
      std::count_if(seen.changes.begin(), seen.changes.end(),
                    [&](const auto& c) { return c.target == part && c.property == "CanCollide"; }),
      1);
}

}  // namespace
}  // namespace obby::test
