// The output of --explain, for designers.
#include <gmock/gmock.h>

#include "import/importer.h"
#include "import/records/explain.h"
#include "import/scene.h"

namespace obby::test {
namespace {

using ::testing::HasSubstr;

std::string explained(Scene& scene) {
  return importer::importDocument(scene.document, {"", true, true}).explanation;
}

TEST(Explain, ATableOfOnePartCountsInTheSingularAndNamesItsUnits) {
  Scene scene;
  scene.part("Start", {}, scene.workspace, "SpawnLocation");
  const std::string text = explained(scene);
  EXPECT_THAT(text, HasSubstr("1 part read, 1 kept, 0 left out; 1 spawn\n"));
  EXPECT_THAT(text, HasSubstr("gravity 196.2 studs/s^2, walk speed 16 studs/s, jump speed 53 "
                              "studs/s, fall height -500 studs\n"));
}

TEST(Explain, TurnsAreInDegreesAndDamageIsTaken) {
  Scene scene;
  const auto turning = scene.part("Turning");
  scene.tag(turning, "Spinner");
  const auto hot = scene.part("Hot", {9, 0, 0});
  scene.tag(hot, "Damage");
  const std::string text = explained(scene);
  EXPECT_THAT(text, HasSubstr("guessed: turns 90 degrees/s; tag Spinner"));
  EXPECT_THAT(text, HasSubstr("takes 10 health; tag Damage"));
}

TEST(Explain, UnmodelledFeaturesHaveAnExample) {
  Scene scene;
  scene.part("Chair", {}, scene.workspace, "VehicleSeat");
  const std::string text = explained(scene);
  EXPECT_THAT(text, HasSubstr("     1  vehicle seat: treated as a plain part; the simulated player "
                              "does not sit in it\n        for example Workspace/Chair\n"));
}

TEST(Explain, APartOnAScreenIsNamedAfterItsViewportFrame) {
  Scene scene;
  const auto frame = scene.add("ViewportFrame", "Preview", scene.workspace);
  scene.part("Shown", {}, frame);
  EXPECT_THAT(explained(scene), HasSubstr("part of a ViewportFrame: not level geometry"));
}

}  // namespace
}  // namespace obby::test
