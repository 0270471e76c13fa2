// Script changes to parts after the start, or for one player alone, are noted.
#include <utility>

#include "import/scene.h"

namespace obby::test {
namespace {

TEST(ScriptedChanges, LateChangesAreReportedAndNotApplied) {
  const std::pair<const char*, const char*> cases[] = {
      {"wait(5) workspace.Barrier.Anchored = false", "part that scripts release"},
      {"wait(5) workspace.Barrier.CanTouch = false", "touch that scripts switch on or off"},
      {"wait(5) workspace.Barrier.Size = Vector3.one", "size that scripts change"},
      {"while true do workspace.Barrier.Size += Vector3.yAxis wait(4) end",
       "size that scripts change"}};
  for (const auto& [text, kind] : cases) {
    Scene scene;
    const auto barrier = scene.part("Barrier");
    scene.set(barrier, "CanCollide", false);
    scene.script(text, scene.scripts);
    const auto& level = scene.level();
    EXPECT_FALSE(scene[barrier].solid) << text;
    EXPECT_TRUE(scene[barrier].touch && scene[barrier].anchored) << text;
    ASSERT_EQ(scene.unmodelled(kind), 1u) << text;
    EXPECT_EQ(level.unmodelled.at(kind).example, "Workspace/Barrier");
    EXPECT_NE(level.unmodelled.at(kind).note.find("script Script line 1"), std::string::npos);
  }
}

// The change is within the first three seconds.
TEST(ScriptedChanges, EarlyChangesAreApplied) {
  Scene scene;
  const auto barrier = scene.part("Barrier");
  scene.script(
      "local b = workspace.Barrier wait(1) b.CanTouch = false b.Anchored = false b.CanCollide = "
      "false\ngame:GetService('TweenService'):Create(b, TweenInfo.new(1), "
      "{Size = Vector3.new(9, 1, 9)}):Play()",
      scene.scripts);
  const auto& level = scene.level();
  EXPECT_FALSE(scene[barrier].touch || scene[barrier].anchored || scene[barrier].solid);
  EXPECT_EQ(scene[barrier].size, (Vec3{9, 1, 9}));
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedChanges, AChangeRevertedLaterIsSolidFromThen) {
  Scene scene;
  const auto gate = scene.part("Gate");
  scene.script("workspace.Gate.CanCollide = false\nwait(5)\nworkspace.Gate.CanCollide = true",
               scene.scripts);
  scene.level();
  EXPECT_TRUE(scene[gate].solid);
  ASSERT_TRUE(scene[gate].vanish);
  EXPECT_TRUE(scene[gate].vanish->inverted);
  EXPECT_NEAR(scene[gate].vanish->delay, 5, 0.1);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(ScriptedChanges, ChangesWithoutAnEffectAreNotReported) {
  const char* const texts[] = {"wait(5) workspace.Part.CanCollide = true",
                               "wait(5) workspace.Part.Anchored = true",
                               "wait(5) workspace.Part.Position = Vector3.new(0, 0, 0)",
                               "wait(5) workspace.Part.Size = Vector3.new(4, 1, 4)",
                               "for i = 1, 10 do workspace.Part.Transparency = i / 10 wait() end",
                               "wait(5) workspace.Part.Velocity = Vector3.new(0, 0, 0) "};
  for (const char* text : texts) {
    Scene scene;
    scene.part("Part");
    scene.script(text, scene.scripts);
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(ScriptedChanges, ClientChangesApplyToTheirPlayer) {
  Scene scene;
  const auto barrier = scene.part("Barrier");
  const auto player = scene.add("StarterPlayer", "StarterPlayer", kNoInstance);
  const auto folder = scene.add("StarterPlayerScripts", "StarterPlayerScripts", player);
  const auto local = scene.add("LocalScript", "Local", folder);
  scene.set(local, "Source", std::string("workspace.Barrier.CanCollide = false"));
  scene.level();
  EXPECT_FALSE(scene[barrier].solid);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(ScriptedChanges, ScriptsThatDoNotRunChangeNothing) {
  Scene scene;
  const auto barrier = scene.part("Barrier");
  scene.set(scene.script("workspace.Barrier.CanCollide = false", barrier), "Disabled", true);
  scene.script("workspace.Barrier:Destroy()",
               scene.add("ServerStorage", "ServerStorage", kNoInstance));
  EXPECT_TRUE(scene.level().unmodelled.empty());
  EXPECT_TRUE(scene[barrier].solid);
}

TEST(ScriptedChanges, EveryPartOfAModelCounts) {
  Scene scene;
  const auto model = scene.add("Model", "Bridge", scene.workspace);
  for (int i = 0; i < 3; ++i) scene.part("Plank", {4 * float(i), 0, 0}, model);
  scene.script("wait(20) workspace.Bridge:Destroy()", scene.scripts);
  for (const PartDraft& part : scene.level().parts) {
    ASSERT_TRUE(part.vanish);
    EXPECT_NEAR(part.vanish->delay, 20, 0.1);
  }
}

}  // namespace
}  // namespace obby::test
