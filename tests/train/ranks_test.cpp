// Several ranks train one network. The result depends only on their number.
#include "train/ranks.h"

#include <gtest/gtest.h>

#include "train/checkpoint.h"
#include "train/evaluate.h"
#include "train/gaps.h"
#include "train/thread_ranks.h"

namespace obby::train {
namespace {

TEST(Ranks, SumsAreInRankOrder) {
  // In another order this sum is 0 or 2.
  const float values[] = {1e8f, 1, -1e8f, 1};
  ThreadRanks::run(4, [&](Ranks& ranks) {
    float v[] = {values[ranks.number()], float(ranks.number())};
    ranks.add(v);
    EXPECT_EQ(v[0], ((1e8f + 1) + -1e8f) + 1);
    EXPECT_EQ(v[1], 6);
  });
}

TEST(Ranks, EveryRankReturnsTheFirstError) {
  ThreadRanks::run(3, [](Ranks& ranks) {
    EXPECT_TRUE(ranks.agree(Status()));
    const Status mine = ranks.number() == 0 ? Status() : Status(makeError("too dark"));
    const Status all = ranks.agree(Status(mine));
    ASSERT_FALSE(all);
    EXPECT_EQ(all.error().text(), ranks.number() == 1 ? "too dark" : "rank 1: too dark");
  });
}

struct RanksLearned {
  std::vector<float> numbers;
  Iteration last;
  std::string checkpoint;  // checkpoint after the third iteration
};

// Returns the first rank's result of six iterations. `from` is a checkpoint after the third, or
// empty.
RanksLearned ranksLearn(uint32_t count, const std::string& from = {}) {
  const Gaps gaps(true);
  RanksLearned out;
  ThreadRanks::run(count, [&](Ranks& ranks) {
    ThreadPool pool(1);
    auto trainer = from.empty() ? Trainer::make(small(), gaps, pool, ranks)
                                : Trainer::resume(small(), gaps, pool, ranks,
                                                  std::move(readCheckpoint(from, "test")->state));
    ASSERT_TRUE(trainer) << trainer.error().text();
    Iteration last;
    for (uint64_t i = (*trainer)->iterations(); i < 6; ++i) {
      last = *(*trainer)->iterate();
      if (i != 2) continue;
      const TrainerState state = *(*trainer)->state();
      if (ranks.first()) out.checkpoint = writeCheckpoint({"1", {}, 0, state});
    }
    if (ranks.first()) {
      out.numbers = (*trainer)->network().numbers();
      out.last = last;
    }
  });
  return out;
}

TEST(Ranks, OneRankTrainsAsAProcessWithoutRanks) {
  const Gaps gaps(true);
  ThreadPool pool(2);
  const auto trainer = Trainer::make(small(), gaps, pool, alone());
  for (int i = 0; i < 6; ++i) ASSERT_TRUE((*trainer)->iterate());
  EXPECT_EQ(ranksLearn(1).numbers, (*trainer)->network().numbers());
}

TEST(Ranks, TwoRanksAreReproducibleAndDifferFromOne) {
  const RanksLearned one = ranksLearn(1), two = ranksLearn(2), again = ranksLearn(2);
  EXPECT_EQ(two.numbers, again.numbers);
  EXPECT_NE(two.numbers, one.numbers);
  EXPECT_EQ(two.last.decisions, 2 * one.last.decisions);
  EXPECT_EQ(two.last.reward, again.last.reward);
}

TEST(Ranks, AResumedRunHasTheSameBits) {
  const RanksLearned whole = ranksLearn(2), broken = ranksLearn(2, whole.checkpoint);
  EXPECT_EQ(broken.numbers, whole.numbers);
  EXPECT_EQ(broken.last.reward, whole.last.reward);
  const Gaps gaps(true);
  ThreadPool pool(1);
  EXPECT_FALSE(Trainer::resume(small(), gaps, pool, alone(),
                               std::move(readCheckpoint(whole.checkpoint, "test")->state)))
      << "one rank, but the checkpoint is of two";
}

TEST(Ranks, TwoRanksLearnToCrossAGap) {
  const Gaps gaps;
  ThreadRanks::run(2, [&](Ranks& ranks) {
    ThreadPool pool(1);
    const auto trainer = Trainer::make(small(), gaps, pool, ranks);
    for (int i = 0; i < 30; ++i) ASSERT_TRUE((*trainer)->iterate());
    if (!ranks.first()) return;
    EvaluationSettings how;
    how.levels = 50;
    how.firstLevel = 1'000'000;
    const std::atomic<bool> stop{false};
    const Evaluation learned = evaluate((*trainer)->network(), gaps, how, pool, stop);
    EXPECT_GT(learned.drawn, 0.5);
  });
}

// Levels, one of which is bad.
class Bad : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    if (index == 11) return makeError("level 11 is bad");
    return Gaps::level(index, hardest);
  }
};

TEST(Ranks, AllRanksEndWhenOneFails) {
  const Bad bad;
  ThreadRanks::run(2, [&](Ranks& ranks) {
    ThreadPool pool(1);
    const auto trainer = Trainer::make(small(), bad, pool, ranks);
    ASSERT_FALSE(trainer);
    EXPECT_NE(trainer.error().text().find("level 11 is bad"), std::string::npos);
  });
}

}  // namespace
}  // namespace obby::train
