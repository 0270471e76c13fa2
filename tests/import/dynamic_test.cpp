// Unanchored parts that become bodies.
#include "import/scene.h"

namespace obby::test {
namespace {

InstanceId dynamicPart(Scene& scene, const std::string& name) {
  const InstanceId id = scene.part(name);
  scene.set(id, "Anchored", false);
  return id;
}

TEST(DynamicParts, ASingleUnanchoredPartIsDynamic) {
  Scene scene;
  const InstanceId crate = dynamicPart(scene, "Crate");
  scene.level();
  EXPECT_FALSE(scene[crate].anchored);
}

TEST(DynamicParts, JoinedPartsAreAnchoredAndReported) {
  Scene scene;
  const InstanceId a = dynamicPart(scene, "Leg"), b = dynamicPart(scene, "Arm");
  const InstanceId weld = scene.add("Weld", "Weld", a);
  scene.set(weld, "Part0", Ref{a});
  scene.set(weld, "Part1", Ref{b});
  scene.level();
  EXPECT_TRUE(scene[a].anchored);
  EXPECT_TRUE(scene[b].anchored);
  EXPECT_EQ(scene.unmodelled("unanchored part"), 2u);
}

TEST(DynamicParts, VanishingPartsAreAnchoredAndReported) {
  Scene scene;
  const InstanceId plank = dynamicPart(scene, "Plank"), crate = dynamicPart(scene, "Crate");
  scene.tag(plank, "Disappearing");
  scene.level();
  EXPECT_TRUE(scene[plank].anchored);
  EXPECT_TRUE(scene[plank].vanish);
  EXPECT_EQ(scene.evidence(plank, "anchored"), "guessed: unanchored parts cannot vanish");
  EXPECT_FALSE(scene[crate].anchored);
  EXPECT_EQ(scene.unmodelled("unanchored part"), 1u);
}

TEST(DynamicParts, APushboxIsDynamicEvenIfSavedAnchored) {
  Scene scene;
  const InstanceId kit = scene.add("Model", "PushboxSpawnButton", scene.workspace);
  const InstanceId box = scene.part("Pushbox", {}, kit), marked = scene.part("Crate");
  scene.add("BoolValue", "IsBox", marked);
  scene.level();
  EXPECT_FALSE(scene[box].anchored);
  EXPECT_FALSE(scene[marked].anchored);
  EXPECT_EQ(scene.evidence(box, "dynamic"), "guessed: pushbox of a kit");
}

TEST(DynamicParts, OnlyPushboxesAreDynamicAboveTheLimit) {
  Scene scene;
  std::vector<InstanceId> crates;
  for (int i = 0; i < 20; ++i) crates.push_back(dynamicPart(scene, "Crate"));
  const InstanceId box = scene.part("Pushbox");
  scene.level();
  for (const InstanceId crate : crates) EXPECT_TRUE(scene[crate].anchored);
  EXPECT_FALSE(scene[box].anchored);
  EXPECT_EQ(scene.unmodelled("unanchored part"), 20u);
}

}  // namespace
}  // namespace obby::test
