// All styles give valid levels, distinct part names, margins that follow the difficulty, and twins
// that differ in one crossing.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gen/made.h"
#include "gen/recipe.h"
#include "level/level.h"

namespace obby::test {
namespace {

constexpr uint64_t kStylesSeeds = 40;

class Styles : public ::testing::TestWithParam<std::string> {};

void expectSound(const Made& made) {
  const auto record = made.level.reader().getLevel();
  const auto level = level::Level::compile(record);
  ASSERT_TRUE(level) << level.error().text();
  const auto query = level::Query::compile(made.query.reader().getQuery(), *level);
  ASSERT_TRUE(query) << query.error().text();
  EXPECT_EQ(query->id(), made.query.reader().getQuery().getId().cStr());
  std::set<std::string> names;
  for (const auto part : record.getParts()) names.insert(part.getName().cStr());
  EXPECT_EQ(names.size(), record.getParts().size()) << "part names repeat";
  EXPECT_LT(record.getPhysics().getFallenPartsHeight(), level->bounds().lo.y - 1);
}

TEST_P(Styles, LevelsCompileAtEveryDifficulty) {
  for (const bool unsolvable : {false, true}) {
    for (const gen::NamedNumber& d : gen::namedDifficulties()) {
      const gen::Generator generator = generatorOf(recipeFor(GetParam(), d.value), unsolvable);
      for (uint64_t seed = 0; seed < kStylesSeeds; ++seed) {
        SCOPED_TRACE(fmt::format("{} seed {}", d.name, seed));
        expectSound(makeRecords(generator, seed, 0));
      }
    }
  }
}

TEST_P(Styles, AreInTheNamesOfLevels) {
  for (const bool unsolvable : {false, true}) {
    for (const gen::NamedNumber& d : gen::namedDifficulties()) {
      const gen::Generator generator = generatorOf(recipeFor(GetParam(), d.value), unsolvable);
      const std::string name = generator.generate(7, 12).name;
      EXPECT_EQ(gen::styleOfLevel(name), gen::findStyle(GetParam())) << name;
    }
  }
}

TEST(StyleOfLevel, IsNullForOtherNames) {
  for (const char* name : {"", "Tower", "gaps", "gaps-7-12", "gaps-and-more-hard-7-12", "-hard-7"})
    EXPECT_EQ(gen::styleOfLevel(name), nullptr) << name;
}

// A level with the maximum number of obstacles must still compile.
TEST_P(Styles, TheLongestLevelsCompile) {
  for (const float difficulty : {0.0f, 1.0f}) {
    gen::Recipe recipe = recipeFor(GetParam(), difficulty);
    recipe.obstacles = recipe.courseObstacles = {200, 200};
    ASSERT_TRUE(checkRecipe(recipe));
    const Made made = makeRecords(generatorOf(recipe), 1, 0);
    const auto level = level::Level::compile(made.level.reader().getLevel());
    EXPECT_TRUE(level) << level.error().text();
  }
}

// Returns the number of parts whose size, seen from above, differs. Heights are ignored, since they
// depend on earlier parts.
size_t partsThatDiffer(const gen::Sketch& a, const gen::Sketch& b) {
  const auto alike = [](const gen::PartSketch& x, const gen::PartSketch& y) {
    return x.size.x == y.size.x && x.size.z == y.size.z;
  };
  const auto &one = a.parts(), &other = b.parts();
  const size_t shorter = std::min(one.size(), other.size());
  size_t before = 0, behind = 0;
  while (before < shorter && alike(one[before], other[before])) ++before;
  while (behind < shorter - before &&
         alike(one[one.size() - 1 - behind], other[other.size() - 1 - behind]))
    ++behind;
  return std::max(one.size(), other.size()) - before - behind;
}

// A twin leaves out or raises a few parts. The random draws after them must stay the same.
TEST_P(Styles, TwinsDifferInOneCrossingOnly) {
  constexpr size_t kOfACrossing = 3;
  const gen::Recipe recipe = recipeFor(GetParam(), 0.5f);
  const gen::Generator solvable = generatorOf(recipe), twins = generatorOf(recipe, true);
  for (uint64_t seed = 0; seed < kStylesSeeds; ++seed) {
    const gen::Generated a = solvable.generate(seed, 0), b = twins.generate(seed, 0);
    EXPECT_LE(partsThatDiffer(a.sketch, b.sketch), kOfACrossing) << b.name;
  }
}

TEST_P(Styles, LevelsWithOtherPhysicsCompileToo) {
  gen::Recipe recipe = recipeFor(GetParam(), 1);
  for (const auto& physics : std::vector<std::vector<gen::NamedNumber>>{
           {{"gravity", 0}},
           {{"gravity", 2000}},
           {{"walkSpeed", 0}},
           {{"walkSpeed", 500}, {"jumpSpeed", 1000}},
           {{"jumpSpeed", 0}},
           {{"hipHeight", 20}, {"headBottom", 30}, {"bodyTop", 40}}}) {
    recipe.physics = physics;
    const gen::Generator generator = generatorOf(recipe);
    for (uint64_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(fmt::format("{} {}, seed {}", physics[0].name, physics[0].value, seed));
      expectSound(makeRecords(generator, seed, 0));
    }
  }
}

TEST_P(Styles, LevelsBeginAtTheStartAndEndAtTheGoal) {
  const gen::Generator generator = generatorOf(recipeFor(GetParam(), 0.5f));
  for (uint64_t seed = 0; seed < kStylesSeeds; ++seed) {
    const Made made = makeRecords(generator, seed, 0);
    const auto level = made.level.reader().getLevel();
    ASSERT_GE(level.getSpawns().size(), 1u);
    EXPECT_EQ(level.getSpawns()[0].getPart(), 0);
    EXPECT_STREQ(level.getParts()[0].getName().cStr(), "Start");
    uint32_t goals = 0;
    for (const auto part : level.getParts()) {
      if (!part.hasGoal()) continue;
      ++goals;
      const auto region = made.query.reader().getQuery().getGoal();
      const float top = part.getPosition().getY() + 0.5f;
      EXPECT_NEAR(region.getPosition().getY() - region.getSize().getY() / 2, top, 0.01);
      EXPECT_NEAR(region.getPosition().getX(), part.getPosition().getX(), 0.01);
      EXPECT_NEAR(region.getPosition().getZ(), part.getPosition().getZ(), 0.01);
    }
    EXPECT_EQ(goals, 1u);
  }
}

// The route guides training.
TEST_P(Styles, TheLineGoesFromTheStartThroughAllStopsToTheGoal) {
  const gen::Generator generator = generatorOf(recipeFor(GetParam(), 0.5f));
  for (uint64_t seed = 0; seed < kStylesSeeds; ++seed) {
    const gen::Generated made = generator.generate(seed, 0);
    const std::vector<Vec3>& line = made.sketch.line();
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.front(), made.sketch.stops().front().feet);
    EXPECT_EQ(line.back(), made.sketch.stops().back().feet);
    size_t next = 0;
    for (const gen::Stop& stop : made.sketch.stops()) {
      while (next < line.size() && !(line[next] == stop.feet)) ++next;
      EXPECT_LT(next, line.size()) << "a stop next to the line";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Styles, ::testing::ValuesIn(styleNames()), testName);

TEST(StyleTable, HasUniqueNamesAndDescriptions) {
  std::set<std::string> names;
  for (const gen::Style& s : gen::styles()) {
    EXPECT_TRUE(names.insert(s.name).second) << s.name;
    EXPECT_NE(std::string(s.description), "");
    EXPECT_EQ(s.build == nullptr, s.chains) << s.name;
  }
  EXPECT_EQ(gen::findStyle("no-such-style"), nullptr);
}

// Gaps and rises of any style grow with the difficulty and stay within reach.
TEST(Measures, GapsAndRisesGrowWithTheDifficulty) {
  const gen::Generator generator = generatorOf({});
  const gen::Recipe recipe;
  for (uint64_t seed = 0; seed < kStylesSeeds; ++seed) {
    float gap = 0, rise = 0;
    for (const gen::NamedNumber& d : gen::namedDifficulties()) {
      gen::Sketch s(generator.reach(), recipe, Random(seed, 0), {});
      s.begin(d.value);
      const float wider = s.gap(), higher = s.rise();
      EXPECT_GT(wider, gap) << d.name;
      EXPECT_GT(higher, rise) << d.name;
      gap = wider;
      rise = higher;
    }
    EXPECT_LT(gap, generator.reach().gap(0));
    EXPECT_LT(rise, generator.reach().rise());
  }
}

// A straight line would cut through the core.
TEST(Spiral, TheLineGoesAroundTheCore) {
  const gen::Generator generator = generatorOf(recipeFor("spiral", 0.5f));
  for (uint64_t seed = 0; seed < kStylesSeeds; ++seed) {
    const gen::Generated made = generator.generate(seed, 0);
    const auto& parts = made.sketch.parts();
    const auto core = std::find_if(parts.begin(), parts.end(),
                                   [](const auto& p) { return p.name.rfind("Core", 0) == 0; });
    ASSERT_NE(core, parts.end());
    for (const Vec3& at : made.sketch.line()) {
      const float x = at.x - core->position.x, z = at.z - core->position.z;
      EXPECT_GT(x * x + z * z, 81) << seed;
    }
  }
}

}  // namespace
}  // namespace obby::test
