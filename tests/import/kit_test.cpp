// Tests markers of tower kits if the kit's own modules are missing from the file.
#include "import/scene.h"

namespace obby::test {
namespace {

InstanceId marked(Scene& scene, InstanceId part, const char* tag) {
  const InstanceId marker = scene.add("Configuration", "Configuration", part);
  scene.tag(marker, tag);
  return marker;
}

TEST(Kit, BoostersHaveTheirKindOfBoost) {
  Scene scene;
  const auto speed = scene.part("A"), jump = scene.part("B", {20, 0, 0}),
             bare = scene.part("C", {40, 0, 0});
  const auto first = marked(scene, speed, "CO_Interactables/Booster");
  scene.attribute(first, "Type", std::string("Speed"));
  scene.attribute(first, "Power", 40.0);
  scene.attribute(first, "Duration", 5.0);
  const auto second = marked(scene, jump, "CO_Interactables/Booster");
  scene.attribute(second, "Type", std::string("Jump"));
  scene.attribute(second, "Power", 100.0);
  marked(scene, bare, "CO_Interactables/Booster");
  scene.level();
  ASSERT_TRUE(scene[speed].boost && scene[jump].boost);
  EXPECT_FLOAT_EQ(scene[speed].boost->walkSpeed, 40 / 16.0f);
  EXPECT_FLOAT_EQ(scene[speed].boost->seconds, 5);
  EXPECT_NEAR(scene[jump].boost->jumpSpeed, 2, 0.02);
  EXPECT_EQ(scene[jump].boost->walkSpeed, 1);
  EXPECT_FALSE(scene[bare].boost);
  EXPECT_EQ(scene.unmodelled("booster without a power"), 1u);
}

TEST(Kit, OneWayPlatformsLetPlayersThroughFromBelow) {
  Scene scene;
  const auto tagged = scene.part("A"), byMarker = scene.part("B", {20, 0, 0}),
             plain = scene.part("C", {40, 0, 0});
  scene.tag(tagged, "OneWayPlatform");
  marked(scene, byMarker, "CO_Physics/OneWayPlatform");
  scene.level();
  EXPECT_TRUE(scene[tagged].oneWay);
  EXPECT_TRUE(scene[byMarker].oneWay);
  EXPECT_FALSE(scene[plain].oneWay);
}

TEST(Kit, ElevatorsThrowPlayersInsideThem) {
  Scene scene;
  const auto field = scene.part("A");
  scene.set(field, "CanCollide", false);
  scene.attribute(marked(scene, field, "CO_Physics/Elevator"), "Speed", 40.0);
  scene.level();
  ASSERT_TRUE(scene[field].jumpPad);
  EXPECT_EQ(scene[field].jumpPad->velocity, (Vec3{0, 40, 0}));
}

}  // namespace
}  // namespace obby::test
