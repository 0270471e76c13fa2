// With more parts than probes, one probe represents parts with the same listeners.
#include <gtest/gtest.h>

#include "engine/observe.h"
#include "engine/place.h"

namespace obby::test {
namespace {

engine::Report observeWith(size_t maxProbes, Place& place) {
  engine::Plan plan;
  plan.seconds = 5;
  plan.maxProbes = maxProbes;
  return engine::observe(place.document, plan);
}

const std::string kDeadly =
    "script.Parent.Touched:Connect(function(hit)\n"
    "  hit.Parent.Humanoid.Health = 0\nend)";
const std::string kHurting =
    "script.Parent.Touched:Connect(function(hit)\n"
    "  hit.Parent.Humanoid:TakeDamage(5)\nend)";

TEST(SameListeners, CopiesOfAScriptAreAlikeAndOthersDiffer) {
  Place place;
  std::vector<InstanceId> parts;
  for (int i = 0; i < 6; ++i) {
    parts.push_back(place.part("Part", {20.0f + 10 * float(i), 0, 0}));
    place.script(i == 4 ? kHurting : kDeadly, parts.back());
  }
  const engine::Report report = observeWith(3, place);
  EXPECT_EQ(report.failure, "");
  ASSERT_EQ(report.probes.size(), 3u);  // two with the first script, one with the second
  EXPECT_EQ(report.probes[0].target, parts[0]);
  EXPECT_EQ(report.probes[1].target, parts[1]);
  EXPECT_EQ(report.probes[2].target, parts[4]);
  ASSERT_EQ(report.sameListeners.size(), 3u);
  const size_t left[] = {2, 3, 5};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(report.sameListeners[i].target, parts[left[i]]);
    EXPECT_EQ(report.sameListeners[i].probe, 0u);
  }
}

TEST(SameListeners, OneFunctionForManyPartsMakesThemAlike) {
  Place place;
  for (int i = 0; i < 5; ++i) place.part("Part", {20.0f + 10 * float(i), 0, 0});
  place.script(
      "for _, part in workspace:GetChildren() do\n  if part.Name == 'Part' then\n"
      "    part.Touched:Connect(function(hit) hit.Parent.Humanoid.Health = 0 end)\n"
      "  end\nend",
      place.scripts);
  const engine::Report report = observeWith(2, place);
  EXPECT_EQ(report.probes.size(), 2u);
  EXPECT_EQ(report.sameListeners.size(), 3u);
}

TEST(SameListeners, PartsWithoutAProbedPartnerAreNamed) {
  Place place;
  for (int i = 0; i < 3; ++i) {
    const InstanceId part = place.part("Part", {20.0f + 10 * float(i), 0, 0});
    place.script("local number = " + std::to_string(i) + "\n" + kDeadly, part);
  }
  EXPECT_EQ(observeWith(2, place).failure,
            "the place has too many parts to test the touch of each");
}

}  // namespace
}  // namespace obby::test
