// Signals that variables, lists and arguments hold.
#include "import/tween_scene.h"

namespace obby::test {
namespace {

TEST(Signals, EachPartHasItsOwnTouches) {
  const char* const texts[] = {
      "local touched = p.Touched touched:Connect(kill)",
      "local touched = p.touched touched:connect(kill)",
      "local signals = {p.Touched} signals[1]:Connect(kill)",
      "local signals = {hit = p.Touched} signals.hit:Connect(kill)",
      "for _, signal in {p.Touched} do signal:Connect(kill) end",
      "local function on(signal, f) signal:Connect(f) end on(p.Touched, kill)"};
  for (const char* text : texts) {
    ScriptedPart scene("local function kill(h) h.Parent.Humanoid.Health = 0 end\n" +
                       std::string(text));
    EXPECT_TRUE(scene[scene.self].kill) << text;
    EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
  }
}

// GetTagged finds the parts that already have the tag.
TEST(Signals, AddedSignalsDoNotFireForEarlierTags) {
  for (const bool asked : {false, true}) {
    Scene scene;
    const auto part = scene.part("Part");
    scene.tag(part, "Ouchie");
    scene.script(
        "local tags = game:GetService('CollectionService')\n"
        "local function arm(part) part.Touched:Connect(function(hit)\n"
        "hit.Parent.Humanoid.Health = 0 end) end\n" +
            std::string(asked ? "for _, part in tags:GetTagged('Ouchie') do arm(part) end\n" : "") +
            "tags:GetInstanceAddedSignal('Ouchie'):Connect(arm)",
        scene.scripts);
    scene.level();
    EXPECT_EQ(scene[part].kill.has_value(), asked);
  }
}

// The service may or may not be in the file.
TEST(Signals, FrameSignalsMoveAndWait) {
  const char* const texts[] = {
      "local beat = run.Heartbeat beat:Connect(function(dt) turn() end)",
      "local Stepped = run.Stepped Stepped:Connect(function(now, dt) turn() end)",
      "local beat = run.Heartbeat while true do turn() beat:Wait() end"};
  for (const char* text : texts) {
    for (const bool there : {false, true}) {
      Scene scene;
      const auto part = scene.part("Mover");
      if (there) scene.add("RunService", "Run Service", kNoInstance);
      scene.script(
          "local p, run = workspace.Mover, game:GetService('RunService')\n"
          "local function turn() p.CFrame = p.CFrame * CFrame.Angles(0, 0.1, 0) end\n" +
              std::string(text),
          scene.scripts);
      scene.level();
      ASSERT_TRUE(scene[part].motion) << text;
      ASSERT_TRUE(scene[part].motion->spin) << text;
      EXPECT_NEAR(scene[part].motion->spin->speed, 6, 0.1) << text;
      EXPECT_TRUE(scene.level().unmodelled.empty()) << text;
    }
  }
}

TEST(Signals, StoredConnectionsCanBeDisconnected) {
  ScriptedPart scene(
      "local touched = p.Touched local c c = touched:Connect(function(hit)\n"
      "c:Disconnect() p.CanCollide = false wait(3) p.CanCollide = true end)");
  EXPECT_TRUE(scene[scene.self].vanish);
  EXPECT_EQ(scene.unmodelled("touch whose effect wears off"), 1u);
}

}  // namespace
}  // namespace obby::test
