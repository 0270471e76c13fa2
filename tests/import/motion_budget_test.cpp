// Motions of many parts with many keys.
#include "import/motion.h"
#include "import/scene.h"

namespace obby::test {
namespace {

TEST(Motion, AllKeysOfALevelHaveABudget) {
  constexpr size_t kParts = 400, kKeys = 1500;
  static_assert(kParts * kKeys < importer::kMaxLevelKeys);
  static_assert(2 * kParts * kKeys > importer::kMaxLevelKeys);
  Scene scene;
  InstanceId models[2];
  for (InstanceId& model : models) {
    model = scene.add("Model", "Wave", scene.workspace);
    for (size_t i = 0; i < kParts; ++i) scene.part("Part", {float(i), 0, 0}, model);
  }
  importer::Motion motion;
  for (size_t i = 0; i < kKeys; ++i)
    motion.keys.push_back({float(i) / 60, Pose{{0, float(i % 2), 0}, {}}, importer::Easing::linear,
                           importer::EasingDirection::out});
  const importer::Tree tree(scene.document);
  const importer::Assemblies assemblies(tree);
  const std::vector<importer::ScriptReading> scripts{};
  LevelDraft level = importer::buildLevel(tree, "test");
  importer::RoleContext context(tree, assemblies, scripts, level);
  EXPECT_EQ(importer::giveMotion(context, models[0], motion, "a test", false), int(kParts));
  EXPECT_EQ(importer::giveMotion(context, models[1], motion, "a test", false), 0);
  size_t keys = 0;
  for (const PartDraft& part : level.parts) keys += part.motion ? part.motion->keys.size() : 0;
  EXPECT_EQ(keys, kParts * kKeys);
  ASSERT_EQ(level.unmodelled.count("motion of too many poses"), 1u);
  EXPECT_EQ(level.unmodelled.at("motion of too many poses").count, kParts);
}

}  // namespace
}  // namespace obby::test
