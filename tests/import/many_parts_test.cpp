// Tests places with more parts than the importer probes.
#include <gtest/gtest.h>

#include "import/scene.h"

namespace obby::test {
namespace {

constexpr int kMany = 650;

// Runs `text` for each part of a row. The parts are named by their numbers.
struct Row : Scene {
  explicit Row(const std::string& text) {
    const InstanceId folder = add("Folder", "Row", workspace);
    for (int i = 1; i <= kMany; ++i)
      parts.push_back(part(std::to_string(i), {20.0f * float(i), 0, 0}, folder));
    script("for _, part in workspace.Row:GetChildren() do\n" + text + "\nend", scripts);
    level();
  }
  const PartDraft& last() const { return (*this)[parts.back()]; }
  std::vector<InstanceId> parts;
};

TEST(ManyParts, UnprobedPartsHarmLikeProbedOnes) {
  const Row row("part.Touched:Connect(function(hit) hit.Parent.Humanoid:TakeDamage(20) end)");
  ASSERT_TRUE(row.last().kill);
  EXPECT_EQ(row.last().kill->damage, 20);
  EXPECT_TRUE(row.last().evidence.back().guessed);
}

TEST(ManyParts, UnprobedPartsVanishLikeProbedOnes) {
  const Row row(
      "part.Touched:Connect(function() part.CanCollide = false wait(2) part.CanCollide = true "
      "end)");
  ASSERT_TRUE(row.last().vanish);
  EXPECT_NEAR(row.last().vanish->away, 2, 0.1);
}

TEST(ManyParts, PartsWhoseListenersDoNothingAreHarmless) {
  const Row row("part.Touched:Connect(function() end)");
  EXPECT_EQ(row.evidence(row.parts.back(), "harmless").rfind("guessed: ", 0), 0u);
}

TEST(ManyParts, UnprobedCheckpointsFollowTheirNumbers) {
  const Row row(
      "part.Touched:Connect(function(hit)\n"
      " local player = game.Players:GetPlayerFromCharacter(hit.Parent)\n"
      " if player then player:SetAttribute('Stage', tonumber(part.Name)) end end)");
  ASSERT_TRUE(row.last().checkpoint || row.last().goal);
  ASSERT_TRUE(row[row.parts[400]].checkpoint);
  EXPECT_EQ(*row[row.parts[401]].checkpoint, *row[row.parts[400]].checkpoint + 1);
}

TEST(ManyParts, EffectsThatDependOnThePartsPositionAreReported) {
  const Row row(
      "part.Touched:Connect(function(hit)\n"
      " hit.Parent:PivotTo(part.CFrame + Vector3.new(0, 50, 0)) end)");
  EXPECT_FALSE(row.last().teleport);
  EXPECT_EQ(row.unmodelled("touch that was not tested"), kMany - 100u);
}

}  // namespace
}  // namespace obby::test
