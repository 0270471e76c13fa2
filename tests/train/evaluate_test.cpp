// A policy is judged by all levels that there are, whatever is wrong with others.
#include "train/evaluate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

#include "train/gaps.h"

namespace obby::train {
namespace {

Evaluation judged(const LevelSource& source, const EvaluationSettings& how, int threads) {
  ThreadPool pool(threads);
  const std::atomic<bool> stop{false};
  return evaluate(policy::Network(), source, how, pool, stop);
}

EvaluationSettings ofLevels(uint32_t levels) {
  EvaluationSettings how;
  how.levels = levels;
  how.tries = 1;
  return how;
}

class SomeBad : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    if (index % 4 == 3) return makeError(fmt::format("level {} is bad", index));
    return Gaps::level(index, hardest);
  }
};

TEST(Evaluation, CountsWhatIsPlayedBesideBadLevels) {
  for (const int threads : {1, 3}) {
    const Evaluation e = judged(SomeBad(), ofLevels(10), threads);
    EXPECT_EQ(e.levels, 8u) << threads;
    ASSERT_FALSE(e.missing);
    EXPECT_EQ(e.missing.error().text(), "level 3 is bad");
  }
  EXPECT_TRUE(judged(Gaps(), ofLevels(3), 1).missing);
}

TEST(Evaluation, EndsOnceItsTimeIsUp) {
  EvaluationSettings how = ofLevels(1000);
  how.seconds = 0;
  const Evaluation none = judged(Gaps(), how, 2);
  EXPECT_EQ(none.levels, 0u);
  EXPECT_TRUE(none.timeUp);
  EXPECT_FALSE(judged(Gaps(), ofLevels(3), 2).timeUp);
}

// Levels that know what they were told of.
class Watched : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    {
      const std::lock_guard hold(lock_);
      EXPECT_GE(index, past_) << "was past";
    }
    return Gaps::level(index, hardest);
  }
  void past(uint64_t index) const override {
    const std::lock_guard hold(lock_);
    past_ = std::max(past_, index);
  }
  uint64_t firstLeft() const { return past_; }

 private:
  mutable std::mutex lock_;
  mutable uint64_t past_ = 0;
};

TEST(Evaluation, TellsTheSourceWhatIsPast) {
  for (const int threads : {1, 3}) {
    const Watched levels;
    EvaluationSettings how = ofLevels(12);
    how.firstLevel = 5;
    EXPECT_EQ(judged(levels, how, threads).levels, 12u);
    EXPECT_EQ(levels.firstLeft(), 17u) << threads;
  }
}

}  // namespace
}  // namespace obby::train
