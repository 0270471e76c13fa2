// What scripts change of parts after the start, or for one player alone, is named.
#include "import/scene.h"

namespace obby::test {
namespace {

const char* const kScriptedChangesInPlay = "part that a script changes in play";

TEST(ScriptedChanges, WhatComesLaterIsNamedNotDone) {
  const char* const texts[] = {"wait(5) workspace.Barrier.CanCollide = true",
                               "task.delay(3, function() workspace.Barrier:Destroy() end)",
                               "wait(2) workspace.Barrier.Position = Vector3.new(0, 50, 0)",
                               "wait(1) workspace.Barrier.Anchored = false",
                               "wait(1) workspace.Barrier.CanTouch = false",
                               "while true do workspace.Barrier.CanCollide = true wait(1) end",
                               "while true do wait(9) workspace.Barrier:Destroy() end",
                               "game:GetService('RunService').Heartbeat:Connect(function() "
                               "workspace.Barrier.CanCollide = true end)"};
  for (const char* text : texts) {
    Scene scene;
    const auto barrier = scene.part("Barrier");
    scene.set(barrier, "CanCollide", false);
    scene.script(text, scene.scripts);
    const auto& level = scene.level();
    EXPECT_FALSE(scene[barrier].solid) << text;
    EXPECT_TRUE(scene[barrier].touch && scene[barrier].anchored) << text;
    EXPECT_EQ(scene[barrier].pose.position, (Vec3{})) << text;
    ASSERT_EQ(scene.unmodelled(kScriptedChangesInPlay), 1u) << text;
    EXPECT_EQ(level.unmodelled.at(kScriptedChangesInPlay).example, "Workspace/Barrier");
    EXPECT_NE(level.unmodelled.at(kScriptedChangesInPlay).note.find("script Script line 1"),
              std::string::npos);
  }
}

TEST(ScriptedChanges, TheStartIsSetAndWhatFollowsIsNamed) {
  Scene scene;
  const auto gate = scene.part("Gate");
  scene.script("workspace.Gate.CanCollide = false\nwait(5)\nworkspace.Gate.CanCollide = true",
               scene.scripts);
  scene.level();
  EXPECT_FALSE(scene[gate].solid);
  EXPECT_EQ(scene.unmodelled(kScriptedChangesInPlay), 1u);
}

TEST(ScriptedChanges, WhatChangesNothingIsNotNamed) {
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

TEST(ScriptedChanges, SizesThatChangeByAndByAreNamed) {
  const char* const texts[] = {
      "game:GetService('TweenService'):Create(p, TweenInfo.new(2), "
      "{Size = Vector3.new(9, 1, 9)}):Play()",
      "while true do p.Size = p.Size + Vector3.new(0, 1, 0) wait(1) end",
      "game:GetService('RunService').Heartbeat:Connect(function() "
      "p.Size = p.Size + Vector3.new(0, 1, 0) end)",
      "wait(3) p.Size = Vector3.new(9, 1, 9)", "p.Size = other()"};
  for (const char* text : texts) {
    Scene scene;
    const auto part = scene.part("Crusher");
    scene.script("local p = script.Parent\n" + std::string(text), part);
    scene.level();
    EXPECT_EQ(scene[part].size, (Vec3{4, 1, 4})) << text;
    EXPECT_EQ(scene.unmodelled("size that a script changes"), 1u) << text;
  }
}

TEST(ScriptedChanges, WhatAClientDoesIsThereForItsPlayer) {
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
  scene.script("wait(60) workspace.Bridge:Destroy() workspace.Bridge:Destroy()", scene.scripts);
  scene.level();
  EXPECT_EQ(scene.unmodelled(kScriptedChangesInPlay), 3u);
}

}  // namespace
}  // namespace obby::test
