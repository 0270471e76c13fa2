// Ladders built of thin parts.
#include <chrono>

#include "import/scene.h"

namespace obby::test {
namespace {

InstanceId rung(Scene& scene, Vec3 at, Vec3 size = {4, 0.4f, 0.4f}) {
  const InstanceId id = scene.part("Rung", at);
  scene.set(id, "Size", size);
  return id;
}

TEST(Ladders, StackedThinPartsAreRungs) {
  Scene scene;
  std::vector<InstanceId> rungs;
  for (int i = 0; i < 4; ++i) rungs.push_back(rung(scene, {0, 1 + 1.5f * float(i), 0}));
  scene.level();
  for (const InstanceId id : rungs) {
    EXPECT_TRUE(scene[id].climbable);
    EXPECT_EQ(scene.evidence(id, "ladder"), "guessed: 4 thin parts one above the other");
  }
}

TEST(Ladders, BarsAreRungsUpToTwoStudsThick) {
  for (const float thick : {1.9f, 2.1f}) {
    Scene scene;
    std::vector<InstanceId> bars;
    for (int i = 0; i < 4; ++i) bars.push_back(rung(scene, {0, 3.0f * float(i), 0}, {4, thick, 1}));
    scene.level();
    for (const InstanceId id : bars) EXPECT_EQ(scene[id].climbable, thick < 2) << thick;
  }
}

TEST(Ladders, AVeryTallLadderTakesNoLonger) {
  constexpr int kRungs = 4000;
  Scene scene;
  std::vector<InstanceId> rungs;
  for (int i = 0; i < kRungs; ++i) rungs.push_back(rung(scene, {0, float(i), 0}));
  const auto start = std::chrono::steady_clock::now();
  scene.level();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  for (const InstanceId id : {rungs.front(), rungs[kRungs / 2], rungs.back()})
    EXPECT_EQ(scene.evidence(id, "ladder"), "guessed: 4000 thin parts one above the other");
}

TEST(Ladders, StairsPlatformsAndPairsAreNotLadders) {
  Scene scene;
  std::vector<InstanceId> others;
  for (int i = 0; i < 6; ++i) {
    others.push_back(rung(scene, {0, float(i), 20 + 2 * float(i)}, {6, 1, 2}));  // stairs
    others.push_back(rung(scene, {40, 3 * float(i), 0}, {12, 1, 12}));           // floors
    others.push_back(rung(scene, {60, float(i), 0}, {4, 1, 1}));  // a wall, since there are no gaps
    others.push_back(rung(scene, {80, 6 * float(i), 0}));         // too far apart
  }
  others.push_back(rung(scene, {100, 1, 0}));
  others.push_back(rung(scene, {100, 3, 0}));
  scene.level();
  for (const InstanceId id : others) EXPECT_FALSE(scene[id].climbable) << id;
}

}  // namespace
}  // namespace obby::test
