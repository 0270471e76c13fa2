// Learning as a whole: it learns, and nothing but its inputs decides what.
#include "train/trainer.h"

#include <gtest/gtest.h>

#include "train/evaluate.h"
#include "train/gaps.h"

namespace obby::train {
namespace {

TEST(Trainer, GivesTheSamePolicyOnAnyNumberOfThreads) {
  const Gaps gaps;
  std::vector<float> expected;
  for (const int threads : {1, 2, 3}) {
    ThreadPool pool(threads);
    const auto trainer = Trainer::make(small(), gaps, pool, alone());
    ASSERT_TRUE(trainer) << trainer.error().text();
    for (int i = 0; i < 4; ++i) ASSERT_TRUE((*trainer)->iterate());
    const std::vector<float> numbers = (*trainer)->network().numbers();
    if (expected.empty()) expected = numbers;
    EXPECT_EQ(numbers, expected) << threads;
  }
}

TEST(Trainer, LearnsToCrossAGapThatChanceDoesNot) {
  const Gaps gaps;
  ThreadPool pool(2);
  const std::atomic<bool> stop{false};
  EvaluationSettings how;
  how.levels = 50;
  how.firstLevel = 1'000'000;
  const auto chance = evaluate(policy::Network(), gaps, how, pool, stop);
  ASSERT_TRUE(chance) << chance.error().text();
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE(trainer);
  for (int i = 0; i < 60; ++i) ASSERT_TRUE((*trainer)->iterate());
  const auto learned = evaluate((*trainer)->network(), gaps, how, pool, stop);
  ASSERT_TRUE(learned);
  EXPECT_EQ(learned->levels, 50u);
  EXPECT_LT(chance->drawn, 0.1);
  EXPECT_GT(learned->drawn, 0.5);
  EXPECT_GT(learned->drawn, 5 * chance->drawn);
  EXPECT_GE(learned->any, learned->likeliest);
}

TEST(Guide, LeftIsAlongTheLineAndToIt) {
  const Guide guide({{0, 0, 0}, {0, 0, -10}, {10, 0, -10}});
  EXPECT_FLOAT_EQ(guide.studs(), 20);
  EXPECT_FLOAT_EQ(guide.left({0, 0, 0}), 20);
  EXPECT_FLOAT_EQ(guide.left({0, 3, -4}), 3 * 3 + 16);
  EXPECT_FLOAT_EQ(guide.left({10, 0, -10}), 0);
  EXPECT_FLOAT_EQ(guide.left({10, 0, -9}), 3) << "a short cut counts";
}

TEST(Guide, TheNextRoundOfASpiralIsNotNearYet) {
  const Guide guide({{0, 0, 0}, {10, 2, 0}, {10, 4, 10}, {0, 6, 10}, {0, 8, 0}, {10, 10, 0}});
  const float whole = guide.studs();
  EXPECT_FLOAT_EQ(guide.left({0, 0, 0}, whole - 5), whole);
  // Straight up from the start, the way that it leads along four sides later.
  EXPECT_LT(guide.left({0, 7, 0}), whole / 2);
  EXPECT_FLOAT_EQ(guide.left({0, 7, 0}, whole - 5),
                  whole - 14 / std::sqrt(104.0f) + 3 * std::sqrt(49 - 196.0f / 104));
  EXPECT_GT(guide.left({-50, 0, 0}, 2 * whole), whole) << "far off there is still a way";
}

TEST(Sums, AreMeanAndDeviation) {
  Sums sums(2);
  const float rows[][2] = {{1, 5}, {3, 5}, {5, 5}};
  for (const auto& row : rows) sums.add(row);
  EXPECT_DOUBLE_EQ(sums.mean(0), 3);
  EXPECT_NEAR(sums.deviation(0), std::sqrt(8.0 / 3), 1e-12);
  EXPECT_DOUBLE_EQ(sums.deviation(1), 0);
}

}  // namespace
}  // namespace obby::train
