// A second round of probes finds parts, listeners and effects that appear later.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/observe.h"
#include "engine/place.h"

namespace obby::test {
namespace {

using engine::Cause;

const std::string kKillsHit =
    "(function(hit) if hit.Parent:FindFirstChild('Humanoid') then hit.Parent.Humanoid.Health = 0 "
    "end end)";

struct LatePlace : Place {
  LatePlace() { pad = part("Pad", {40, 0, 0}); }
  engine::Report observe(const std::string& text) {
    script("local pad = workspace.Pad\n" + text, scripts);
    return engine::observe(document, {});
  }
  InstanceId pad;
};

TEST(LaterRound, IsSkippedIfNothingIsPending) {
  LatePlace place;
  const engine::Report report = place.observe("pad.Touched:Connect" + kKillsHit);
  EXPECT_EQ(report.lookedAgainAt, 0);
  EXPECT_EQ(report.probes.size(), 1u);
}

TEST(LaterRound, ProbesListenersThatConnectLater) {
  LatePlace place;
  const engine::Report report = place.observe("wait(5) pad.Touched:Connect" + kKillsHit);
  ASSERT_EQ(report.probes.size(), 1u);
  EXPECT_EQ(report.probes[0].target, place.pad);
  EXPECT_GT(report.probes[0].at, 5);
  EXPECT_FALSE(report.probes[0].seen.harms.empty());
  EXPECT_TRUE(report.revisits.empty());
}

TEST(LaterRound, ATimedWaitCausesARevisit) {
  LatePlace place;
  const engine::Report report = place.observe(
      "local open = false\n"
      "pad.Touched:Connect(function() if open then pad.CanCollide = false end end)\n"
      "for i = 1, 20 do wait(1) end open = true");
  ASSERT_EQ(report.revisits.size(), 1u);
  EXPECT_EQ(report.revisits[0].cause, Cause::time);
  EXPECT_EQ(report.revisits[0].probe.target, place.pad);
}

TEST(LaterRound, SecondListenersOfAPartAreProbed) {
  LatePlace place;
  const engine::Report report =
      place.observe("pad.Touched:Connect(function() end) wait(5) pad.Touched:Connect" + kKillsHit);
  ASSERT_EQ(report.revisits.size(), 1u);
  EXPECT_FALSE(report.revisits[0].probe.seen.harms.empty());
}

TEST(LaterRound, ReportsPartsThatAreMadeLaterAndStay) {
  LatePlace place;
  const engine::Report report = place.observe(
      "wait(5) for i = 1, 2 do local p = Instance.new('Part') p.Name = 'P' .. i p.Parent = "
      "workspace end\n"
      "while true do wait(1) local p = Instance.new('Part', workspace) wait(1) p:Destroy() end");
  ASSERT_EQ(report.made.size(), 2u);
  for (const engine::MadePart& made : report.made) EXPECT_TRUE(made.later);
  EXPECT_EQ(report.made[0].name, "P1");
}

TEST(LaterRound, ProbesAllPartsOfOneListenerIfOneDiffers) {
  LatePlace place;
  for (int i = 0; i < 9; ++i) place.part("Lava", {60 + 8 * float(i), 0, 0});
  const engine::Report report = place.observe(
      "local on = false for _, p in workspace:GetChildren() do if p.Name == 'Lava' then\n"
      "p.Touched:Connect(function(hit) if on then hit.Parent.Humanoid.Health = 0 end end) end end\n"
      "for i = 1, 30 do wait(1) end on = true");
  EXPECT_EQ(report.revisits.size(), 9u);
}

}  // namespace
}  // namespace obby::test
