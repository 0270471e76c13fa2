// Levels depend only on seed and index. Also tests twins, query constraints, and the reach that
// follows from the physics.
#include <gtest/gtest.h>

#include <algorithm>

#include "gen/made.h"
#include "level/level.h"
#include "level/record_values.h"

namespace obby::test {
namespace {

TEST(Generator, ALevelDependsOnSeedAndIndexAlone) {
  const gen::Generator generator = generatorOf({}), other = generatorOf({});
  const std::string tenth = bytesOf(makeRecords(generator, 7, 10));
  for (uint64_t i = 0; i < 20; ++i) makeRecords(other, 7, i);
  EXPECT_EQ(bytesOf(makeRecords(other, 7, 10)), tenth);
  EXPECT_NE(bytesOf(makeRecords(other, 8, 10)), tenth);
  EXPECT_NE(bytesOf(makeRecords(other, 7, 11)), tenth);
}

TEST(Generator, StylesFollowTheirWeights) {
  gen::Recipe recipe;
  recipe.styles = {{"gaps", 3}, {"wall", 1}, {"beam", 0}};
  const gen::Generator generator = generatorOf(recipe);
  int gaps = 0, walls = 0;
  for (uint64_t i = 0; i < 2000; ++i) {
    const std::string name = generator.generate(1, i).name;
    gaps += name.rfind("gaps-", 0) == 0;
    walls += name.rfind("wall-", 0) == 0;
  }
  EXPECT_EQ(gaps + walls, 2000);
  EXPECT_NEAR(gaps, 1500, 100);
}

TEST(Generator, ATwinLacksOneCrossingAndNamesIt) {
  const gen::Recipe recipe = recipeFor("gaps", 0.5f);
  const gen::Generator solvable = generatorOf(recipe), twins = generatorOf(recipe, true);
  for (uint64_t seed = 0; seed < 40; ++seed) {
    const gen::Generated a = solvable.generate(seed, 0), b = twins.generate(seed, 0);
    ASSERT_EQ(a.sketch.parts().size(), b.sketch.parts().size());
    EXPECT_EQ(b.name, a.name + "-without-" + b.sketch.plantedWhat());
    EXPECT_EQ(b.query, "beyond-" + b.sketch.plantedWhat());
    // One step between parts is longer, and all others are unchanged.
    int longer = 0;
    for (size_t i = 1; i < a.sketch.parts().size(); ++i) {
      const auto step = [&](const gen::Generated& g) {
        return length(g.sketch.parts()[i].position - g.sketch.parts()[i - 1].position);
      };
      EXPECT_EQ(a.sketch.parts()[i].size, b.sketch.parts()[i].size);
      if (step(b) > step(a) + 3)
        ++longer;
      else
        EXPECT_NEAR(step(b), step(a), 1e-3f);
    }
    EXPECT_EQ(longer, 1);
  }
}

// The route guides training. A twin has no solution, so its query has no route.
TEST(Generator, QueriesStateALineAndTheirDifficulty) {
  gen::Recipe recipe;
  recipe.difficulty = {0.2f, 0.7f};
  const gen::Generator generator = generatorOf(recipe), twins = generatorOf(recipe, true);
  for (uint64_t i = 0; i < 60; ++i) {
    const Made made = makeRecords(generator, 5, i), twin = makeRecords(twins, 5, i);
    const std::vector<Vec3> line = generator.generate(5, i).sketch.line();
    const auto query = made.query.reader().getQuery();
    ASSERT_EQ(query.getRoute().size(), line.size());
    for (uint32_t k = 0; k < line.size(); ++k)
      EXPECT_LT(length(level::vec(query.getRoute()[k]) - line[k]), 0.11f) << i;
    EXPECT_GE(query.getDifficulty(), 0.2f);
    EXPECT_LE(query.getDifficulty(), 0.7f);
    EXPECT_FALSE(twin.query.reader().getQuery().hasRoute());
    EXPECT_EQ(twin.query.reader().getQuery().getDifficulty(), -1);
  }
}

// Readers refuse a line with more points than the schema allows.
TEST(Generator, TheLineOfALongLevelFitsTheSchema) {
  const gen::Style& spiral = *gen::findStyle("spiral");
  gen::Recipe recipe = recipeFor("spiral", 0.5f);
  recipe.obstacles = {200, 200};
  recipe.parameters = {{*gen::parameterNamed(spiral, "size", ""), 2, 2},
                       {*gen::parameterNamed(spiral, "gap", ""), 0, 0}};
  const gen::Generator generator = generatorOf(recipe);
  const std::vector<Vec3> line = generator.generate(1, 0).sketch.line();
  EXPECT_GT(line.size(), 4096u);
  const Made made = makeRecords(generator, 1, 0);
  const auto route = made.query.reader().getQuery().getRoute();
  EXPECT_GT(route.size(), 1000u);
  EXPECT_LE(route.size(), 4096u);
  EXPECT_LT(length(level::vec(route[0]) - line.front()), 0.11f);
  EXPECT_LT(length(level::vec(route[route.size() - 1]) - line.back()), 0.11f);
}

// After a wide floor, a turn would bring the next floor within a jump of an earlier one.
TEST(Generator, TheLineDoesNotTurnNextToEnlargedFloors) {
  const gen::Style& gaps = *gen::findStyle("gaps");
  const gen::Parameter& size = **gen::parameterNamed(gaps, "size", "");
  gen::Recipe recipe = recipeFor("gaps", 0.25f);
  recipe.turns = 1;
  recipe.obstacles = {3, 3};
  const auto turns = [&](float studs) {
    recipe.parameters = {{&size, studs, studs}};
    const gen::Generated made = generatorOf(recipe).generate(1, 0);
    return std::ranges::any_of(made.sketch.stops(),
                               [](const gen::Stop& stop) { return stop.heading != 0; });
  };
  EXPECT_TRUE(turns(7));
  EXPECT_TRUE(turns(3));
  EXPECT_FALSE(turns(7.25f));
  EXPECT_FALSE(turns(30));
}

TEST(Generator, DropsCountInTheCheckOfThePhysics) {
  gen::Recipe recipe = recipeFor("stairs-down", 0.5f);
  recipe.physics = {{"gravity", 4}, {"jumpSpeed", 2}, {"walkSpeed", 60}};
  EXPECT_FALSE(gen::Generator::make(recipe, true));
}

TEST(Generator, SharesOfQueriesHaveConstraints) {
  gen::Recipe recipe = recipeFor("course", 0.5f);
  const auto count = [&](auto has) {
    const gen::Generator generator = generatorOf(recipe);
    int found = 0;
    for (uint64_t i = 0; i < 200; ++i) {
      const Made made = makeRecords(generator, 1, i);
      found += has(made.query.reader().getQuery());
    }
    return found;
  };
  const auto jumps = [](schema::Query::Reader q) { return q.getMaxJumps() >= 0; };
  const auto time = [](schema::Query::Reader q) { return q.getTimeLimit() > 0; };
  const auto waypoints = [](schema::Query::Reader q) { return q.getWaypoints().size() > 0; };
  EXPECT_EQ(count(jumps) + count(time) + count(waypoints), 0);
  recipe.jumpLimits = recipe.timeLimits = 0.5f;
  recipe.waypoints = 1;
  EXPECT_NEAR(count(jumps), 100, 30);
  EXPECT_NEAR(count(time), 100, 30);
  EXPECT_GT(count(waypoints), 120);
}

TEST(Generator, CoursesHaveEachSingleStyleAtMostOnce) {
  gen::Recipe recipe = recipeFor("course", 1);
  recipe.courseObstacles = {12, 12};
  recipe.courseStyles = {{"push-block", 1}, {"gaps", 1}};
  const gen::Generator generator = generatorOf(recipe);
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const gen::Generated g = generator.generate(seed, 0);
    int blocks = 0;
    for (const gen::PartSketch& p : g.sketch.parts()) blocks += !p.anchored;
    EXPECT_LE(blocks, 1);
    EXPECT_EQ(g.sketch.stops().size(), 13u);
  }
}

// Mean gaps in studs, in the first and the last third of straight courses that consist of gaps
// only.
struct MeanGaps {
  double first, last;
};

MeanGaps meanGapsOfCourses(float courseFirst) {
  constexpr uint32_t kObstacles = 30;
  gen::Recipe recipe = recipeFor("course", 1);
  recipe.courseObstacles = {kObstacles, kObstacles};
  recipe.courseStyles = {{"gaps", 1}};
  recipe.courseFirst = courseFirst;
  recipe.turns = 0;
  const gen::Generator generator = generatorOf(recipe);
  double studs[3] = {};
  int gaps[3] = {};
  for (uint64_t seed = 0; seed < 8; ++seed) {
    const gen::Generated made = generator.generate(seed, 0);
    const std::vector<gen::PartSketch>& parts = made.sketch.parts();
    uint32_t obstacle = 0;  // each obstacle ends with a checkpoint, the last one with the goal
    for (size_t i = 1; i < parts.size(); ++i) {
      const gen::PartSketch &from = parts[i - 1], &to = parts[i];
      if (to.checkpoint > 0) ++obstacle;
      if (to.name.rfind("Stone", 0) != 0) continue;
      const uint32_t third = std::min(obstacle * 3 / kObstacles, 2u);
      const float apart = absf(to.position.z - from.position.z);
      studs[third] += double(apart - (from.size.z + to.size.z) / 2);
      ++gaps[third];
    }
  }
  return {studs[0] / gaps[0], studs[2] / gaps[2]};
}

// From difficulty 0 to 1, a gap grows from 0.25 to 0.93 of the reach. With a first difficulty of
// 0.2, the mean difficulty is 0.33 in the first third, so the mean gap is 0.47 of the reach. In the
// last third the mean difficulty is 0.88, so the mean gap is 0.84 of the reach, 1.8 times as much.
TEST(Generator, CoursesGetHarderFromTheirFirstDifficulty) {
  const MeanGaps growing = meanGapsOfCourses(0.2f);
  EXPECT_GT(growing.last, 1.5 * growing.first);
  EXPECT_LT(growing.last, 2.1 * growing.first);
  const MeanGaps even = meanGapsOfCourses(1);
  EXPECT_NEAR(even.last / even.first, 1, 0.05);
  EXPECT_GT(even.first, growing.first);
}

TEST(Reach, FollowsThePhysics) {
  gen::Recipe recipe;
  const gen::Reach plain = generatorOf(recipe).reach();
  EXPECT_NEAR(plain.gap(0), 11.5f, 0.3f);
  EXPECT_NEAR(plain.rise(), 9, 0.3f);
  EXPECT_GT(plain.gap(-5), plain.gap(0));
  EXPECT_LT(plain.gap(5), plain.gap(0));
  EXPECT_EQ(plain.gap(plain.rise() + 1), 0);
  recipe.physics = {{"gravity", 80}};
  const gen::Reach light = generatorOf(recipe).reach();
  EXPECT_GT(light.gap(0), 1.8f * plain.gap(0));
  EXPECT_GT(light.rise(), 1.8f * plain.rise());
}

TEST(Generator, LevelsStateThePhysicsTheyWereMadeFor) {
  gen::Recipe recipe = recipeFor("gaps", 0.5f);
  recipe.physics = {{"gravity", 80}, {"walkSpeed", 54}};
  const Made made = makeRecords(generatorOf(recipe), 1, 0);
  EXPECT_EQ(made.level.reader().getLevel().getPhysics().getGravity(), 80);
  EXPECT_EQ(made.level.reader().getLevel().getPhysics().getWalkSpeed(), 54);
}

}  // namespace
}  // namespace obby::test
