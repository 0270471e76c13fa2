// Script changes to parts at the start of play are in the level, with the script lines as evidence.
#include <chrono>

#include "import/motion_checks.h"

namespace obby::test {
namespace {

TEST(ScriptedStart, SwitchesSetAtTheStartApply) {
  Scene scene;
  const auto barrier = scene.part("Barrier");
  scene.script("workspace.Barrier.CanCollide = false\nworkspace.Barrier.CanTouch = false",
               scene.scripts, "Setup");
  const auto& level = scene.level();
  EXPECT_FALSE(scene[barrier].solid);
  EXPECT_FALSE(scene[barrier].touch);
  EXPECT_EQ(scene.evidence(barrier, "scripted"),
            "not solid; script Setup line 1: workspace.Barrier.CanCollide = false");
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, ALoopOverAFolderSetsAllOfIt) {
  Scene scene;
  const auto folder = scene.add("Folder", "Ghosts", scene.workspace);
  const auto a = scene.part("A", {}, folder), b = scene.part("B", {9, 0, 0}, folder);
  const auto floor = scene.part("Floor", {0, -5, 0});
  scene.script(
      "for _, p in workspace.Ghosts:GetChildren() do p.CanCollide = false p.Transparency = 1 end",
      scene.scripts);
  scene.level();
  for (const auto ghost : {a, b}) {
    EXPECT_FALSE(scene[ghost].solid);
    EXPECT_EQ(scene[ghost].transparency, 1);
  }
  EXPECT_TRUE(scene[floor].solid);
}

TEST(ScriptedStart, TheLastWriteCounts) {
  Scene scene;
  const auto back = scene.part("Back"), gone = scene.part("Gone");
  scene.set(gone, "CanCollide", false);
  scene.script(
      "workspace.Back.CanCollide = false\nworkspace.Back.CanCollide = true\n"
      "workspace.Gone.CanCollide = true",
      scene.scripts, "First");
  scene.script("workspace.Gone.CanCollide = false", scene.scripts, "Second");
  const auto& level = scene.level();
  EXPECT_TRUE(scene[back].solid);
  EXPECT_FALSE(scene[gone].solid);
  EXPECT_TRUE(scene[back].evidence.empty()) << "as in the file";
  EXPECT_TRUE(scene[gone].evidence.empty()) << "as in the file";
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, DestroyedPartsAreOmitted) {
  Scene scene;
  const auto floor = scene.part("Floor", {0, -9, 0});
  for (const char* name : {"Barrier", "Lid"}) scene.part(name);
  const auto old = scene.add("Model", "Old", scene.workspace);
  scene.part("A", {}, old);
  scene.part("B", {}, scene.add("Folder", "Inside", old));
  scene.script("workspace.Barrier:Destroy()\nworkspace.Lid.Parent = nil\nworkspace.Old:Destroy()",
               scene.scripts);
  const auto& level = scene.level();
  ASSERT_EQ(level.parts.size(), 1u);
  EXPECT_EQ(level.parts[0].id, floor);
  ASSERT_EQ(level.ignored.count("part that a script destroys at start"), 1u);
  const auto& gone = level.ignored.at("part that a script destroys at start");
  EXPECT_EQ(gone.count, 4u);
  EXPECT_NE(gone.note.find("line 1: workspace.Barrier:Destroy()"), std::string::npos);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, RestoredPartsArePresent) {
  const char* const texts[] = {
      "local copy = workspace.Kit.Box:Clone() workspace.Kit.Box:Destroy() copy.Parent = workspace",
      "for _, p in workspace.Kit:GetChildren() do p.Parent = workspace end workspace.Kit:Destroy()",
      "local kit = workspace.Kit:Clone()\nworkspace.Kit:remove()\nkit.Parent = workspace"};
  for (const char* text : texts) {
    Scene scene;
    scene.part("Box", {1, 2, 3}, scene.add("Model", "Kit", scene.workspace));
    scene.script(text, scene.scripts);
    const auto& level = scene.level();
    ASSERT_EQ(level.parts.size(), 1u) << text;
    EXPECT_TRUE(level.parts[0].solid && level.parts[0].anchored) << text;
    EXPECT_EQ(level.parts[0].pose.position, (Vec3{1, 2, 3})) << text;
    EXPECT_TRUE(level.unmodelled.empty()) << text;
  }
}

TEST(ScriptedStart, AMovedPartHasItsScriptedPose) {
  Scene scene;
  const auto bridge = scene.part("Bridge"), gate = scene.part("Gate", {5, 6, 7});
  scene.script(
      "workspace.Bridge.Position = Vector3.new(0, 20, 40)\n"
      "workspace.Gate.Orientation = Vector3.new(0, 90, 0)",
      scene.scripts);
  const auto& level = scene.level();
  EXPECT_EQ(scene[bridge].pose.position, (Vec3{0, 20, 40}));
  EXPECT_EQ(scene[gate].pose.position, (Vec3{5, 6, 7}));
  expectNear(scene[gate].pose.rotation.x, {0, 0, -1}, 1e-4f);
  EXPECT_EQ(scene.evidence(bridge, "scripted").rfind("placed; script Script line 1", 0), 0u);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, AMovedModelTakesItsPartsAlong) {
  Scene scene;
  const auto model = scene.add("Model", "Train", scene.workspace);
  const auto engine = scene.part("Engine", {0, 5, 0}, model),
             wagon = scene.part("Wagon", {0, 5, 6}, model);
  const auto flag = scene.part("Flag", {0, 9, 6}, scene.add("Model", "Roof", model));
  scene.set(model, "PrimaryPart", Ref{engine});
  const auto dynamic = scene.add("Model", "Stage", scene.workspace);
  const auto left = scene.part("Left", {-4, 0, 0}, dynamic),
             right = scene.part("Right", {4, 0, 0}, dynamic);
  scene.script(R"(local m = workspace.Train
m.Wagon.Position = m.Wagon.Position + Vector3.new(0, 0, 2)
m:PivotTo(CFrame.new(10, 5, 0))
m.Roof:TranslateBy(Vector3.new(0, 1, 0))
m.Engine.Position = m.Engine.Position + Vector3.new(3, 0, 0)
for i = 1, 3 do workspace.Stage:PivotTo(workspace.Stage:GetPivot() * CFrame.new(0, 0, 10)) end)",
               scene.scripts);
  scene.level();
  expectNear(scene[engine].pose.position, {13, 5, 0});
  expectNear(scene[wagon].pose.position, {10, 5, 8});
  expectNear(scene[flag].pose.position, {10, 10, 6});
  expectNear(scene[left].pose.position, {-4, 0, 30});
  expectNear(scene[right].pose.position, {4, 0, 30});
}

TEST(ScriptedStart, WeldedPartsFollowAMovedPart) {
  Scene scene;
  const auto hub = scene.part("Hub"), arm = scene.part("Arm", {10, 0, 0});
  scene.set(arm, "Anchored", false);
  const auto weld = scene.add("WeldConstraint", "Weld", hub);
  scene.set(weld, "Part0", Ref{hub});
  scene.set(weld, "Part1", Ref{arm});
  scene.script("workspace.Hub.CFrame = CFrame.new(0, 10, 0) * CFrame.Angles(0, math.pi / 2, 0)",
               scene.scripts);
  scene.level();
  expectNear(scene[hub].pose.position, {0, 10, 0});
  expectNear(scene[arm].pose.position, {0, 10, -10});
}

TEST(ScriptedStart, StraysAreDeterminedAfterTheStart) {
  Scene scene;
  scene.part("Floor");
  const auto lift = scene.part("Lift", {0, -900, 0}), trap = scene.part("Trap", {9, 0, 0});
  scene.script(
      "workspace.Lift.Position = Vector3.new(0, 5, 0)\n"
      "workspace.Trap.Position = Vector3.new(0, -2000, 0)",
      scene.scripts);
  const auto& level = scene.level();
  EXPECT_EQ(level.parts.size(), 2u);
  EXPECT_EQ(level.partsCulled, 1u);
  for (const PartDraft& part : level.parts) EXPECT_NE(part.id, trap);
  EXPECT_EQ(scene[lift].pose.position, (Vec3{0, 5, 0}));
}

TEST(ScriptedStart, SizesAreClampedLikeInTheEngine) {
  Scene scene;
  const auto bridge = scene.part("Bridge"), grown = scene.part("Grown");
  scene.script(
      "workspace.Bridge.Size = Vector3.new(8, 1, 30)\n"
      "workspace.Grown.Size = workspace.Grown.Size * 1000",
      scene.scripts);
  const auto& level = scene.level();
  EXPECT_EQ(scene[bridge].size, (Vec3{8, 1, 30}));
  EXPECT_EQ(scene[grown].size, (Vec3{2048, 1000, 2048}));
  EXPECT_EQ(scene.evidence(bridge, "scripted").rfind("resized; script", 0), 0u);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, AnchoringIsDeterminedAfterTheStart) {
  Scene scene;
  const auto crate = scene.part("Crate"), held = scene.part("Held"), tied = scene.part("Tied");
  scene.set(held, "Anchored", false);
  const auto weld = scene.add("Weld", "Weld", tied);
  scene.set(weld, "Part0", Ref{tied});
  scene.set(weld, "Part1", Ref{scene.part("Post")});
  scene.script(
      "workspace.Crate.Anchored = false\nworkspace.Held.Anchored = true\n"
      "workspace.Tied.Anchored = false",
      scene.scripts);
  const auto& level = scene.level();
  EXPECT_FALSE(scene[crate].anchored);
  EXPECT_TRUE(scene[held].anchored);
  EXPECT_TRUE(scene[tied].anchored) << "the post holds it";
  EXPECT_EQ(scene.evidence(held, "scripted").rfind("anchored; script", 0), 0u);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, PartsJoinedToAnAnchoredPartAreHeld) {
  const char* const joints[] = {"local weld = Instance.new('Weld') weld.C0 = CFrame.new(0, 5, 0)",
                                "local weld = Instance.new('WeldConstraint') "
                                "workspace.Door.Position = Vector3.new(20, 5, 0)"};
  for (const char* joint : joints) {
    Scene scene;
    const auto door = scene.part("Door");
    scene.part("Frame", {20, 0, 0});
    scene.script(std::string(joint) +
                     " weld.Part0 = workspace.Frame weld.Part1 = workspace.Door\n"
                     "weld.Parent = workspace.Door workspace.Door.Anchored = false",
                 scene.scripts);
    const auto& level = scene.level();
    EXPECT_TRUE(scene[door].anchored) << joint;
    EXPECT_EQ(scene[door].pose.position, (Vec3{20, 5, 0})) << joint;
    EXPECT_TRUE(level.unmodelled.empty()) << joint;
  }
}

TEST(ScriptedStart, PartsCutFromTheirJointsAreDynamic) {
  const char* const cuts[] = {"workspace.Tied.Weld:Destroy()", "workspace.Tied:BreakJoints()",
                              "workspace.Tied.Weld.Enabled = false"};
  for (const char* cut : cuts) {
    Scene scene;
    const auto tied = scene.part("Tied");
    scene.set(tied, "Anchored", false);
    const auto weld = scene.add("WeldConstraint", "Weld", tied);
    scene.set(weld, "Part0", Ref{tied});
    scene.set(weld, "Part1", Ref{scene.part("Post", {0, 5, 0})});
    scene.script(cut, scene.scripts);
    scene.level();
    EXPECT_FALSE(scene[tied].anchored) << cut;
  }
}

TEST(ScriptedStart, APlatformTurnsAtItsScriptedPosition) {
  const char* const moves[] = {
      "while true do p.CFrame = p.CFrame * CFrame.Angles(0, 0.1, 0) task.wait() end",
      "game:GetService('TweenService'):Create(p, TweenInfo.new(2, Enum.EasingStyle.Linear, "
      "Enum.EasingDirection.Out, -1), {Orientation = Vector3.new(0, 360, 0)}):Play()"};
  for (const char* move : moves) {
    Scene scene;
    const auto part = scene.part("Platform", {3, 4, 5});
    scene.script("local p = script.Parent\np.CFrame = CFrame.new(0, 10, 0)\n" + std::string(move),
                 part);
    const auto& level = scene.level();
    ASSERT_TRUE(scene[part].motion) << move;
    for (const double time : {0.0, 7.0}) expectNear(poseAt(scene[part], time).position, {0, 10, 0});
    EXPECT_TRUE(level.unmodelled.empty()) << move;
  }
}

TEST(ScriptedStart, ATaggedSpinnerTurnsAtItsScriptedPosition) {
  Scene scene;
  const auto mill = scene.part("Mill");
  scene.tag(mill, "Spinner");
  scene.attribute(mill, "Speed", 90.0);
  scene.script("workspace.Mill.Position = Vector3.new(0, 50, 0)", scene.scripts);
  scene.level();
  EXPECT_EQ(scene[mill].pose.position, (Vec3{0, 50, 0}));
  ASSERT_TRUE(scene[mill].motion && scene[mill].motion->spin);
  expectNear(scene[mill].motion->spin->pivot, {});
}

TEST(ScriptedStart, ScriptedPropertiesKeepOtherRoles) {
  Scene scene;
  const auto lava = scene.part("Lava"), blink = scene.part("Blink");
  scene.tag(lava, "KillBrick");
  scene.script("workspace.Lava.CanCollide = false", scene.scripts);
  scene.script(
      "local p = script.Parent\np.CanCollide = false\nwhile true do wait(2) p.CanCollide = true "
      "wait(1) p.CanCollide = false end",
      blink);
  const auto& level = scene.level();
  EXPECT_FALSE(scene[lava].solid);
  EXPECT_TRUE(scene[lava].kill) << "by its tag";
  EXPECT_TRUE(scene[blink].solid) << "but for the times of its timer";
  ASSERT_TRUE(scene[blink].vanish);
  EXPECT_NEAR(scene[blink].vanish->away, 2, 1e-3);
  EXPECT_TRUE(level.unmodelled.empty());
}

TEST(ScriptedStart, ManyMovedPartsAreFollowedWithinABudget) {
  Scene scene;
  const auto big = scene.add("Model", "Big", scene.workspace);
  for (int i = 0; i < 3000; ++i) scene.part("Part", {float(i), 0, 0}, big);
  scene.script("for i = 1, 2000 do workspace.Big:PivotTo(CFrame.new(i, 0, 0)) end", scene.scripts);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(scene.level().parts.size(), 3000u);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_EQ(scene.unmodelled("script that fails"), 1u);
}

}  // namespace
}  // namespace obby::test
