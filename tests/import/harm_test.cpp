// Harm that one touch begins, harm while a player stays, and the time between two hits.
#include "import/scene.h"

namespace obby::test {
namespace {

// Returns the kill of a part whose script runs `act` on each touch by a player. `human` is the
// player's humanoid. Each part has its own script.
const importer::Kill* killBy(Scene& scene, const std::string& act) {
  const auto part = scene.part("Part", {20, 0, 0});
  scene.script(
      "local busy, inside = false, 0\nscript.Parent.Touched:Connect(function(hit)\n"
      " local human = hit.Parent:FindFirstChild('Humanoid')\n if not human then return end\n" +
          act,
      part);
  scene.level();
  return scene[part].kill ? &*scene[part].kill : nullptr;
}

constexpr const char* kLasting = "harm that goes on after a touch";

TEST(Harm, AFastLoopDealsItsTotalDamage) {
  Scene scene;
  const auto* const kill = killBy(scene,
                                  " if busy then return end\n busy = true\n"
                                  " for i = 1, 6 do human:TakeDamage(25) task.wait(0.1) end\n"
                                  " busy = false\nend)");
  ASSERT_TRUE(kill);
  EXPECT_FLOAT_EQ(kill->damage, 100);
  EXPECT_EQ(scene.unmodelled(kLasting), 1u);
}

TEST(Harm, NonLethalLoopsDealTheirTotalOverTime) {
  Scene scene;
  const auto* const kill = killBy(scene,
                                  " if busy then return end\n busy = true\n"
                                  " for i = 1, 4 do human:TakeDamage(10) task.wait(0.2) end\n"
                                  " busy = false\nend)");
  ASSERT_TRUE(kill);
  EXPECT_FLOAT_EQ(kill->damage, 40);
  EXPECT_NEAR(kill->cooldown, 0.6, 0.1);
}

TEST(Harm, LoopsStartedByEachTouchHaveNoCooldown) {
  Scene scene;
  const auto* const kill =
      killBy(scene, " for i = 1, 4 do human:TakeDamage(5) task.wait(0.5) end\nend)");
  ASSERT_TRUE(kill);
  EXPECT_GE(kill->damage, 20);
  EXPECT_FLOAT_EQ(kill->cooldown, 0);
}

TEST(Harm, ADebounceIsTheCooldown) {
  Scene scene;
  const auto* const kill = killBy(scene,
                                  " if busy then return end\n busy = true\n human:TakeDamage(20)\n"
                                  " task.wait(0.5) busy = false\nend)");
  ASSERT_TRUE(kill);
  EXPECT_FLOAT_EQ(kill->damage, 20);
  EXPECT_NEAR(kill->cooldown, 0.5, 0.05);
  EXPECT_EQ(scene.unmodelled(kLasting), 0u);
}

TEST(Harm, AnArmedTrapDealsItsTotalDamage) {
  Scene scene;
  const auto lever = scene.part("Lever", {-20, 0, 0});
  scene.script(
      "script.Parent.Touched:Connect(function() workspace.Lever:SetAttribute('On', true) end)",
      lever);
  const auto* const kill =
      killBy(scene,
             " if busy or not workspace.Lever:GetAttribute('On') then return end\n"
             " busy = true\n"
             " for i = 1, 6 do human:TakeDamage(25) task.wait(0.1) end\n"
             " busy = false\nend)");
  ASSERT_TRUE(kill);
  EXPECT_FLOAT_EQ(kill->damage, 100);
}

// Repeated touches would end the presence that this script counts.
TEST(Harm, CountedPresenceHurtsWhileThePlayerStays) {
  Scene scene;
  const auto* const kill = killBy(scene,
                                  " inside = inside + 1\nend)\n"
                                  "script.Parent.TouchEnded:Connect(function(hit)\n"
                                  " if hit.Parent:FindFirstChild('Humanoid') then\n"
                                  "  inside = inside - 1\n end\nend)\n"
                                  "while wait(0.3) do\n"
                                  " local body = game.Players.Player.Character\n"
                                  " if inside > 0 then body.Humanoid:TakeDamage(20) end\nend");
  ASSERT_TRUE(kill);
  EXPECT_FLOAT_EQ(kill->damage, 20);
  EXPECT_NEAR(kill->cooldown, 0.3, 0.05);
  EXPECT_EQ(scene.unmodelled(kLasting), 0u);
}

constexpr const char* kShielded = "harm that a force field stops";

TEST(Harm, HarmThatAForceFieldBlocksIsReported) {
  const std::string hurt = " human:TakeDamage(100)\nend)", kill = " human.Health = 0\nend)";
  Scene without;
  ASSERT_TRUE(killBy(without, hurt));
  EXPECT_EQ(without.unmodelled(kShielded), 0u);
  const auto atSpawn = [](const std::string& act, int64_t seconds) {
    Scene scene;
    const auto spawn = scene.part("Spawn", {0, -4, 0}, scene.workspace, "SpawnLocation");
    scene.set(spawn, "Duration", seconds);
    EXPECT_TRUE(killBy(scene, act));
    return scene.unmodelled(kShielded);
  };
  EXPECT_EQ(atSpawn(hurt, 10), 1u);
  EXPECT_EQ(atSpawn(hurt, 0), 0u);
  EXPECT_EQ(atSpawn(kill, 10), 0u);
}

TEST(Harm, AScriptedForceFieldHidesNoHarm) {
  const std::string give = " local field = Instance.new('ForceField') field.Parent = body\nend)";
  const std::string onBody =
      "game.Players.PlayerAdded:Connect(function(player)\n"
      " player.CharacterAdded:Wait() local body = player.Character\n";
  const std::string onPad =
      "workspace.Pad.Touched:Connect(function(hit)\n local body = hit.Parent\n"
      " if body:FindFirstChild('ForceField') then return end\n";
  for (const std::string& text : {onBody + give, onPad + give}) {
    Scene scene;
    scene.part("Pad", {-20, 0, 0});
    scene.script(text, scene.scripts);
    const auto* const kill = killBy(scene, " human:TakeDamage(100)\nend)");
    ASSERT_TRUE(kill) << text;
    EXPECT_FLOAT_EQ(kill->damage, 100) << text;
    EXPECT_EQ(scene.unmodelled(kShielded), 1u) << text;
  }
}

}  // namespace
}  // namespace obby::test
