// Tests ranks whose options differ from those of the first rank.
#include "train/run/rank_options.h"

#include <gtest/gtest.h>

#include "train/thread_ranks.h"

namespace obby::train {
namespace {

TEST(RankOptions, EqualOptionsAreNoError) {
  ThreadRanks::run(3, [](Ranks& ranks) {
    EXPECT_TRUE(sameOptions({"with --seed 3", "without --style"}, ranks));
  });
}

TEST(RankOptions, TheFirstDifferentOptionOfTheFirstDifferentRankIsNamed) {
  ThreadRanks::run(3, [](Ranks& ranks) {
    std::vector<std::string> options = {"with --decisions 5", "with --seed 3", "without --style"};
    if (ranks.number() == 2) options[1] = "with --seed 4", options[2] = "with --style gaps";
    const Status same = sameOptions(options, ranks);
    ASSERT_FALSE(same);
    EXPECT_EQ(same.error().message.substr(same.error().message.find("started")),
              ranks.number() == 2
                  ? "started with --seed 4, but rank 0 with --seed 3"
                  : "started with --seed 4, but rank 0 with --seed 3 (give all ranks the same "
                    "options and files)");
    EXPECT_EQ(same.error().input, ranks.number() == 2 ? "" : "rank 2");
  });
}

TEST(RankOptions, ARankThatRefusedItsOptionsIsAnErrorOnAll) {
  ThreadRanks::run(2, [](Ranks& ranks) {
    const Status same =
        ranks.first() ? sameOptions({"with --seed 3"}, ranks) : notRunning(true, ranks);
    ASSERT_FALSE(same);
    EXPECT_NE(same.error().text().find("started with options that it refused, but rank 0 to train"),
              std::string::npos)
        << same.error().text();
  });
}

TEST(RankOptions, NoErrorIfNoRankRuns) {
  ThreadRanks::run(2, [](Ranks& ranks) { EXPECT_TRUE(notRunning(false, ranks)); });
}

}  // namespace
}  // namespace obby::train
