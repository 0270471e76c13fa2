// Values that scripts read from properties driven by a tween.
#include <string>

#include "import/tween_scene.h"

namespace obby::test {
namespace {

// The part comes to rest at the pose that its script read during the tween. A part moves 1/6 stud
// per frame.
TEST(TweenReading, ATweenedPropertyCanBeReadMidway) {
  struct Case {
    const char* text;
    Vec3 end;
  };
  const char* const up = "\ntween(even(1), {Position = p.Position + Vector3.new(0, 8, 0)}):Play()";
  const Case cases[] = {
      {"tween(even(4), to(40)):Play() task.wait(1)", {0, 8, 10}},
      {"local t = tween(even(4), to(40)) t:Play() task.wait(1) t:Cancel()", {0, 8, 10}},
      {"tween(swing(1.5), to(15)):Play() task.wait(2)", {0, 8, 10}},
      {"tween(even(4), to(40)):Play() task.wait(1) p.CFrame = p:GetPivot()", {0, 8, 10}},
      {"local t = tween(TweenInfo.new(1, line, way, 0, true), to(20)) t:Play()\n"
       "t.Completed:Wait()",
       {0, 8, 0}},
      {"local t = tween(even(2), to(20)) t:Play() task.wait(1) t.Completed:Wait()", {0, 8, 20}},
      {"tween(even(2), to(20)):Play() repeat task.wait() until p.Position.Z > 19", {0, 8, 19}},
      {"tween(even(4), {Size = Vector3.new(4, 1, 44)}):Play() task.wait(1)\n"
       "p.Position = Vector3.new(0, p.Size.Z, 0)",
       {0, 22, 0}},
      {"tween(even(4), {Transparency = 1}):Play() task.wait(1)\n"
       "p.Position = Vector3.new(0, p.Transparency * 56, 0)",
       {0, 22, 0}}};
  for (const Case& now : cases) {
    const Overlap cut({now.text + std::string(up)});
    expectNear(cut.at(9), now.end, 0.35f);
  }
}

// A part that follows a swinging part frame by frame gets the same motion.
TEST(TweenReading, APartCanFollowATweenFrameByFrame) {
  Scene scene;
  scene.part("Mover");
  const auto rider = scene.part("Rider", {0, 5, 0});
  scene.script(kBefore +
                   "tween(swing(2), to(20)):Play()\n"
                   "game:GetService('RunService').Heartbeat:Connect(function()\n"
                   "workspace.Rider.Position = p.Position + Vector3.new(0, 5, 0) end)",
               scene.scripts);
  scene.level();
  for (const auto& [time, z] : {std::pair(1, 10), {2, 20}, {3, 10}, {40, 0}})
    expectNear(poseAt(scene[rider], time).position, {0, 5, float(z)}, 0.2f);
}

}  // namespace
}  // namespace obby::test
