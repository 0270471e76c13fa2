// Training that starts from a policy. Until the first update it plays like the policy. Policies
// that cannot be trained further are refused.
#include "train/start.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "policy/shipped_policy.h"
#include "sim/host_device.h"
#include "train/device/device_engine.h"
#include "train/gaps.h"
#include "train/thread_ranks.h"

namespace obby::train {
namespace {

using Trainers = Result<std::unique_ptr<Trainer>>;

constexpr uint64_t kIterations = 3;  // iterations in which the policy is trained

policy::PolicyFile fileOf(const TrainerState& state, const Trainer& trainer) {
  policy::PolicyFile file;
  file.network = trainer.network();
  file.training.decisions = allDecisions(state);
  file.values = {state.learner.values.mean, state.learner.values.deviation};
  return file;
}

// A trained policy, and the state of its training.
struct StartLearned {
  TrainerState state;
  policy::PolicyFile file;
};

StartLearned learned() {
  const Gaps gaps;
  ThreadPool pool(1);
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  for (uint64_t i = 0; i < kIterations; ++i) EXPECT_TRUE((*trainer)->iterate());
  TrainerState state = *(*trainer)->state();
  policy::PolicyFile file = fileOf(state, **trainer);
  return {std::move(state), std::move(file)};
}

// Returns settings with another seed.
TrainerSettings further() {
  TrainerSettings settings = small();
  settings.seed = 5;
  return settings;
}

Trainers beginWith(const Start* start, const LevelSource& source, ThreadPool& pool, Ranks& ranks) {
  const TrainerSettings settings = further();
  return Trainer::make(settings, makeCpuEngine(settings, source, pool, ranks), ranks, start);
}

// Equal networks suffice: a test of Pass shows that training and search compute the same logits,
// bit for bit.
TEST(Start, IsThePolicyBitForBitUntilTheFirstUpdate) {
  const StartLearned known = learned();
  const Gaps others(false, 98);
  ThreadPool pool(1);
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start) << start.error().text();
  const auto trainer = beginWith(&*start, others, pool, alone());
  ASSERT_TRUE(trainer) << trainer.error().text();
  EXPECT_EQ((*trainer)->network().numbers(), known.file.network.numbers());
  EXPECT_EQ((*trainer)->decisions(), 0u);
  ASSERT_TRUE((*trainer)->iterate());
  EXPECT_NE((*trainer)->network().numbers(), known.file.network.numbers());
}

TEST(Start, EqualsThePolicyBitForBitOnADevice) {
  const StartLearned known = learned();
  const Gaps gaps;
  ThreadPool pool(1);
  sim::HostDevice device(pool);
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start);
  const TrainerSettings settings = further();
  const auto trainer = Trainer::make(
      settings, makeDeviceEngine(settings, gaps, device, pool, alone()), alone(), &*start);
  ASSERT_TRUE(trainer) << trainer.error().text();
  EXPECT_EQ((*trainer)->network().numbers(), known.file.network.numbers());
  ASSERT_TRUE((*trainer)->iterate());
  EXPECT_NE((*trainer)->network().numbers(), known.file.network.numbers());
}

// Training starts with the policy's network, value scale and normalisers. A run that resumes from a
// state with these gives the same results.
TEST(Start, DecidesTheFirstIteration) {
  const StartLearned known = learned();
  const Gaps gaps;
  ThreadPool pool(1);
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start);
  const auto trainer = beginWith(&*start, gaps, pool, alone());
  const auto fresh = beginWith(nullptr, gaps, pool, alone());
  ASSERT_TRUE(trainer && fresh);
  TrainerState state = *(*fresh)->state();
  state.learner = start->learner;
  state.seen = start->seen;
  const auto expected = Trainer::resume(further(), gaps, pool, alone(), std::move(state));
  ASSERT_TRUE(expected) << expected.error().text();
  for (int i = 0; i < 2; ++i) {
    const auto a = (*trainer)->iterate(), b = (*expected)->iterate(), c = (*fresh)->iterate();
    ASSERT_TRUE(a && b && c);
    EXPECT_EQ(a->reward, b->reward) << i;
    EXPECT_NE(a->reward, c->reward) << i;
  }
  EXPECT_EQ((*trainer)->network().numbers(), (*expected)->network().numbers());
}

TEST(Start, ThePolicyDoesNotDependOnTheNumberOfThreads) {
  const StartLearned known = learned();
  const Gaps gaps;
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start);
  std::vector<float> expected;
  for (const int threads : {1, 2, 3}) {
    ThreadPool pool(threads);
    const auto trainer = beginWith(&*start, gaps, pool, alone());
    ASSERT_TRUE(trainer);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE((*trainer)->iterate());
    const std::vector<float> numbers = (*trainer)->network().numbers();
    if (expected.empty()) expected = numbers;
    EXPECT_EQ(numbers, expected) << threads;
  }
}

// Each iteration checks that all ranks have the same network.
TEST(Start, IsTheSameOnAllRanks) {
  const StartLearned known = learned();
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start);
  ThreadRanks::run(2, [&](Ranks& ranks) {
    const Gaps gaps;
    ThreadPool pool(1);
    const auto trainer = beginWith(&*start, gaps, pool, ranks);
    ASSERT_TRUE(trainer);
    EXPECT_EQ((*trainer)->network().numbers(), known.file.network.numbers());
    const auto iteration = (*trainer)->iterate();
    EXPECT_TRUE(iteration) << iteration.error().text();
  });
}

// The normalisers keep the policy's statistics and add to them.
TEST(Start, NormalisersContinue) {
  const StartLearned known = learned();
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->seen.rows, known.state.seen.rows);
  EXPECT_EQ(allDecisions(known.state), known.state.decisions);
  for (size_t i = 0; i < start->seen.sum.size(); ++i) {
    const double deviation = std::max(known.state.seen.deviation(i), double(kMinDeviation));
    EXPECT_NEAR(start->seen.mean(i), known.state.seen.mean(i), 1e-6) << i;
    EXPECT_NEAR(start->seen.deviation(i), deviation, 1e-6 * deviation) << i;
  }
  const Gaps gaps;
  ThreadPool pool(1);
  const auto trainer = beginWith(&*start, gaps, pool, alone());
  ASSERT_TRUE(trainer);
  ASSERT_TRUE((*trainer)->iterate());
  EXPECT_EQ(allDecisions(*(*trainer)->state()), known.state.decisions + (*trainer)->decisions());
}

TEST(Start, RestoresTheValueScaleIfTheFileHasIt) {
  StartLearned known = learned();
  const ValueScale& then = known.state.learner.values;
  const auto start = startFrom(known.file);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->learner.values.mean, then.mean);
  EXPECT_EQ(start->learner.values.deviation, then.deviation);
  EXPECT_NE(then.deviation, ValueScale().deviation);
  known.file.values = {};  // as in the file of an older version
  const auto older = startFrom(known.file);
  ASSERT_TRUE(older);
  EXPECT_EQ(older->learner.values.mean, ValueScale().mean);
  EXPECT_EQ(older->learner.values.deviation, ValueScale().deviation);
}

// Checks the round trip with the numbers of a long run.
TEST(Start, KeepsTheShippedPolicy) {
  const policy::PolicyFile& file = policy::shippedPolicy();
  const auto start = startFrom(file);
  ASSERT_TRUE(start) << start.error().text();
  const Gaps gaps;
  ThreadPool pool(1);
  const auto trainer = beginWith(&*start, gaps, pool, alone());
  ASSERT_TRUE(trainer);
  EXPECT_EQ((*trainer)->network().numbers(), file.network.numbers());
}

// Tests all deviations that a float can hold.
TEST(Start, RestoresEveryScaleOfANormaliser) {
  policy::PolicyFile file;
  file.training.decisions = 1'000'000;
  Random random(3, 3);
  for (int round = 0; round < 100; ++round) {
    for (size_t i = 0; i < size_t(policy::kInputs); ++i) {
      file.network.numbers()[i] = 20 * random.unit() - 10;
      file.network.numbers()[size_t(policy::kInputs) + i] = scaleOf(4 * double(random.unit()));
    }
    ASSERT_TRUE(startFrom(file)) << round;
  }
}

TEST(Start, RefusesNormalisersThatTrainingCannotProduce) {
  const StartLearned known = learned();
  const auto error = [&](float scale) {
    policy::PolicyFile file = known.file;
    file.network.numbers()[size_t(policy::kInputs) + 40] = scale;
    const auto start = startFrom(file);
    return start ? std::string() : start.error().text();
  };
  EXPECT_EQ(error(1), "");
  for (const float scale : {0.0f, -1.0f, 51.0f}) {
    EXPECT_EQ(error(scale),
              "the policy's normalisers are not valid for further training (name a policy that "
              "obby-train wrote)")
        << scale;
  }
}

}  // namespace
}  // namespace obby::train
