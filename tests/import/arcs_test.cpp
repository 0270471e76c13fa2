// A part that is attached to a turning part moves on an arc.
#include <cmath>
#include <string>
#include <utility>

#include "import/constraint_scene.h"
#include "import/motion_checks.h"

namespace obby::test {
namespace {

TEST(Arcs, APartWeldedToADoorSwingsWithIt) {
  const std::pair<const char*, float> cases[] = {{"Linear", 45}, {"Quad", 22.5f}};
  for (const auto& [easing, degrees] : cases) {
    Scene scene;
    const auto [hub, arm] = joined(scene, "WeldConstraint");
    scene.script(
        "task.wait(4) game:GetService('TweenService'):Create(workspace.Hub, TweenInfo.new(1, "
        "Enum.EasingStyle." +
            std::string(easing) +
            ", Enum.EasingDirection.In), {CFrame = CFrame.Angles(0, math.rad(90), 0)})"
            ":Play()",
        scene.scripts);
    scene.level();
    ASSERT_TRUE(scene[arm].motion) << easing;
    const float angle = degrees * 3.14159265f / 180;
    expectNear(poseAt(scene[arm], 3.9).position, {10, 0, 0});
    expectNear(poseAt(scene[arm], 4.5).position, {10 * std::cos(angle), 0, -10 * std::sin(angle)},
               0.6f);
    expectNear(poseAt(scene[arm], 5.2).position, {0, 0, -10}, 0.1f);
    ASSERT_TRUE(scene[hub].motion) << easing;
    expectNear(poseAt(scene[hub], 4.5).position, {0, 0, 0});
  }
}

TEST(Arcs, StraightMotionNeedsNoExtraKeys) {
  Scene scene;
  const auto model = scene.add("Model", "Lift", scene.workspace);
  const auto far = scene.part("Far", {30, 0, 0}, model);
  scene.part("Near", {0, 0, 0}, model);
  scene.script(
      "local m = script.Parent while true do m:PivotTo(m:GetPivot() + "
      "Vector3.new(0, 10, 0)) wait(1) m:PivotTo(m:GetPivot() - Vector3.new(0, 10, 0)) "
      "wait(1) end",
      model);
  scene.level();
  ASSERT_TRUE(scene[far].motion);
  EXPECT_LE(scene[far].motion->keys.size(), 6u);
}

}  // namespace
}  // namespace obby::test
