// Parts that scripts remove from the world, put back, or put elsewhere.
#include "import/scene.h"

namespace obby::test {
namespace {

const char* const kComesOrGoes = "part that comes and goes irregularly";

// Expects that the part appears or vanishes for good at `seconds`, and that no loss is noted.
void expectOnce(Scene& scene, InstanceId part, float seconds, bool comes) {
  const auto& level = scene.level();
  ASSERT_EQ(level.parts.size(), 1u);
  const auto& vanish = scene[part].vanish;
  ASSERT_TRUE(vanish && vanish->timer && vanish->signal.empty());
  EXPECT_EQ(vanish->inverted, comes);
  EXPECT_NEAR(vanish->delay, seconds, 0.1);
  EXPECT_EQ(vanish->away, importer::kGone);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(Removal, PartsThatATouchRemovesVanish) {
  struct Case {
    const char* text;
    float delay, away;
  };
  constexpr float kForGood = 3600;
  const Case cases[] = {
      {"p.Parent = nil", 0, kForGood},
      {"p.parent = nil", 0, kForGood},
      {"wait(1) p.Parent = game.ServerStorage", 1, kForGood},
      {"p.Parent = game.Lighting wait(3) p.Parent = workspace", 0, 3},
      {"local was = p.Parent p.Parent = nil wait(2) p.Parent = was", 0, 2},
      {"p:Remove() wait(2) p.Parent = workspace.Folder", 0, 2},
      {"task.delay(4, function() p.Parent = workspace end) task.wait(1) p.Parent = nil", 1, 3},
      {"game.Debris:AddItem(p, 2)", 2, kForGood},
      {"game:GetService('Debris'):AddItem(p)", 10, kForGood},
      {"game.Debris:AddItem(p, 5) wait(1) p.CanCollide = false", 1, kForGood},
      {"p.Parent:ClearAllChildren()", 0, kForGood}};
  for (const Case& now : cases) {
    Scene scene;
    const auto folder = scene.add("Folder", "Folder", scene.workspace);
    scene.add("ServerStorage", "ServerStorage", kNoInstance);
    const auto part = scene.part("Part", {}, folder);
    scene.script("local p = workspace.Folder.Part\np.Touched:Connect(function() " +
                     std::string(now.text) + " end)",
                 scene.scripts);
    scene.level();
    ASSERT_TRUE(scene[part].vanish) << now.text;
    EXPECT_NEAR(scene[part].vanish->delay, now.delay, 0.06) << now.text;
    EXPECT_NEAR(scene[part].vanish->away, now.away, 0.06) << now.text;
    EXPECT_EQ(scene.evidence(part, "vanish").rfind("script Script", 0), 0u) << now.text;
  }
}

TEST(Removal, MovingAPartWithinTheWorldRemovesNothing) {
  const char* const texts[] = {
      "p.Parent = workspace", "p.Parent = workspace.Folder", "p.Parent = p.Parent",
      "local f = Instance.new('Folder', workspace) p.Parent = f", "wait(5) p.Parent = workspace"};
  for (const char* text : texts) {
    Scene scene;
    scene.add("Folder", "Folder", scene.workspace);
    const auto part = scene.part("Part");
    scene.script("local p = workspace.Part " + std::string(text), scene.scripts);
    EXPECT_EQ(scene.level().parts.size(), 1u) << text;
    EXPECT_TRUE(scene[part].evidence.empty()) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

TEST(Removal, PartsRemovedAtTheStartAreOmitted) {
  const char* const texts[] = {
      "workspace.Folder.Part.Parent = game.ServerStorage", "workspace.Folder.Part.Parent = script",
      "workspace.Folder.Part:Remove()", "workspace.Folder:ClearAllChildren()",
      "game:GetService('Debris'):AddItem(workspace.Folder.Part, 0)"};
  for (const char* text : texts) {
    Scene scene;
    const auto floor = scene.part("Floor", {0, -9, 0});
    const auto folder = scene.add("Folder", "Folder", scene.workspace);
    scene.part("Part", {}, folder);
    scene.script(text, scene.scripts);
    const auto& level = scene.level();
    ASSERT_EQ(level.parts.size(), 1u) << text;
    EXPECT_EQ(level.parts[0].id, floor) << text;
    EXPECT_TRUE(level.unmodelled.empty()) << text;
  }
}

TEST(Removal, ReturningPartsReappearAtTheirTime) {
  Scene scene;
  const auto bridge = scene.part("Bridge");
  scene.script("local b = workspace.Bridge\nb.Parent = nil\nwait(9)\nb.Parent = workspace",
               scene.scripts);
  expectOnce(scene, bridge, 9, true);
}

TEST(Removal, AButtonRestoresARemovedPart) {
  Scene scene;
  const auto button = scene.part("Button"), bridge = scene.part("Bridge", {9, 0, 0});
  scene.script(
      "local b = workspace.Bridge\nb.Parent = nil\nscript.Parent.Touched:Connect(function()\n"
      " b.Parent = workspace wait(5) b.Parent = nil end)",
      button);
  scene.level();
  ASSERT_TRUE(scene[button].button && scene[bridge].vanish);
  EXPECT_TRUE(scene[bridge].vanish->inverted);
  EXPECT_EQ(scene[bridge].vanish->signal, scene[button].button->signal);
  EXPECT_NEAR(scene[button].button->seconds, 5, 0.1);
  EXPECT_FALSE(scene[button].vanish);
}

TEST(Removal, AButtonBringsAPartFromStorage) {
  for (const char* condition : {"true", "open"}) {
    Scene scene;
    const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
    const auto button = scene.part("Button"), bridge = scene.part("Bridge", {9, 0, 0}, storage);
    scene.script(std::string("local open = false script.Parent.Touched:Connect(function() if ") +
                     condition +
                     " then\ngame.ServerStorage.Bridge.Parent = workspace end end)\n"
                     "for i = 1, 20 do wait(1) end open = true",
                 button);
    scene.level();
    ASSERT_TRUE(scene[button].button && scene[bridge].vanish) << condition;
    EXPECT_TRUE(scene[bridge].vanish->inverted);
    EXPECT_EQ(scene[bridge].vanish->signal, scene[button].button->signal);
    EXPECT_TRUE(scene[button].button->forever);
  }
}

TEST(Removal, PartsRestoredAtOnceStay) {
  Scene scene;
  const auto part = scene.part("Part");
  scene.script("local p = workspace.Part\np.Parent = nil\np.Parent = workspace", scene.scripts);
  EXPECT_EQ(scene.level().parts.size(), 1u);
  EXPECT_TRUE(scene[part].solid);
  EXPECT_TRUE(scene.level().unmodelled.empty());
}

TEST(Removal, PartsRemovedAndRestoredInALoopVanish) {
  const char* const loops[] = {
      "while true do p.Parent = workspace wait(3) p.Parent = nil wait(1) end",
      "p.Parent = nil while true do wait(1) p.Parent = workspace wait(3) p.Parent = nil end"};
  for (const char* loop : loops) {
    Scene scene;
    const auto part = scene.part("Blink");
    scene.script("local p = workspace.Blink " + std::string(loop), scene.scripts);
    const auto& level = scene.level();
    ASSERT_EQ(level.parts.size(), 1u) << loop;
    ASSERT_TRUE(scene[part].vanish) << loop;
    EXPECT_TRUE(scene[part].vanish->timer) << loop;
    EXPECT_NEAR(scene[part].vanish->away, 1, 1e-3) << loop;
    EXPECT_NEAR(scene[part].vanish->delay, 3, 1e-3) << loop;
    EXPECT_TRUE(level.unmodelled.empty()) << loop;
  }
}

TEST(Removal, PartsRemovedDuringPlayVanishOnce) {
  const char* const texts[] = {"wait(5) workspace.Folder.Part.Parent = nil",
                               "wait(5) workspace.Folder:ClearAllChildren()"};
  for (const char* text : texts) {
    Scene scene;
    const auto part = scene.part("Part", {}, scene.add("Folder", "Folder", scene.workspace));
    scene.script(text, scene.scripts);
    expectOnce(scene, part, 5, false);
  }
}

TEST(Removal, PartsFromStorageAppearAtTheirTime) {
  Scene scene;
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  const auto plank = scene.part("Plank", {}, scene.add("Model", "Stage1", storage));
  scene.script("wait(6) game.ServerStorage.Stage1.Parent = workspace", scene.scripts);
  expectOnce(scene, plank, 6, true);
}

TEST(Removal, PartsThatComeAndGoOnceAreReported) {
  Scene scene;
  scene.part("Part");
  scene.script("local p = workspace.Part wait(5) p.Parent = nil wait(5) p.Parent = workspace",
               scene.scripts);
  EXPECT_EQ(scene.level().parts.size(), 1u);
  EXPECT_EQ(scene.unmodelled(kComesOrGoes), 1u);
}

TEST(Removal, PartsFromStorageAreBuiltAtTheStart) {
  Scene scene;
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  scene.part("Plank", {}, scene.add("Model", "Stage1", storage));
  scene.script("game.ServerStorage.Stage1.Parent = workspace", scene.scripts);
  const auto& level = scene.level();
  EXPECT_EQ(level.parts.size(), 1u);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(Removal, SizeChangesByATouchAreReported) {
  const char* const texts[] = {"p.Size = Vector3.new(1, 1, 1)",
                               "game:GetService('TweenService'):Create(p, TweenInfo.new(2), "
                               "{Size = Vector3.new(0, 0, 0)}):Play()"};
  for (const char* text : texts) {
    Scene scene;
    const auto part = scene.part("Shrinks");
    scene.script(
        "local p = script.Parent\np.Touched:Connect(function() " + std::string(text) + " end)",
        part);
    scene.level();
    EXPECT_EQ(scene.unmodelled("size that scripts change"), 1u) << text;
  }
}

}  // namespace
}  // namespace obby::test
