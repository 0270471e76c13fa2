// A player fails more often on levels that are generated to be harder. The player is that of
// obby-solve --difficulty, who plays natural solutions inexactly.
#include <gtest/gtest.h>

#include <algorithm>

#include "gen/asked.h"

namespace obby::test {
namespace {

constexpr int kLevels = 16;
constexpr uint64_t kImproveSteps = 300'000;
constexpr uint32_t kTrials = 200;

// Returns the share of trials that pass the hardest step of a level's solution; -1 without one.
float hardestStep(const Made& made) {
  solve::SolverOptions options = limitedTo(5'000'000);
  options.preference = solve::findPreference("natural");
  options.improveSteps = kImproveSteps;
  options.difficultyTrials = kTrials;
  float hardest = -1;
  const auto write = [&](schema::Record::Reader record) -> Status {
    if (!record.isTrajectory()) return {};
    hardest = 1;
    for (const auto step : record.getTrajectory().getDifficulty().getSteps())
      hardest = std::min(hardest, step.getSuccess());
    return {};
  };
  ask(made, options, write);
  return hardest;
}

// Returns the mean over generated levels that are solved.
float meanHardestStep(const std::string& style, float difficulty) {
  const gen::Generator generator = generatorOf(recipeFor(style, difficulty));
  float sum = 0;
  int solved = 0;
  for (int i = 0; i < kLevels; ++i) {
    const float hardest = hardestStep(makeRecords(generator, 5, uint64_t(i)));
    if (hardest < 0) continue;
    sum += hardest;
    ++solved;
  }
  EXPECT_GE(solved, kLevels / 2) << style << " at " << difficulty;
  return sum / float(std::max(solved, 1));
}

class Played : public ::testing::TestWithParam<std::string> {};

TEST_P(Played, HarderLevelsAreFailedMore) {
  const float trivial = meanHardestStep(GetParam(), 0), medium = meanHardestStep(GetParam(), 0.5f),
              limit = meanHardestStep(GetParam(), 1);
  EXPECT_GT(trivial, medium);
  EXPECT_GT(medium, limit);
}

INSTANTIATE_TEST_SUITE_P(Styles, Played, ::testing::Values("gaps", "beam", "kill-floor", "wall"));

}  // namespace
}  // namespace obby::test
