// Learning as a whole: it learns, and nothing but its inputs decides what.
#include "train/trainer.h"

#include <gtest/gtest.h>

#include "support/level_builder.h"
#include "train/evaluate.h"

namespace obby::train {
namespace {

// A gap of four to seven studs between two floors, a goal behind it.
class Gaps : public LevelSource {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float) const override {
    Random random(99, index);
    const float gap = 4 + 3 * random.unit(), far = -8 - gap;
    support::LevelBuilder b;
    b.block({0, -0.5f, -3}, {8, 1, 10});  // to z = -8
    b.block({0, -0.5f, far - 4}, {8, 1, 8});
    b.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-30); });
    b.spawn({0, 0, 0});
    capnp::MallocMessageBuilder query;
    auto q = query.initRoot<schema::Query>();
    q.setId("across");
    support::set(q.initGoal().initPosition(), {0, 2, far - 5});
    support::set(q.getGoal().initSize(), {8, 4, 4});
    return TrainingLevel::make(b.record(), q.asReader(), {});
  }
};

TrainerSettings small() {
  TrainerSettings s;
  s.crowds = 2;
  s.crowd.levels = 4;
  s.crowd.worlds = 32;
  s.ppo.part = 1024;
  s.ppo.rate = 2e-3f;
  s.ppo.loss.entropyShare = 0.005f;
  s.decisions = 2'000'000;
  return s;
}

TEST(Trainer, GivesTheSamePolicyOnAnyNumberOfThreads) {
  const Gaps gaps;
  std::vector<float> expected;
  for (const int threads : {1, 2, 3}) {
    ThreadPool pool(threads);
    const auto trainer = Trainer::make(small(), gaps, pool);
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
  const auto trainer = Trainer::make(small(), gaps, pool);
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
