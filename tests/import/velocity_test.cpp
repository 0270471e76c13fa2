// Velocities that scripts give to parts at run time.
#include "import/motion_checks.h"

namespace obby::test {
namespace {

const char* const kComputes = "conveyor that a script computes";
const char* const kChanges = "conveyor that a script changes";

TEST(Velocity, IsIgnoredIfUnknownOnTaggedOrDynamicParts) {
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
