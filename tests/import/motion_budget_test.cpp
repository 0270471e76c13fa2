// Motions of many parts with many keys, and other work that could grow quadratically.
#include <chrono>

#include "import/draft/motion.h"
#include "import/draft/motion_budget.h"
#include "import/scene.h"
#include "level/compile_parts.h"

namespace obby::test {
namespace {

// Gives the motion to two models of `parts` parts, one after the other. Expects the second model to
// exceed the budget.
void expectBudgetForOne(size_t parts, const importer::Motion& motion) {
  Scene scene;
  InstanceId models[2];
  for (InstanceId& model : models) {
    model = scene.add("Model", "Wave", scene.workspace);
    for (size_t i = 0; i < parts; ++i) scene.part("Part", {float(i), 0, 0}, model);
  }
  const importer::Tree tree(scene.document);
  const importer::Assemblies assemblies(tree);
  LevelDraft level = importer::buildLevel(tree, {}, "test");
  importer::RoleContext context(tree, assemblies, level);
  EXPECT_EQ(importer::giveMotion(context, models[0], motion, "a test", false), int(parts));
  EXPECT_EQ(importer::giveMotion(context, models[1], motion, "a test", false), 0);
  size_t moving = 0;
  for (const PartDraft& part : level.parts) moving += part.motion ? 1 : 0;
  EXPECT_EQ(moving, parts);
  ASSERT_EQ(level.unmodelled.count("motion with too many poses"), 1u);
  EXPECT_EQ(level.unmodelled.at("motion with too many poses").count, parts);
}

importer::MotionKey keyAt(float time, float height) {
  return {time, Pose{{0, height, 0}, {}}, importer::Easing::linear, importer::EasingDirection::out};
}

TEST(Motion, AllKeysOfALevelHaveABudget) {
  constexpr size_t kParts = 400, kKeys = 1500;
  static_assert(kParts * kKeys < importer::kMaxLevelKeys);
  static_assert(2 * kParts * kKeys > importer::kMaxLevelKeys);
  importer::Motion motion;
  for (size_t i = 0; i < kKeys; ++i) motion.keys.push_back(keyAt(float(i) / 60, float(i % 2)));
  expectBudgetForOne(kParts, motion);
}

TEST(Motion, AllTicksOfALevelHaveABudget) {
  constexpr size_t kParts = 600, kSeconds = 80;  // a round trip takes 160 s
  static_assert(kParts * kSeconds * 2 * 60 > level::kMaxLevelRows);
  static_assert(kParts * kSeconds * 60 < level::kMaxLevelRows);
  importer::Motion motion;
  motion.keys = {keyAt(0, 0), keyAt(float(kSeconds), 50)};
  expectBudgetForOne(kParts, motion);
  motion.repeat = importer::Repeat::pingPong;
  expectBudgetForOne(kParts / 2, motion);
}

// Many leaves are decoration around a few solid branches. One leaf turns out to kill.
TEST(Motion, DecorationYieldsItsBudgetToSolidParts) {
  constexpr size_t kSolid = 5, kLeaves = 1000, kKeys = 1500;
  static_assert(kLeaves * kKeys > importer::kMaxLevelKeys);
  Scene scene;
  const auto model = scene.add("Model", "Tree", scene.workspace);
  InstanceId first = kNoInstance;
  for (size_t i = 0; i < kLeaves; ++i) {
    const auto leaf = scene.part("Leaf", {float(i), 0, 0}, model);
    scene.set(leaf, "CanCollide", false);
    if (i == 0) first = leaf;
  }
  for (size_t i = 0; i < kSolid; ++i) scene.part("Branch", {float(i), 0, 0}, model);
  const importer::Tree tree(scene.document);
  const importer::Assemblies assemblies(tree);
  LevelDraft level = importer::buildLevel(tree, {}, "test");
  importer::RoleContext context(tree, assemblies, level);
  importer::Motion motion;
  for (size_t i = 0; i < kKeys; ++i) motion.keys.push_back(keyAt(float(i) / 60, float(i % 2)));
  for (int i = 0; i < 2; ++i) importer::giveMotion(context, model, motion, "a test", false);
  ASSERT_TRUE(context.part(first));
  context.part(first)->kill = importer::Kill{};
  importer::settleMotions(context);
  size_t moving = 0;
  for (const PartDraft& part : level.parts) {
    moving += part.motion ? 1 : 0;
    EXPECT_TRUE(part.motion || !(part.solid || part.kill)) << part.id;
  }
  constexpr size_t kCapacity = importer::kMaxLevelKeys / kKeys;
  EXPECT_EQ(moving, kCapacity);
  EXPECT_EQ(level.unmodelled.count("motion with too many poses"), 0u);
  ASSERT_EQ(level.ignored.count("moving decoration"), 1u);
  EXPECT_EQ(level.ignored.at("moving decoration").count, kSolid + kLeaves - kCapacity);
}

// Fails if the work takes longer than 10 s. Work that grows with the square of the number of items
// would.
template <class Work>
void expectQuick(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Motion, AModelOfManyWeldedPartsMovesAsOne) {
  constexpr int kParts = 15000;
  Scene scene;
  const auto model = scene.add("Model", "Raft", scene.workspace);
  const auto hub = scene.part("Hub", {}, model);
  for (int i = 1; i < kParts; ++i) {
    const auto plank = scene.part("Plank", {float(i % 100), 0, float(i / 100)}, model);
    scene.set(plank, "Anchored", false);
    const auto weld = scene.add("WeldConstraint", "Weld", plank);
    scene.set(weld, "Part0", Ref{hub});
    scene.set(weld, "Part1", Ref{plank});
  }
  const importer::Tree tree(scene.document);
  const importer::Assemblies assemblies(tree);
  LevelDraft level = importer::buildLevel(tree, {}, "test");
  importer::RoleContext context(tree, assemblies, level);
  importer::Motion motion;
  motion.spin = importer::Spin{{0, 1, 0}, 1, {}};
  expectQuick(
      [&] { EXPECT_EQ(importer::giveMotion(context, model, motion, "a test", false), kParts); });
}

TEST(Motion, AModelWithManyMarkerFoldersUsesTheFirst) {
  Scene scene;
  const auto model = scene.add("Model", "Lift", scene.workspace);
  const auto platform = scene.part("Platform", {}, model);
  for (int i = 0; i < 20000; ++i) {
    const auto folder = scene.add("Folder", "Positions", model);
    if (i > 0) continue;
    scene.part("1", {}, folder);
    scene.part("2", {0, 20, 0}, folder);
  }
  expectQuick([&] { scene.level(); });
  ASSERT_TRUE(scene[platform].motion);
  EXPECT_EQ(scene.evidence(platform, "motion"), "guessed: marker Positions");
}

TEST(Kill, ATagInManySpellingsCountsOnce) {
  Scene scene;
  const auto folder = scene.add("Folder", "Hot", scene.workspace);
  for (unsigned spelling = 0; spelling < 4096; ++spelling) {
    std::string tag = "obstaclekill";
    for (size_t i = 0; i < tag.size(); ++i)
      if (((spelling >> i) & 1u) != 0) tag[i] = char(tag[i] - 'a' + 'A');
    scene.tag(folder, tag);
  }
  InstanceId last = kNoInstance;
  for (int i = 0; i < 20000; ++i) last = scene.part("Part", {float(i % 100), 0, 0}, folder);
  expectQuick([&] { scene.level(); });
  EXPECT_EQ(scene.evidence(last, "kill"), "tag obstaclekill");
}

TEST(Vanish, ManyMarkersOfOneOwnerCountOnce) {
  Scene scene;
  const auto model = scene.add("Model", "Fading", scene.workspace);
  scene.value("NumberValue", "FadeTime", 4.0, model);
  for (int i = 0; i < 20000; ++i) scene.value("NumberValue", "FadeTime", 9.0, model);
  InstanceId last = kNoInstance;
  for (int i = 0; i < 5000; ++i) last = scene.part("Part", {float(i), 0, 0}, model);
  expectQuick([&] { scene.level(); });
  ASSERT_TRUE(scene[last].vanish);
  EXPECT_FLOAT_EQ(scene[last].vanish->delay, 4);
}

TEST(Vanish, EndlessTimesAreCappedAtAnHour) {
  Scene scene;
  const auto model = scene.add("Model", "Fading", scene.workspace);
  scene.value("NumberValue", "FadeTime", 1e300, model);
  scene.value("NumberValue", "RespawnTime", 1e300, model);
  const auto part = scene.part("Part", {}, model);
  scene.level();
  ASSERT_TRUE(scene[part].vanish);
  EXPECT_FLOAT_EQ(scene[part].vanish->delay, 3600);
  EXPECT_FLOAT_EQ(scene[part].vanish->away, 3600);
}

}  // namespace
}  // namespace obby::test
