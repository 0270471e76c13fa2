// Parameters of styles in recipes. Every parameter has an effect and stays within its range, and
// levels compile for all values.
#include <set>

#include "gen/made.h"
#include "level/level.h"

namespace obby::test {
namespace {

constexpr uint64_t kSeeds = 12;

class Parameters : public ::testing::TestWithParam<std::string> {};

const gen::Style& styleOf(const std::string& name) { return *gen::findStyle(name); }

std::string bytesWith(const std::string& style, std::vector<gen::Setting> settings, uint64_t seed) {
  gen::Recipe recipe = recipeFor(style, 0.5f);
  recipe.obstacles = {2, 2};
  recipe.parameters = std::move(settings);
  return bytesOf(makeRecords(generatorOf(recipe), seed, 0));
}

TEST_P(Parameters, HaveUniqueNamesAndDescriptions) {
  std::set<std::string> names;
  for (const gen::Parameter& p : styleOf(GetParam()).parameters) {
    EXPECT_TRUE(names.insert(p.name).second) << p.name;
    EXPECT_NE(std::string(p.description), "") << p.name;
    for (const float end : {p.easy, p.hard}) {
      EXPECT_GE(end, p.min) << p.name;
      EXPECT_LE(end, p.max) << p.name;
    }
  }
}

// This test detects a parameter that no obstacle uses, or that is confused with another.
TEST_P(Parameters, EachOneChangesLevels) {
  for (const gen::Parameter& p : styleOf(GetParam()).parameters) {
    int changed = 0;
    for (uint64_t seed = 0; seed < kSeeds; ++seed) {
      changed += bytesWith(GetParam(), {{&p, p.min, p.min}}, seed) !=
                 bytesWith(GetParam(), {{&p, p.max, p.max}}, seed);
    }
    EXPECT_GT(changed, 0) << p.name;
  }
}

TEST_P(Parameters, DefaultValuesChangeNothing) {
  std::vector<gen::Setting> settings;
  for (const gen::Parameter& p : styleOf(GetParam()).parameters) {
    settings.push_back({&p, p.easy, p.hard});
  }
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    EXPECT_EQ(bytesWith(GetParam(), settings, seed), bytesWith(GetParam(), {}, seed));
  }
}

TEST_P(Parameters, LevelsCompileThroughoutTheRanges) {
  for (const bool unsolvable : {false, true}) {
    for (uint64_t seed = 0; seed < kSeeds; ++seed) {
      for (const float difficulty : {0.0f, 0.5f, 1.0f}) {
        const gen::Recipe recipe = anyParametersFor(GetParam(), difficulty, seed);
        const Made made = makeRecords(generatorOf(recipe, unsolvable), seed, 0);
        const auto level = level::Level::compile(made.level.reader().getLevel());
        ASSERT_TRUE(level) << level.error().text();
        const auto query = level::Query::compile(made.query.reader().getQuery(), *level);
        ASSERT_TRUE(query) << query.error().text();
      }
    }
  }
}

// The largest counts together with the slowest motion give the longest tables of motion.
TEST_P(Parameters, TheLongestLevelsCompileAtTheirEnds) {
  for (const bool slow : {false, true}) {
    gen::Recipe recipe = recipeFor(GetParam(), 1);
    recipe.obstacles = recipe.courseObstacles = {200, 200};
    for (const gen::Style& s : gen::styles()) {
      for (const gen::Parameter& p : s.parameters) {
        const bool speed = std::string(p.unit).find("/s") != std::string::npos;
        const float end = speed && slow ? p.min : p.max;
        recipe.parameters.push_back({&p, end, end});
      }
    }
    const Made made = makeRecords(generatorOf(recipe), 1, 0);
    const auto level = level::Level::compile(made.level.reader().getLevel());
    EXPECT_TRUE(level) << level.error().text();
  }
}

INSTANTIATE_TEST_SUITE_P(All, Parameters, ::testing::ValuesIn(styleNames()), testName);

// The parameter sets the size in its stated unit, at both ends of the difficulty range.
TEST(ParameterOfGaps, IsTheSizeOfStones) {
  const auto parameter = gen::parameterNamed(*gen::findStyle("gaps"), "size", "");
  ASSERT_TRUE(parameter);
  for (const float difficulty : {0.0f, 1.0f}) {
    gen::Recipe recipe = recipeFor("gaps", difficulty);
    recipe.parameters = {{*parameter, 20, 10}};
    const gen::Generator generator = generatorOf(recipe);
    for (uint64_t seed = 0; seed < kSeeds; ++seed) {
      const gen::Generated made = generator.generate(seed, 0);
      for (const gen::PartSketch& part : made.sketch.parts()) {
        if (part.name.rfind("Stone", 0) != 0) continue;
        EXPECT_NEAR(part.size.x, difficulty == 0 ? 20 : 10, 1) << made.name;
        EXPECT_EQ(part.size.x, part.size.z);
      }
    }
  }
}

// A short hop has no space for as many stones as the parameter asks for.
TEST(ParameterOfForks, KeepsStonesApart) {
  const auto parameter = gen::parameterNamed(*gen::findStyle("fork"), "stone", "");
  ASSERT_TRUE(parameter);
  gen::Recipe recipe = recipeFor("fork", 0);
  recipe.physics = {{"walkSpeed", 8}};
  recipe.parameters = {{*parameter, 9.25f, 9.25f}};
  const gen::Generator generator = generatorOf(recipe);
  int neighbours = 0;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    const gen::Generated made = generator.generate(seed, 0);
    const std::vector<gen::PartSketch>& parts = made.sketch.parts();
    for (size_t i = 1; i < parts.size(); ++i) {
      const gen::PartSketch &from = parts[i - 1], &to = parts[i];
      if (from.name.rfind("Stone", 0) != 0 || to.name.rfind("Stone", 0) != 0) continue;
      EXPECT_GT(length(to.position - from.position), to.size.z) << made.name;
      ++neighbours;
    }
  }
  EXPECT_GT(neighbours, 10);
}

TEST(ParameterOfSpinners, IsTheSpeedOfBars) {
  const auto parameter = gen::parameterNamed(*gen::findStyle("spinner"), "speed", "");
  ASSERT_TRUE(parameter);
  gen::Recipe recipe = recipeFor("spinner", 0.5f);
  recipe.parameters = {{*parameter, 4, 4}};
  const gen::Generator generator = generatorOf(recipe);
  int bars = 0;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    const gen::Generated made = generator.generate(seed, 0);
    for (const gen::PartSketch& part : made.sketch.parts()) {
      if (!part.motion) continue;
      EXPECT_NEAR(absf(part.motion->spin), 4, 0.05f);
      ++bars;
    }
  }
  EXPECT_GT(bars, 10);
}

// A course consists of other styles' obstacles, to which their parameters apply.
TEST(ParameterOfGaps, AppliesInCourses) {
  const auto parameter = gen::parameterNamed(*gen::findStyle("gaps"), "stones", "");
  ASSERT_TRUE(parameter);
  gen::Recipe recipe = recipeFor("course", 0.5f);
  recipe.courseStyles = {{"gaps", 1}};
  recipe.courseObstacles = {3, 3};
  recipe.parameters = {{*parameter, 7, 7}};
  const gen::Generated made = generatorOf(recipe).generate(1, 0);
  int stones = 0;
  for (const gen::PartSketch& p : made.sketch.parts()) stones += p.name.rfind("Stone", 0) == 0;
  EXPECT_EQ(stones, 21);
}

}  // namespace
}  // namespace obby::test
