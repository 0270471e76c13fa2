// Velocities that scripts give to parts, and that their text does not tell.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kComputes = "conveyor that a script computes";
const char* const kChanges = "conveyor that a script changes";

TEST(Velocity, ThatTheTextDoesNotTellIsNamedWithItsCure) {
  const char* const texts[] = {
      "p.AssemblyLinearVelocity = p.CFrame.LookVector * _G.speed",
      "p.Velocity = Vector3.new(_G.speed, 0, 0)",
      "while true do p.Velocity = _G.velocity() wait(1) end",
      "game:GetService('RunService').Heartbeat:Connect(function() p.RotVelocity = _G.turn end)",
      "if _G.on then p.Velocity = _G.velocity end p.Velocity = _G.velocity"};
  for (const char* text : texts) {
    ScriptedPart scene(text);
    EXPECT_FALSE(scene[scene.self].conveyor) << text;
    ASSERT_EQ(scene.unmodelled(kComputes), 1u) << text;
    EXPECT_EQ(scene.unmodelled(kChanges), 0u) << text;
    const auto& entry = scene.level().unmodelled.at(kComputes);
    EXPECT_EQ(entry.example, "Workspace/Pad") << text;
    EXPECT_NE(entry.note.find("script Script line 2"), std::string::npos) << entry.note;
    EXPECT_NE(entry.note.find("tag Conveyor with a Speed"), std::string::npos) << entry.note;
  }
}

TEST(Velocity, ThatThrowsUpwardIsOfAJumpPad) {
  ScriptedPart scene("p.Velocity = Vector3.new(0, _G.power, 0)");
  EXPECT_EQ(scene.unmodelled("jump pad that a script computes"), 1u);
  EXPECT_EQ(scene.unmodelled(kComputes), 0u);
}

TEST(Velocity, ThatIsKnownAtOtherTimesGoesOn) {
  const char* const texts[] = {"p.Velocity = Vector3.new(9, 0, 0) wait(5) p.Velocity = _G.speed",
                               "p.Velocity = _G.speed wait(5) p.Velocity = Vector3.new(9, 0, 0)"};
  for (const char* text : texts) {
    ScriptedPart scene(text);
    ASSERT_TRUE(scene[scene.self].conveyor) << text;
    EXPECT_EQ(scene[scene.self].conveyor->velocity, (Vec3{9, 0, 0})) << text;
    EXPECT_EQ(scene.unmodelled(kChanges), 1u) << text;
    EXPECT_EQ(scene.unmodelled(kComputes), 0u) << text;
  }
}

TEST(Velocity, OfATagOrOfALoosePartIsNoneOfTheScripts) {
  Scene scene;
  const auto belt = scene.part("Belt"), ball = scene.part("Ball", {0, 9, 0});
  scene.tag(belt, "Conveyor");
  scene.attribute(belt, "Speed", 8.0);
  scene.set(ball, "Anchored", false);
  for (const InstanceId part : {belt, ball})
    scene.script("script.Parent.Velocity = _G.velocity", part);
  scene.level();
  EXPECT_TRUE(scene[belt].conveyor);
  EXPECT_EQ(scene.unmodelled(kComputes), 0u);
  EXPECT_EQ(scene.unmodelled(kChanges), 0u);
}

}  // namespace
}  // namespace obby::test
