// Kill parts by evidence in the file: tags, markers and names.
#include "import/scene.h"

namespace obby::test {
namespace {

TEST(Kill, TagsWithAndWithoutNumbers) {
  Scene scene;
  const auto plain = scene.part("A"), hurts = scene.part("B");
  const auto group = scene.add("Model", "Group", scene.workspace);
  const auto inside = scene.part("C", {}, group);
  scene.tag(plain, "KillBlock");
  scene.tag(hurts, "DamagePart");
  scene.attribute(hurts, "Damage", 35.0);
  scene.attribute(hurts, "Cooldown", 0.25);
  scene.tag(group, "Lava");
  scene.level();
  EXPECT_EQ(scene.evidence(plain, "kill"), "tag KillBlock");
  EXPECT_FLOAT_EQ(scene[hurts].kill->damage, 35);
  EXPECT_FLOAT_EQ(scene[hurts].kill->cooldown, 0.25f);
  EXPECT_TRUE(scene[inside].kill);
}

TEST(Kill, TagsInCodeReachTheirParts) {
  Scene scene;
  const auto part = scene.part("A");
  scene.tag(part, "Ouchie");
  scene.script(R"(local CollectionService = game:GetService("CollectionService")
for _, brick in CollectionService:GetTagged("Ouchie") do
  brick.Touched:Connect(function(hit)
    local h = hit.Parent:FindFirstChild("Humanoid")
    if h then h:TakeDamage(15) end
  end)
end)",
               scene.scripts);
  scene.level();
  ASSERT_TRUE(scene[part].kill);
  EXPECT_FLOAT_EQ(scene[part].kill->damage, 15);
}

TEST(Kill, TowerKitMarkersCountByExistence) {
  Scene scene;
  const auto kills = scene.part("A"), instant = scene.part("B"), v6 = scene.part("C");
  scene.value("BoolValue", "kills", false, kills);
  scene.value("BoolValue", "instakills", false, instant);
  const auto configuration = scene.add("Configuration", "DamageBrickConfiguration", v6);
  scene.attribute(configuration, "Type", std::string("double"));
  scene.attribute(configuration, "Cooldown", 0.0);
  scene.level();
  EXPECT_FLOAT_EQ(scene[kills].kill->damage, 5);
  EXPECT_FLOAT_EQ(scene[kills].kill->cooldown, 0.1f);
  EXPECT_GE(scene[instant].kill->damage, 1000);
  EXPECT_FLOAT_EQ(scene[v6].kill->damage, 10);
  EXPECT_FLOAT_EQ(scene[v6].kill->cooldown, 0);
}

TEST(Kill, NamesAreGuessesAndFalseFriendsAreNot) {
  Scene scene;
  const auto brick = scene.part("Bob's KillBrick"), lava = scene.part("Big Lava");
  const auto skill = scene.part("Skill"), remover = scene.part("Lava Remover");
  const auto untouchable = scene.part("Lava"), hurts = scene.part("HurtPart");
  scene.set(untouchable, "CanTouch", false);
  scene.level();
  EXPECT_EQ(scene.evidence(brick, "kill"), "guessed: name Bob's KillBrick");
  EXPECT_TRUE(scene[lava].kill);
  EXPECT_FALSE(scene[skill].kill);
  EXPECT_FALSE(scene[remover].kill);
  EXPECT_FALSE(scene[untouchable].kill);
  EXPECT_TRUE(scene[hurts].kill && scene[hurts].kill->damage < 100);
}

}  // namespace
}  // namespace obby::test
