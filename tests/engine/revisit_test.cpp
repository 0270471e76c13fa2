// Effects of parts that change after other parts are touched, and the causes of these changes.
#include <gtest/gtest.h>

#include "engine/observe.h"
#include "engine/place.h"

namespace obby::test {
namespace {

using engine::Cause;

// A place with the parts Lever and Trap. The script knows them as `lever` and `trap`.
struct LeverPlace : Place {
  LeverPlace() {
    lever = part("Lever", {20, 0, 0});
    trap = part("Trap", {40, 0, 0});
    part("Door", {0, 9, 60});
  }
  engine::Report observe(const std::string& text) {
    script("local lever, trap = workspace.Lever, workspace.Trap\n" + text, scripts);
    engine::Plan plan;
    plan.seconds = 10;
    return engine::observe(document, plan);
  }
  InstanceId lever, trap;
};

const std::string kKills = "hit.Parent.Humanoid.Health = 0 ";

TEST(Revisit, FindsLeversThatArmATrap) {
  const std::string levers[] = {
      "local on = false lever.Touched:Connect(function() on = true end)\n"
      "trap.Touched:Connect(function(hit) if on then " +
          kKills + "end end)",
      "lever.Touched:Connect(function() trap:SetAttribute('On', true) end)\n"
      "trap.Touched:Connect(function(hit) if trap:GetAttribute('On') then " +
          kKills + "end end)",
      "lever.Touched:Once(function()\n"
      "trap.Touched:Connect(function(hit) " +
          kKills +
          "end) end)\n"
          "trap.Touched:Connect(function() end)"};
  for (const std::string& text : levers) {
    LeverPlace place;
    const engine::Report report = place.observe(text);
    ASSERT_EQ(report.revisits.size(), 1u) << text;
    EXPECT_EQ(report.revisits[0].probe.target, place.trap) << text;
    EXPECT_EQ(report.revisits[0].cause, Cause::lever) << text;
    EXPECT_EQ(report.revisits[0].lever, place.lever) << text;
    EXPECT_FALSE(report.revisits[0].probe.seen.harms.empty()) << text;
  }
}

TEST(Revisit, TwoLeversTogetherCountAsSeveral) {
  LeverPlace place;
  place.part("Other", {60, 0, 0});
  const engine::Report report = place.observe(
      "local a, b = false, false lever.Touched:Connect(function() a = true end)\n"
      "workspace.Other.Touched:Connect(function() b = true end)\n"
      "trap.Touched:Connect(function(hit) if a and b then " +
      kKills + "end end)");
  ASSERT_EQ(report.revisits.size(), 1u);
  EXPECT_EQ(report.revisits[0].cause, Cause::several);
}

TEST(Revisit, SecondTouchesAreASeparateCause) {
  const std::string texts[] = {
      "local n = 0 trap.Touched:Connect(function(hit) if n > 20 then return end n = n + 1\n"
      "task.delay(2, function() n = 50 end) trap.CanCollide = false task.wait(1)\n"
      "trap.CanCollide = true end)",
      "trap.Touched:Once(function() trap.CanCollide = false task.wait(1)\n"
      "trap.CanCollide = true end)",
      "local dead = false trap.Touched:Connect(function(hit) if dead then return end dead = true " +
          kKills + "end)"};
  for (const std::string& text : texts) {
    LeverPlace place;
    const engine::Report report = place.observe(text);
    ASSERT_EQ(report.revisits.size(), 1u) << text;
    EXPECT_EQ(report.revisits[0].cause, Cause::again) << text;
  }
}

TEST(Revisit, FindsIntermittentHarmByWaiting) {
  LeverPlace place;
  const engine::Report report =
      place.observe("local on = false trap.Touched:Connect(function(hit) if on then " + kKills +
                    "end end)\n"
                    "while true do on = false task.wait(3.3) on = true task.wait(1) end");
  ASSERT_EQ(report.revisits.size(), 1u);
  EXPECT_EQ(report.revisits[0].cause, Cause::time);
}

TEST(Revisit, FindsLeversThatWorkForSecondsOnly) {
  LeverPlace place;
  const engine::Report report = place.observe(
      "local lit = {} for _, p in {lever, trap} do p.Touched:Connect(function()\n"
      "if lit[p] then return end lit[p] = true\n"
      "if lit[lever] and lit[trap] then workspace.Door:Destroy() end\n"
      "task.wait(3) lit[p] = false end) end");
  ASSERT_EQ(report.revisits.size(), 1u);
  EXPECT_EQ(report.revisits[0].cause, Cause::lever);
}

TEST(Revisit, RepeatableEffectsAreNotDifferences) {
  const std::string texts[] = {
      "trap.Touched:Connect(function(hit) " + kKills + "end)",
      "local busy = false trap.Touched:Connect(function() if busy then return end busy = true\n"
      "trap.CanCollide = false task.wait(3) trap.CanCollide = true busy = false end)",
      "lever.Touched:Connect(function() trap:Destroy() end)",
      "lever.Touched:Connect(function(hit) hit.Parent.Humanoid.WalkSpeed = 32 end)\n"
      "while true do trap.CanCollide = not trap.CanCollide task.wait(1) end"};
  for (const std::string& text : texts) {
    LeverPlace place;
    EXPECT_TRUE(place.observe(text).revisits.empty()) << text;
  }
}

}  // namespace
}  // namespace obby::test
