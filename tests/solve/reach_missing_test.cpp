// An answer states how far the goal is out of reach. If a part is moved nearer by this distance
// plus half a stud, it must be reachable.
#include <gtest/gtest.h>

#include <cmath>

#include "solve/proof/reach_bound.h"
#include "support/hardest_step.h"

namespace obby::solve {
namespace {

Missing missingAt(const support::Build& build, float studs) {
  support::Scene scene = build(studs);
  const level::Level level = scene.level.compile();
  const Problem problem = support::plainProblem(level, support::queryFor(scene));
  return ReachBound(problem, true).missing(problem.query.goal);
}

// Tests that a designer can rely on the distance. `easy` is the size of a step, in studs, that is
// certainly solvable.
void expectToActOn(float easy, const support::Build& build) {
  const Missing m = missingAt(build, 20);
  EXPECT_FALSE(m.more);
  // The distance is rounded to hundredths, so that the last bits do not change the search.
  const float nearer = std::floor((20 - m.rise - m.gap - 0.5f) * 100) / 100;
  EXPECT_GE(support::hardestSolved(build, easy, nearer, 1'500'000), nearer);
}

TEST(ReachMissing, IsSufficientForGapsLedgesAndDrops) {
  expectToActOn(8, [](float x) { return support::platforms(x, 0); });
  expectToActOn(6, [](float x) { return support::platforms(0, x); });
  expectToActOn(8, [](float x) { return support::platforms(x, 4); });
  expectToActOn(8, [](float x) { return support::platforms(x, -8); });
}

TEST(ReachMissing, IsSufficientForMovingPlatforms) {
  expectToActOn(6, [](float x) { return support::off({8, 0, 0}, x); });
  expectToActOn(6, [](float x) { return support::off({0, 0, -8}, x); });
  expectToActOn(6, [](float x) { return support::off({0, 0, -8}, x, false); });
  expectToActOn(6, [](float x) { return support::off({0, 8, 0}, x); });
  expectToActOn(6, [](float x) { return support::onto({8, 0, 0}, x); });
  expectToActOn(6, [](float x) { return support::onto({0, 0, -8}, x); });
  expectToActOn(6, [](float x) { return support::onto({0, 8, 0}, x); });
}

// The answer does not name a near part that leads nowhere.
TEST(ReachMissing, IsTheStepTowardTheGoal) {
  support::Scene scene = support::platforms(15, 0);
  scene.level.block({20, 0, 0}, {2, 1, 2});
  const level::Level level = scene.level.compile();
  const Problem problem = support::plainProblem(level, support::queryFor(scene));
  const Missing m = ReachBound(problem, true).missing(problem.query.goal);
  EXPECT_EQ(level.view().colliders[m.to].part, support::kTarget);
  EXPECT_FALSE(m.more);
}

TEST(ReachMissing, ReportsThatMoreStepsAreMissing) {
  support::Scene scene = support::platforms(15, 0);
  scene.level.block({0, -4, -50}, {8, 8, 8});
  scene.goal = {{-4, 0, -54}, {4, 4, -46}};
  const level::Level level = scene.level.compile();
  const Problem problem = support::plainProblem(level, support::queryFor(scene));
  const Missing m = ReachBound(problem, true).missing(problem.query.goal);
  EXPECT_EQ(level.view().colliders[m.to].part, support::kTarget);
  EXPECT_TRUE(m.more);
}

}  // namespace
}  // namespace obby::solve
