// Conveyors and jump pads.
#include "import/scene.h"

namespace obby::test {
namespace {

void expectNear(Vec3 a, Vec3 b, float slack = 1e-3f) {
  EXPECT_NEAR(a.x, b.x, slack);
  EXPECT_NEAR(a.y, b.y, slack);
  EXPECT_NEAR(a.z, b.z, slack);
}

const Mat3 kTurnedLeft = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};  // looks along -X

TEST(Conveyor, TemplateScriptTurnsLocalSpeedToTheWorld) {
  Scene scene;
  const auto part = scene.part("Conveyor");
  scene.set(part, "CFrame", CFrame{{}, kTurnedLeft});
  const auto configuration = scene.add("Configuration", "Configuration", part);
  scene.value("IntValue", "Speed", int64_t{10}, configuration);
  scene.script(
      "local conveyor = script.Parent\n"
      "conveyor.Velocity = conveyor.CFrame:vectorToWorldSpace("
      "Vector3.new(0, 0, -conveyor.Configuration.Speed.Value))",
      part);
  scene.level();
  ASSERT_TRUE(scene[part].conveyor);
  expectNear(scene[part].conveyor->velocity, {-10, 0, 0});
}

TEST(Conveyor, LookVectorTimesSpeed) {
  for (const char* code :
       {"script.Parent.AssemblyLinearVelocity = script.Parent.CFrame.LookVector * 12",
        "while true do script.Parent.Velocity = script.Parent.CFrame.lookVector*12 wait() end",
        "game:GetService('RunService').Heartbeat:Connect(function() "
        "script.Parent.Velocity = -script.Parent.CFrame.ZVector * 12 end)"}) {
    Scene scene;
    const auto part = scene.part("Belt");
    scene.script(code, part);
    scene.level();
    ASSERT_TRUE(scene[part].conveyor) << code;
    expectNear(scene[part].conveyor->velocity, {0, 0, -12});
  }
}

TEST(Conveyor, TagWithSpeed) {
  Scene scene;
  const auto part = scene.part("A"), guess = scene.part("B");
  scene.tag(part, "Conveyor");
  scene.attribute(part, "Speed", 25.0);
  scene.tag(guess, "Conveyor");
  scene.level();
  expectNear(scene[part].conveyor->velocity, {0, 0, -25});
  EXPECT_EQ(scene.evidence(part, "conveyor"), "tag Conveyor");
  EXPECT_EQ(scene.evidence(guess, "conveyor"), "guessed: tag Conveyor");
}

TEST(Conveyor, KitTextStatesTheWorldAxis) {
  Scene scene;
  const auto part = scene.part("A");
  scene.set(part, "CFrame", CFrame{{}, kTurnedLeft});
  scene.value("StringValue", "Conveyor", std::string("-8"), part);
  scene.level();
  ASSERT_TRUE(scene[part].conveyor);
  expectNear(scene[part].conveyor->velocity, {0, 0, -8});
}

TEST(Conveyor, SavedVelocityCountsOnAnchoredPartsAlongAnAxis) {
  Scene scene;
  const auto belt = scene.part("Belt"), noise = scene.part("Noise"),
             residue = scene.part("Residue"), dynamic = scene.part("Loose");
  scene.set(belt, "Velocity", Vec3{8, 0, 0});
  scene.set(noise, "Velocity", Vec3{1e-5f, 0, 0});
  scene.set(residue, "Velocity", Vec3{-13.4f, 13.7f, 1.6f});
  scene.set(dynamic, "Velocity", Vec3{8, 0, 0});
  scene.set(dynamic, "Anchored", false);
  const auto& level = scene.level();
  ASSERT_TRUE(scene[belt].conveyor);
  expectNear(scene[belt].conveyor->velocity, {8, 0, 0});
  EXPECT_FALSE(scene[noise].conveyor);
  EXPECT_FALSE(scene[residue].conveyor);
  EXPECT_FALSE(scene[dynamic].conveyor);
  EXPECT_EQ(level.ignored.at("saved velocity along no axis of the part or the world").count, 1u);
}

TEST(JumpPad, TrampolineThrowsUpward) {
  Scene scene;
  const auto part = scene.part("Trampoline");
  const auto configuration = scene.add("Configuration", "Configuration", part);
  scene.value("IntValue", "BounceSpeed", int64_t{100}, configuration);
  scene.script(
      "local trampoline = script.Parent\n"
      "trampoline.Velocity = Vector3.new(0, trampoline.Configuration.BounceSpeed.Value, 0)",
      part);
  scene.level();
  ASSERT_TRUE(scene[part].jumpPad);
  EXPECT_FALSE(scene[part].conveyor);
  expectNear(scene[part].jumpPad->velocity, {0, 100, 0});
}

TEST(JumpPad, CharacterVelocityKeepsTheScriptsComponents) {
  Scene scene;
  const auto keeps = scene.part("A"), sets = scene.part("B", {20, 0, 0}),
             body = scene.part("C", {40, 0, 0});
  scene.script(R"(script.Parent.Touched:Connect(function(hit)
  local root = hit.Parent:FindFirstChild("HumanoidRootPart")
  if root then
    root.AssemblyLinearVelocity = Vector3.new(root.AssemblyLinearVelocity.X, 115, root.AssemblyLinearVelocity.Z)
  end
end))",
               keeps);
  scene.script(
      "script.Parent.Touched:Connect(function(hit)\n"
      " hit.Parent.HumanoidRootPart.Velocity = Vector3.new(0, 90, -20)\nend)",
      sets);
  scene.script(R"(script.Parent.Touched:Connect(function(hit)
  local push = Instance.new("BodyVelocity")
  push.Velocity = Vector3.new(0, 70, 0)
  push.MaxForce = Vector3.new(0, math.huge, 0)
  push.Parent = hit.Parent.HumanoidRootPart
  game.Debris:AddItem(push, 0.2)
end))",
               body);
  scene.level();
  ASSERT_TRUE(scene[keeps].jumpPad && scene[sets].jumpPad && scene[body].jumpPad);
  expectNear(scene[keeps].jumpPad->velocity, {0, 115, 0});
  EXPECT_TRUE(scene[keeps].jumpPad->keepSideways);
  expectNear(scene[sets].jumpPad->velocity, {0, 90, -20});
  EXPECT_FALSE(scene[sets].jumpPad->keepSideways);
  expectNear(scene[body].jumpPad->velocity, {0, 103.5f, 0}, 2);  // 70 studs/s for 0.2 s
}

TEST(JumpPad, TagThrowsAlongThePadsUpAxis) {
  Scene scene;
  const auto pad = scene.part("Pad");
  scene.set(pad, "CFrame", CFrame{{}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});
  scene.tag(pad, "BouncePad");
  scene.attribute(pad, "BounceImpulse", 300.0);
  scene.level();
  expectNear(scene[pad].jumpPad->velocity, {-300, 0, 0});
}

}  // namespace
}  // namespace obby::test
