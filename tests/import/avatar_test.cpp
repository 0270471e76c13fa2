// Players' bodies, from the avatar settings of StarterPlayer.
#include <gmock/gmock.h>

#include "import/records/level_record.h"
#include "import/scene.h"

namespace obby::test {
namespace {

using importer::setAvatar;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct AvatarPlace {
  Scene scene;
  InstanceId player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);

  LevelDraft level() { return scene.level(); }
  schema::PhysicsParams::Reader physics() {
    setAvatar(record.root().initParams(), level().avatar);
    return record.reader().getParams();
  }
  std::string note(const std::string& kind) {
    const LevelDraft found = level();
    const auto it = found.ignored.find(kind);
    return it == found.ignored.end() ? "" : it->second.note;
  }
  io::RecordBuilder record;
};

TEST(Avatar, APlaceWithoutAvatarSettingsKeepsTheDefaultBody) {
  AvatarPlace place;
  EXPECT_THAT(place.level().avatar.bodies, IsEmpty());
  EXPECT_EQ(place.physics().getTraction(), 2060);
  EXPECT_EQ(place.note("R15 avatars"), "");
}

TEST(Avatar, AnR6PlaceUsesTheR6Body) {
  AvatarPlace place;
  place.scene.set(place.player, "GameSettingsAvatar", EnumItem{0, {}});
  EXPECT_THAT(place.level().avatar.bodies, ElementsAre("r6"));
  EXPECT_EQ(place.physics().getTraction(), 2060);
}

TEST(Avatar, AnR15PlaceUsesTheR15Body) {
  AvatarPlace place;
  place.scene.set(place.player, "GameSettingsAvatar", EnumItem{1, {}});
  // The range of a new place contains 1.
  place.scene.set(place.player, "GameSettingsScaleRangeHeight", NumberRange{0.9f, 1.05f});
  place.scene.set(place.player, "GameSettingsScaleRangeWidth", NumberRange{0.7f, 1});
  EXPECT_THAT(place.level().avatar.bodies, ElementsAre("r15"));
  EXPECT_EQ(place.physics().getTraction(), 2777);
  EXPECT_EQ(place.physics().getHipHeight(), 2);
  EXPECT_THAT(place.note("R15 avatars"), HasSubstr("simulated as the classic R15 body;"));
}

TEST(Avatar, PlayerChoiceKeepsTheDefaultBodyAndAllowsBoth) {
  AvatarPlace place;
  place.scene.set(place.player, "GameSettingsAvatar", EnumItem{2, {}});
  EXPECT_THAT(place.level().avatar.bodies, ElementsAre("r6", "r15"));
  EXPECT_EQ(place.physics().getTraction(), 2060);
  EXPECT_THAT(place.note("avatar chosen by the player"), HasSubstr("--body each"));
}

TEST(Avatar, IsScaledToTheNearestSizeThatThePlaceAllows) {
  AvatarPlace place;
  place.scene.set(place.player, "GameSettingsAvatar", EnumItem{1, {}});
  place.scene.set(place.player, "GameSettingsScaleRangeHeight", NumberRange{0.5f, 0.75f});
  place.scene.set(place.player, "GameSettingsScaleRangeWidth", NumberRange{1.5f, 2});
  const auto physics = place.physics();
  EXPECT_EQ(physics.getHipHeight(), 1.5f);
  EXPECT_EQ(physics.getRootHeight(), 1.5f);
  EXPECT_EQ(physics.getHeadBottom(), 3);
  EXPECT_EQ(physics.getBodyTop(), 3.75f);
  EXPECT_EQ(physics.getBodyWidth(), 3);
  EXPECT_EQ(physics.getArmSpan(), 6);
  EXPECT_THAT(place.note("R15 avatars"), HasSubstr("0.75 times as high, 1.5 times as wide"));
}

TEST(Avatar, ASingleColliderReplacesTheLimbs) {
  AvatarPlace place;
  const auto settings = place.scene.add("AvatarSettings", "AvatarSettings", place.player);
  const auto rules = place.scene.add("AvatarCollisionRules", "AvatarCollisionRules", settings);
  EXPECT_FALSE(place.level().avatar.collider);
  place.scene.set(rules, "CollisionMode", EnumItem{1, {}});
  EXPECT_EQ(place.physics().getBodyWidth(), 2);
  EXPECT_EQ(place.physics().getBodyDepth(), 1);
  place.scene.set(rules, "SingleColliderSize", Vec3{1.5f, 3, 1.25f});
  EXPECT_EQ(place.physics().getBodyWidth(), 1.5f);
  EXPECT_EQ(place.physics().getBodyDepth(), 1.25f);
  EXPECT_EQ(place.physics().getArmSpan(), 4);
  EXPECT_THAT(place.note("single collider"),
              HasSubstr("the body collides as one box of 1.5 x 3 x 1.25 studs"));
  place.scene.set(rules, "HitAndTouchDetectionMode", EnumItem{1, {}});
  EXPECT_EQ(place.physics().getArmSpan(), 1.5f);
}

TEST(Avatar, IsPartOfTheLevelRecord) {
  AvatarPlace place;
  place.scene.set(place.player, "GameSettingsAvatar", EnumItem{1, {}});
  const importer::Tree tree(place.scene.document);
  const io::RecordBuilder record = importer::levelRecord(place.level(), tree);
  EXPECT_EQ(record.reader().getLevel().getPhysics().getTraction(), 2777);
  ASSERT_EQ(record.reader().getLevel().getBodies().size(), 1u);
}

}  // namespace
}  // namespace obby::test
