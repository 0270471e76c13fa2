// The statistics of bench_solve against values computed by hand.
#include "suite/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace obby::bench {
namespace {

using ::testing::ElementsAre;

Timing solvedIn(double seconds) { return {seconds, true, 0, 0}; }
const Timing kUnsolved{90, false, 0, 0};

TEST(Statistics, MeanOfNoRunsIsNaN) { EXPECT_TRUE(std::isnan(mean({}))); }

TEST(Statistics, UnsolvedRunsCountTheCapForThePaperAndTwiceTheCapForPar2) {
  EXPECT_EQ(cappedSeconds(solvedIn(3), 90), 3);
  EXPECT_EQ(par2(solvedIn(3), 90), 3);
  EXPECT_EQ(cappedSeconds(kUnsolved, 90), 90);
  EXPECT_EQ(par2(kUnsolved, 90), 180);
}

TEST(Statistics, ASolutionAfterTheCapDoesNotCount) {
  EXPECT_EQ(cappedSeconds(solvedIn(95), 90), 90);
  EXPECT_EQ(par2(solvedIn(95), 90), 180);
}

TEST(Statistics, ThirdsAreEquallyLargeAlsoAmongEqualKeys) {
  EXPECT_THAT(thirds({5, 1, 9, 7, 3, 8}), ElementsAre(1, 0, 2, 1, 0, 2));
  EXPECT_THAT(thirds({1, 1, 1}), ElementsAre(0, 1, 2));
  EXPECT_THAT(thirds({}), ElementsAre());
}

TEST(Statistics, BootstrapIntervalHoldsTheValueAndIsTheSameEveryTime) {
  const std::vector<double> groups = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const GroupStatistic meanOf = [&](const std::vector<size_t>& picks) {
    std::vector<double> values;
    for (const size_t pick : picks) values.push_back(groups[pick]);
    return mean(values);
  };
  const Interval first = bootstrap(groups.size(), meanOf),
                 second = bootstrap(groups.size(), meanOf);
  // The normal approximation gives 5.5 -+ 1.96 x 2.87 / sqrt(10) for a mean of ten values.
  EXPECT_NEAR(first.low, 3.72, 0.3);
  EXPECT_NEAR(first.high, 7.28, 0.3);
  EXPECT_EQ(first.low, second.low);
  EXPECT_EQ(first.high, second.high);
}

TEST(Statistics, BootstrapOfNoRunsIsNaN) {
  EXPECT_TRUE(std::isnan(bootstrap(0, [](const std::vector<size_t>&) { return 1.0; }).low));
}

}  // namespace
}  // namespace obby::bench
