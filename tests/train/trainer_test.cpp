// Training as a whole: it learns, and its result depends only on its inputs.
#include "train/trainer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <mutex>

#include "train/evaluate.h"
#include "train/gaps.h"

namespace obby::train {
namespace {

TEST(Trainer, ThePolicyDoesNotDependOnTheNumberOfThreads) {
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

TEST(Trainer, LearnsToCrossAGapThatRandomPlayDoesNot) {
  const Gaps gaps;
  ThreadPool pool(2);
  const std::atomic<bool> stop{false};
  EvaluationSettings how;
  how.levels = 50;
  how.firstLevel = 1'000'000;
  const Evaluation chance = evaluate(policy::Network(), gaps, how, pool, stop);
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE(trainer);
  for (int i = 0; i < 30; ++i) ASSERT_TRUE((*trainer)->iterate());
  const Evaluation learned = evaluate((*trainer)->network(), gaps, how, pool, stop);
  EXPECT_EQ(learned.levels, 50u);
  EXPECT_LT(chance.drawn, 0.1);
  EXPECT_GT(learned.drawn, 0.9);
  EXPECT_GT(learned.drawn, 5 * chance.drawn);
  EXPECT_GE(learned.any, learned.likeliest);
}

// Training evaluates each decision with the network, mask and inputs of the play. In a single step
// over the whole batch, the policy has therefore not moved yet.
TEST(Trainer, TheFirstStepSeesThePolicyThatPlayed) {
  const Gaps gaps;
  ThreadPool pool(1);
  TrainerSettings settings = tiny();
  settings.ppo.epochs = 1;
  settings.ppo.minibatch = settings.worlds() * settings.ticks;
  const auto trainer = Trainer::make(settings, gaps, pool, alone());
  ASSERT_TRUE(trainer);
  for (int i = 0; i < 4; ++i) {
    const auto iteration = (*trainer)->iterate();
    ASSERT_TRUE(iteration);
    EXPECT_NEAR(iteration->progress.approxKl, 0, 1e-6) << i;
    EXPECT_EQ(iteration->progress.clipFraction, 0) << i;
    EXPECT_GT(iteration->progress.entropy, 2) << i;
  }
}

// An engine that neither plays nor trains, but records the learning rates.
class Rated : public Engine {
 public:
  Rated(std::vector<float>& rates, size_t envGroups) : rates_(rates), envGroups_(envGroups) {}

  Status begin(float) override { return {}; }
  Status restore(const LearnerState&, std::span<EnvGroupState>) override { return {}; }
  Status setLearner(const LearnerState&) override { return {}; }
  Result<Played> play(const PlayOrder&) override { return Played{}; }
  Result<Progress> learn(float rate) override {
    rates_.push_back(rate);
    return Progress{};
  }
  Result<LearnerState> learner() const override { return LearnerState{}; }
  Result<std::vector<EnvGroupState>> envGroups() const override {
    return std::vector<EnvGroupState>(envGroups_);
  }

 private:
  std::vector<float>& rates_;
  size_t envGroups_;
};

// The learning rate falls to a tenth at --decisions and stays there. A resumed run continues at its
// rate.
TEST(Trainer, TheLearningRateFallsWithTheDecisions) {
  TrainerSettings settings = small();
  settings.decisions = 4 * uint64_t(settings.worlds()) * settings.ticks;
  std::vector<float> rates;
  auto trainer =
      Trainer::make(settings, std::make_unique<Rated>(rates, settings.envGroups), alone());
  ASSERT_TRUE(trainer);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE((*trainer)->iterate());
  TrainerState state = *(*trainer)->state();
  trainer = Trainer::resume(settings, std::make_unique<Rated>(rates, settings.envGroups), alone(),
                            std::move(state));
  ASSERT_TRUE(trainer) << trainer.error().text();
  for (int i = 0; i < 4; ++i) ASSERT_TRUE((*trainer)->iterate());
  const float expected[] = {1, 0.775f, 0.55f, 0.325f, 0.1f, 0.1f};
  ASSERT_EQ(rates.size(), std::size(expected));
  for (size_t i = 0; i < rates.size(); ++i) EXPECT_NEAR(rates[i], expected[i], 1e-6f) << i;
}

// A source of gaps that records the requested difficulty.
class Asked : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    std::lock_guard lock(mutex_);
    hardest_ = std::max(hardest_, hardest);
    return Gaps::level(index, hardest);
  }
  float hardest() const { return hardest_; }

 private:
  mutable std::mutex mutex_;
  mutable float hardest_ = 0;
};

// Returns the change of the difficulty after an iteration. It is smaller after few episodes.
float stepAfter(const Iteration& i) { return 0.01f * std::min(float(i.played) / 64, 1.0f); }

TrainerSettings from(float easiest, float raiseAt, float lowerAt) {
  TrainerSettings settings = small();
  settings.easiest = easiest;
  settings.raiseAt = raiseAt;
  settings.lowerAt = lowerAt;
  return settings;
}

TEST(Curriculum, LevelsBecomeHarderWhileTheSolvedShareIsHigh) {
  const Asked gaps;
  ThreadPool pool(1);
  TrainerSettings settings = from(0.3f, -1, -1);
  settings.envGroup.episodes = 8;
  const auto trainer = Trainer::make(settings, gaps, pool, alone());
  ASSERT_TRUE(trainer);
  EXPECT_EQ(gaps.hardest(), 0.3f);
  float expected = 0.3f;
  for (int i = 0; i < 6; ++i) {
    const auto iteration = (*trainer)->iterate();
    ASSERT_TRUE(iteration);
    expected += stepAfter(*iteration);
    EXPECT_NEAR(iteration->hardest, expected, 1e-5f) << i;
  }
  EXPECT_GT(expected, 0.33f);
  EXPECT_GT(gaps.hardest(), 0.3f) << "levels were requested with it";
}

TEST(Curriculum, LevelsBecomeEasierWhileTheSolvedShareIsLow) {
  const Gaps gaps;
  ThreadPool pool(1);
  const TrainerSettings settings = from(0.3f, 3, 2);
  auto trainer = Trainer::make(settings, gaps, pool, alone());
  TrainerState state = *(*trainer)->state();
  state.hardest = 0.5f;
  trainer = Trainer::resume(settings, gaps, pool, alone(), std::move(state));
  ASSERT_TRUE(trainer);
  float before = 0.5f;
  for (int i = 0; i < 4; ++i) {
    const auto iteration = (*trainer)->iterate();
    EXPECT_NEAR(iteration->hardest, before - stepAfter(*iteration), 1e-5f);
    before = iteration->hardest;
  }
  EXPECT_LT(before, 0.5f);
}

// A few worlds end only a few episodes in an iteration. These episodes also count.
TEST(Curriculum, MovesEvenWithFewWorlds) {
  const Gaps gaps;
  ThreadPool pool(1);
  TrainerSettings settings = tiny();
  settings.envGroups = 1;
  settings.raiseAt = settings.lowerAt = -1;
  const auto trainer = Trainer::make(settings, gaps, pool, alone());
  float hardest = settings.easiest;
  for (int i = 0; i < 8; ++i) {
    const auto iteration = (*trainer)->iterate();
    EXPECT_LT(iteration->played, 64u);
    hardest = iteration->hardest;
  }
  EXPECT_GT(hardest, settings.easiest);
}

// If training did not stop, a policy file with NaN could replace a good one.
TEST(Trainer, StopsOnceItHasDiverged) {
  const Gaps gaps;
  ThreadPool pool(1);
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  ASSERT_TRUE((*trainer)->iterate());
  const auto error = [&](auto&& spoil) {
    TrainerState state = *(*trainer)->state();
    spoil(state);
    const auto resumed = Trainer::resume(small(), gaps, pool, alone(), std::move(state));
    EXPECT_TRUE(resumed);
    const auto iteration = (*resumed)->iterate();
    return iteration ? std::string() : iteration.error().text();
  };
  // A checkpoint resumes only with its own learning rate, and then diverges again with the same
  // bits.
  const std::string diverged =
      "training diverged: the network's weights are no longer finite (start again "
      "with a lower --learning-rate; resuming the last checkpoint would diverge again)";
  EXPECT_EQ(error([](TrainerState&) {}), "");
  EXPECT_EQ(error([](TrainerState& s) { s.learner.parameters[20000] = NAN; }), diverged);
  EXPECT_EQ(error([](TrainerState& s) { s.learner.squares[18500] = INFINITY; }), diverged);
  EXPECT_EQ(error([](TrainerState& s) { s.seen.sum[7] = NAN; }), diverged);
}

TEST(Sums, HaveMeanAndDeviation) {
  Sums sums(2);
  const float rows[][2] = {{1, 5}, {3, 5}, {5, 5}};
  for (const auto& row : rows) sums.add(row);
  EXPECT_DOUBLE_EQ(sums.mean(0), 3);
  EXPECT_NEAR(sums.deviation(0), std::sqrt(8.0 / 3), 1e-12);
  EXPECT_DOUBLE_EQ(sums.deviation(1), 0);
}

}  // namespace
}  // namespace obby::train
