// A search solves each style about as often as its difficulty promises. It never solves a twin, or
// a level without the style's typical feature. Budgets are in steps, so results are the same on
// every machine.
#include <gtest/gtest.h>

#include "gen/asked.h"

namespace obby::test {
namespace {

using schema::Verdict;

struct Tally {
  int solved = 0, unreachable = 0, unknown = 0;
};

Verdict verdictOf(const Made& made, uint64_t steps) {
  return ask(made, limitedTo(steps), [](schema::Record::Reader) { return Status(); });
}

Tally tally(const gen::Recipe& recipe, bool unsolvable, int levels, uint64_t steps) {
  const gen::Generator generator = generatorOf(recipe, unsolvable);
  Tally t;
  for (int i = 0; i < levels; ++i) {
    switch (verdictOf(makeRecords(generator, 5, uint64_t(i)), steps)) {
      case Verdict::SOLVED: ++t.solved; break;
      case Verdict::UNREACHABLE: ++t.unreachable; break;
      case Verdict::UNKNOWN: ++t.unknown; break;
    }
  }
  return t;
}

class Solved : public ::testing::TestWithParam<std::string> {};

TEST_P(Solved, EasyLevelsNearlyAlways) {
  const Tally t = tally(recipeFor(GetParam(), 0.25f), false, 40, 1'000'000);
  EXPECT_GE(t.solved, 38) << t.unknown << " unknown";
  EXPECT_EQ(t.unreachable, 0);
}

TEST_P(Solved, MediumLevelsMostly) {
  const Tally t = tally(recipeFor(GetParam(), 0.5f), false, 40, 1'000'000);
  EXPECT_GE(t.solved, 36) << t.unknown << " unknown";
  EXPECT_EQ(t.unreachable, 0);
}

// The search is slow for jumps at the limit. A few levels show that these jumps are possible.
TEST_P(Solved, LimitLevelsByHalfAtLeast) {
  const Tally t = tally(recipeFor(GetParam(), 1), false, 8, 3'000'000);
  EXPECT_GE(t.solved, 4) << t.unknown << " unknown";
  EXPECT_EQ(t.unreachable, 0);
}

TEST_P(Solved, TwinsNever) {
  const Tally t = tally(recipeFor(GetParam(), 0.25f), true, 40, 60'000);
  EXPECT_EQ(t.solved, 0);
}

// The parameters of the styles are random.
TEST_P(Solved, TwinsOfAnyParametersNever) {
  for (uint64_t seed = 0; seed < 16; ++seed) {
    const gen::Recipe recipe = anyParametersFor(GetParam(), 0.25f, seed);
    EXPECT_EQ(tally(recipe, true, 2, 60'000).solved, 0) << seed;
  }
}

// Tests the physics of real games. In one of them players can hardly jump.
TEST_P(Solved, LevelsWithOtherPhysicsTooAndTheirTwinsNever) {
  for (const std::vector<gen::NamedNumber>& physics :
       std::vector<std::vector<gen::NamedNumber>>{{{"gravity", 80}, {"walkSpeed", 54}},
                                                  {{"gravity", 160}, {"walkSpeed", 22}},
                                                  {{"jumpSpeed", 22}}}) {
    gen::Recipe recipe = recipeFor(GetParam(), 0.25f);
    recipe.physics = physics;
    SCOPED_TRACE(physics[0].name + " " + std::to_string(physics[0].value));
    const Tally own = tally(recipe, false, 4, 400'000);
    EXPECT_EQ(own.unreachable, 0);
    EXPECT_GT(own.solved, 0);
    EXPECT_EQ(tally(recipe, true, 4, 30'000).solved, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Solved, ::testing::ValuesIn(styleNames()), testName);

// Returns the number of levels solved after `take` removes the feature that the style needs.
int solvedWithout(const std::string& style, const std::function<void(Made&)>& take) {
  const gen::Generator generator = generatorOf(recipeFor(style, 0.5f));
  int solved = 0;
  for (uint64_t i = 0; i < 10; ++i) {
    Made made = makeRecords(generator, 5, i);
    take(made);
    solved += verdictOf(made, 60'000) == Verdict::SOLVED;
  }
  return solved;
}

TEST(Needs, StylesOfJumpsNeedJumps) {
  for (const char* style : {"gaps", "stairs-up", "wall", "kill-floor", "kill-wall"}) {
    EXPECT_EQ(solvedWithout(style, [](Made& m) { m.query.root().getQuery().setMaxJumps(0); }), 0)
        << style;
  }
}

TEST(Needs, WalksNeedNoJumps) {
  for (const char* style : {"walkway", "doorway", "beam", "wedge"}) {
    EXPECT_EQ(solvedWithout(style, [](Made& m) { m.query.root().getQuery().setMaxJumps(0); }), 10)
        << style;
  }
}

// Applies `strip` to all parts.
template <class Strip>
std::function<void(Made&)> stripped(Strip strip) {
  return [strip](Made& m) {
    for (auto part : m.level.root().getLevel().getParts()) strip(part);
  };
}

TEST(Needs, StylesNeedTheirParts) {
  using Part = schema::Part::Builder;
  EXPECT_EQ(solvedWithout("truss", stripped([](Part p) {
                            if (p.getShape() == schema::Shape::TRUSS)
                              p.setShape(schema::Shape::BLOCK);
                          })),
            0);
  EXPECT_EQ(solvedWithout("jump-pad", stripped([](Part p) { p.disownJumpPad(); })), 0);
  EXPECT_EQ(solvedWithout("elevator", stripped([](Part p) { p.disownMotion(); })), 0);
  EXPECT_EQ(solvedWithout("carrier", stripped([](Part p) { p.disownMotion(); })), 0);
  EXPECT_EQ(solvedWithout("push-block", stripped([](Part p) { p.setAnchored(true); })), 0);
  EXPECT_EQ(solvedWithout("button", stripped([](Part p) {
                            p.disownButton();
                            if (p.getVanish().getInverted()) p.setSolid(false);
                            p.disownVanish();
                          })),
            0);
}

}  // namespace
}  // namespace obby::test
