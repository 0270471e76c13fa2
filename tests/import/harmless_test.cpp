// Parts that a designer marks as harmless.
#include "import/scene.h"

namespace obby::test {
namespace {

const char* const kTouch =
    "script.Parent.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end)";

TEST(Harmless, NothingMakesATaggedPartAKillPart) {
  for (const char* tag : {"Harmless", "harmless", "NoKill", "NoDamage"}) {
    Scene scene;
    const auto scripted = scene.part("A"), named = scene.part("Lava"), tagged = scene.part("C");
    const auto kit = scene.part("D"), plain = scene.part("E");
    for (const InstanceId part : {scripted, named, tagged, kit}) scene.tag(part, tag);
    scene.script(kTouch, scripted);
    scene.script(kTouch, plain);
    scene.tag(tagged, "KillBrick");
    scene.value("BoolValue", "kills", true, kit);
    const auto& level = scene.level();
    for (const InstanceId part : {scripted, named, tagged, kit}) {
      EXPECT_FALSE(scene[part].kill) << tag << part;
      EXPECT_EQ(scene.evidence(part, "harmless"), "tag " + std::string(tag)) << part;
    }
    EXPECT_TRUE(scene[plain].kill) << tag;
    EXPECT_TRUE(level.unmodelled.empty()) << tag;
    EXPECT_EQ(level.ignored.count("tag " + std::string(tag)), 0u);
  }
}

TEST(Harmless, AllPartsOfATaggedModelAreHarmless) {
  Scene scene;
  const auto model = scene.add("Model", "Lava", scene.workspace);
  const auto inside = scene.part("Kill", {}, model), outside = scene.part("Kill", {9, 0, 0});
  scene.tag(model, "Harmless");
  scene.level();
  EXPECT_FALSE(scene[inside].kill);
  EXPECT_TRUE(scene[outside].kill);
}

TEST(Harmless, TaggedPartsKeepTheirOtherRoles) {
  Scene scene;
  const auto part = scene.part("Checkpoint1"), pad = scene.part("Pad", {9, 0, 0});
  scene.tag(part, "Checkpoint");
  scene.tag(part, "Harmless");
  scene.tag(pad, "Harmless");
  scene.script(
      "local p = script.Parent p.Touched:Connect(function(hit) hit.Parent.Humanoid:TakeDamage(9)\n"
      "p.CanCollide = false wait(2) p.CanCollide = true end)",
      pad);
  scene.level();
  EXPECT_EQ(scene.evidence(part, "checkpoint"), "tag Checkpoint");
  EXPECT_FALSE(scene[pad].kill);
  EXPECT_TRUE(scene[pad].vanish);
}

TEST(Harmless, ComputedHarmEqualsTheFirstHit) {
  for (const bool harmless : {false, true}) {
    Scene scene;
    const auto part = scene.part("Part");
    if (harmless) scene.tag(part, "Harmless");
    scene.script(
        "script.Parent.Touched:Connect(function(hit) local h = hit.Parent.Humanoid\n"
        "h.Health = h.Health / 2 end)",
        part);
    scene.level();
    EXPECT_EQ(scene[part].kill.has_value(), !harmless);
    if (harmless) continue;
    EXPECT_FLOAT_EQ(scene[part].kill->damage, 50);
  }
}

}  // namespace
}  // namespace obby::test
