// A twin's impassable wall cannot be jumped around, however far players jump.
#include "gen/made.h"
#include "level/level.h"

namespace obby::test {
namespace {

constexpr uint64_t kRoundaboutSeeds = 41;

// A style whose walls may be impassable, and the name prefix of the impassable crossing.
struct Planted {
  const char *style, *what;
};
constexpr Planted kPlanted[] = {{"wall", "rise-"}, {"doorway", "door-"}, {"button", "button-"}};

gen::Recipe recipeOf(const Planted& planted, const char* physics, float value) {
  gen::Recipe recipe = recipeFor(planted.style, 0.5f);
  recipe.physics = {{physics, value}};
  recipe.turns = 0;  // sideways is along X
  return recipe;
}

// Returns the studs by which walls extend beyond the widest floor.
float overhangOf(const gen::Sketch& sketch) {
  float outermost = 0, half = 0;
  for (const gen::PartSketch& p : sketch.parts()) {
    const float end = absf(p.position.x) + p.size.x / 2;
    if (p.name.rfind("Wall", 0) == 0) outermost = maxf(outermost, end);
    if (p.name.rfind("Floor", 0) == 0 || p.name.rfind("Hall", 0) == 0) half = maxf(half, end);
  }
  return outermost - half;
}

TEST(Roundabout, AroundAnImpassableWallIsBeyondAJump) {
  for (const Planted& planted : kPlanted) {
    const gen::Generator twins = generatorOf(recipeOf(planted, "gravity", 20), true);
    int walls = 0;
    for (uint64_t seed = 0; seed < kRoundaboutSeeds; ++seed) {
      const gen::Generated made = twins.generate(seed, 0);
      if (made.sketch.plantedWhat().rfind(planted.what, 0) != 0) continue;
      ++walls;
      const float overhang = overhangOf(made.sketch);
      EXPECT_GE(2 * overhang, twins.reach().gap(0)) << made.name << ": there and back";
      EXPECT_GE(overhang, twins.reach().gap(-20))
          << made.name << ": to a lane that turns behind it";
    }
    EXPECT_GT(walls, 2) << planted.style;
  }
}

// The planks of a decoy extend far to a side.
TEST(Roundabout, IsBeyondAJumpFromEarlierPartsAtTheSide) {
  gen::Recipe recipe = recipeOf({"course", ""}, "gravity", 20);
  recipe.courseStyles = {{"decoy", 1}, {"wall", 1}};
  const gen::Generator twins = generatorOf(recipe, true);
  int walls = 0;
  for (uint64_t seed = 0; seed < kRoundaboutSeeds; ++seed) {
    const gen::Generated made = twins.generate(seed, 0);
    if (made.sketch.plantedWhat().rfind("rise-", 0) != 0) continue;
    const std::vector<gen::PartSketch>& parts = made.sketch.parts();
    size_t planted = 0;  // the widest wall
    for (size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].name.rfind("Wall", 0) == 0 && parts[i].size.x > parts[planted].size.x)
        planted = i;
    }
    const float end = parts[planted].size.x / 2;
    for (size_t i = 0; i < planted; ++i) {
      if (parts[i].name.rfind("Plank", 0) != 0) continue;
      ++walls;
      EXPECT_GE(end - absf(parts[i].position.x) - parts[i].size.x / 2, twins.reach().gap(0))
          << made.name << ' ' << parts[i].name;
    }
  }
  EXPECT_GT(walls, 0);
}

TEST(Roundabout, IsTheStylesOwnIfJumpsAreShort) {
  const gen::Generator generator = generatorOf({});
  const gen::Recipe recipe;
  const gen::Sketch sketch(generator.reach(), recipe, Random(1, 0), {});
  EXPECT_EQ(sketch.roundabout(30), 30.0f);
  EXPECT_EQ(sketch.roundabout(20), 20.0f);
}

// These values are close to the physics for which twins are refused.
TEST(Roundabout, CompilesForTheLongestJumps) {
  for (const Planted& planted : kPlanted) {
    for (const auto& [physics, value] :
         {std::pair("gravity", 12.0f), std::pair("walkSpeed", 210.0f)}) {
      gen::Recipe recipe = recipeOf({"course", ""}, physics, value);
      recipe.courseStyles = {{"decoy", 1}, {planted.style, 1}};
      const gen::Generator twins = generatorOf(recipe, true);
      for (uint64_t seed = 0; seed < kRoundaboutSeeds; ++seed) {
        const Made made = makeRecords(twins, seed, 0);
        const auto level = level::Level::compile(made.level.reader().getLevel());
        EXPECT_TRUE(level) << planted.style << ' ' << physics << ": " << level.error().text();
      }
    }
  }
}

}  // namespace
}  // namespace obby::test
