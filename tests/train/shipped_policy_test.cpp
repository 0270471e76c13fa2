// Tests the shipped policy alone, on courses that it was not trained on (policies/README.md).
#include "policy/shipped_policy.h"

#include <gtest/gtest.h>

#include "shared/generated_levels.h"
#include "train/evaluate.h"

namespace obby::train {
namespace {

// A shipped policy must solve at least 60 % of the courses. This one solves 88 % of 1,000 similar
// courses (policies/README.md); the standard deviation for a hundred courses is three points.
TEST(ShippedPolicy, SolvesMostUnseenCourses) {
  constexpr double kMin = 0.6;
  gen::Recipe recipe;
  recipe.styles = {{"course", 1}};
  recipe.difficulty = {0.25f, 0.75f};  // easy to hard
  const auto courses = tools::generatedLevels(recipe, 5);
  ASSERT_TRUE(courses) << courses.error().text();
  EvaluationSettings how;
  how.levels = 100;
  how.tries = 3;
  ThreadPool pool(2);
  const std::atomic<bool> stop{false};
  const Evaluation found = evaluate(policy::shippedPolicy().network, **courses, how, pool, stop);
  EXPECT_EQ(found.levels, 100u);
  EXPECT_GE(found.likeliest, kMin);
  EXPECT_GE(found.drawn, kMin);
  const Evaluation chance = evaluate(policy::Network(), **courses, how, pool, stop);
  EXPECT_LT(chance.any, 0.05);
}

}  // namespace
}  // namespace obby::train
