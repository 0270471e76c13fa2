// Levels of input streams, on one rank and on several.
#include "train/run/streamed_levels.h"

#include <gtest/gtest.h>

#include "train/level_lines.h"
#include "train/standing.h"
#include "train/thread_ranks.h"

namespace obby::train {
namespace {

TEST(StreamedLevels, EveryRankHasTheFirstRanksLevels) {
  const LevelStream all(optionsOf(linesOf(4)));
  ThreadRanks::run(3, [&](Ranks& ranks) {
    const std::atomic<bool> interrupted{false};
    Timeout timeout(interrupted, Timeout::kNone);
    const auto levels = streamedLevels(ranks.first() ? optionsOf(linesOf(4)) : io::SourceOptions(),
                                       ranks, true, timeout);
    ASSERT_TRUE(levels) << levels.error().text();
    for (uint64_t i = 0; i < 6; ++i) EXPECT_EQ(hashOf(*levels->stream, i), hashOf(all, i)) << i;
  });
}

TEST(StreamedLevels, WithoutAgainEachLevelIsPlayedOnce) {
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, Timeout::kNone);
  OneRank one;
  const auto levels = streamedLevels(optionsOf(linesOf(2)), one, false, timeout);
  ASSERT_TRUE(levels) << levels.error().text();
  EXPECT_NE(hashOf(*levels->stream, 1), 0u);
  const auto none = levels->source->level(2, 1);
  ASSERT_TRUE(none) << none.error().text();
  EXPECT_EQ(*none, nullptr);
}

// With several ranks, the whole stream must be read first.
TEST(StreamedLevels, AStreamThatSendsNothingIsAnErrorOnEveryRank) {
  ThreadRanks::run(2, [](Ranks& ranks) {
    const std::atomic<bool> interrupted{false};
    Timeout timeout(interrupted, 0.05, 0.05);
    const Standing standing(kHeaderLine + lineOf(0));
    const auto levels = streamedLevels(standing.options(timeout), ranks, true, timeout);
    ASSERT_FALSE(levels);
    EXPECT_NE(levels.error().text().find("too few levels arrived"), std::string::npos)
        << levels.error().text();
  });
}

}  // namespace
}  // namespace obby::train
