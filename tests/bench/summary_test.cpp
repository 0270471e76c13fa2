// The report's figures from a handful of runs.
#include "suite/summary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "suite/curve.h"
#include "suite/table.h"

namespace obby::bench {
namespace {

Run ran(const char* verdict, double seconds) {
  Run run;
  run.verdict = verdict;
  run.timing = {seconds, run.verdict == "solved", 1000, 10};
  return run;
}

// Returns results of three queries with a solution and two without. `auto` answers all of them, and
// `ge` misses the hardest.
Results example() {
  Results r;
  r.cap = 10;
  r.methods = {"auto", "ge"};
  r.queries = {{"a:easy", "solved", 1},
               {"a:hard", "solved", 9},
               {"a:middle", "solved", 5},
               {"a:none", "unreachable", 3},
               {"a:never", "unsolved", 3}};
  r.runs = {{{ran("solved", 1)},
             {ran("solved", 3)},
             {ran("solved", 2)},
             {ran("unreachable", 0)},
             {ran("unknown", 2)}},
            {{ran("solved", 4)}, {ran("unknown", 10)}, {ran("solved", 6)}, {}, {}}};
  return r;
}

double figure(const Results& results, const std::string& method, const std::string& metric) {
  const std::vector<Measure> measures = summarise(results);
  if (const Measure* const found = findMeasure(measures, method, metric)) return found->value;
  ADD_FAILURE() << method << " has no " << metric;
  return std::nan("");
}

TEST(Summary, SharesAndTimesAreOfTheQueriesThatHaveASolution) {
  const Results r = example();
  EXPECT_DOUBLE_EQ(figure(r, "auto", "queries"), 3);
  EXPECT_DOUBLE_EQ(figure(r, "auto", "solvedShare1"), 1.0 / 3);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "solvedShare10"), 2.0 / 3);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "solvedShare90"), 2.0 / 3);
  EXPECT_DOUBLE_EQ(figure(r, "auto", "medianSeconds"), 2);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "meanSeconds"), 20.0 / 3);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "par2Seconds"), 10);
}

TEST(Summary, RatioSaysHowManyTimesBetterThanGe) {
  EXPECT_DOUBLE_EQ(figure(example(), "auto", "par2RatioToGe"), 5);
  EXPECT_DOUBLE_EQ(figure(example(), "ge", "par2RatioToGe"), 1);
}

TEST(Summary, RatioIsOverTheCommonQueries) {
  Results r = example();
  r.runs[1][1].clear();
  EXPECT_DOUBLE_EQ(figure(r, "auto", "par2RatioToGe"), (4.0 + 6) / (1 + 2));
}

TEST(Summary, ThirdsByEffortDoNotDependOnTheMethod) {
  const Results r = example();
  EXPECT_DOUBLE_EQ(figure(r, "auto", "hardThirdMeanSeconds"), 3);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "hardThirdMeanSeconds"), 10);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "hardThirdSolvedShare"), 0);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "easyThirdMeanSeconds"), 4);
}

TEST(Summary, ThirdsByGeAreByItsTime) {
  const Results r = example();
  EXPECT_DOUBLE_EQ(figure(r, "auto", "geShortMeanSeconds"), 1);
  EXPECT_DOUBLE_EQ(figure(r, "auto", "geLongMeanSeconds"), 3);
}

TEST(Summary, TheLastThirdsPenaliseUnsolvedQueries) {
  const Results r = example();
  EXPECT_DOUBLE_EQ(figure(r, "ge", "hardThirdPar2Seconds"), 20);
  EXPECT_DOUBLE_EQ(figure(r, "ge", "geLongPar2Seconds"), 20);
  EXPECT_DOUBLE_EQ(figure(r, "auto", "geLongPar2Seconds"), 3);
}

TEST(Summary, ThePictureHasABarForEachMethodAndThird) {
  const auto bars = [](const Results& r) {
    const std::string svg = suiteSvg(r, summarise(r));
    size_t count = 0;
    for (size_t at = 0; (at = svg.find("<rect x=", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  Results r = example();
  EXPECT_EQ(bars(r), 6u);
  for (auto& runs : r.runs[0]) runs.clear();
  EXPECT_EQ(bars(r), 3u) << "no bars for what has no runs";
  r.methods = {"auto", "beam"};
  EXPECT_EQ(bars(r), 0u) << "thirds are by ge";
}

TEST(Summary, EveryQueryWeighsTheSameHoweverManySeeds) {
  Results r = example();
  r.runs[0][0] = {ran("solved", 1), ran("solved", 1), ran("solved", 1)};
  EXPECT_DOUBLE_EQ(figure(r, "auto", "meanSeconds"), 2);
}

TEST(Summary, FalseVerdictsAreSolvedWithoutASolutionAndUnreachableWithOne) {
  Results r = example();
  EXPECT_EQ(figure(r, "auto", "falseVerdicts"), 0);
  r.runs[0][3] = {ran("solved", 1)};
  r.runs[0][1] = {ran("unreachable", 0), ran("unknown", 10)};
  EXPECT_EQ(figure(r, "auto", "falseVerdicts"), 2);
  EXPECT_EQ(figure(r, "auto", "provedShare"), 0);
}

TEST(Summary, AMethodWithoutRunsHasNoFigures) {
  Results r = example();
  for (auto& runs : r.runs[1]) runs.clear();
  EXPECT_TRUE(std::isnan(figure(r, "ge", "par2Seconds")));
  EXPECT_NE(tableText(r.methods, summarise(r)).find("par2Seconds"), std::string::npos);
  EXPECT_NE(suiteSvg(r, summarise(r)).find("</svg>"), std::string::npos);
}

TEST(Summary, SlowestQueriesComeFirst) {
  const std::string text = slowest(example(), 1, 2);
  EXPECT_LT(text.find("a:hard"), text.find("a:middle"));
  EXPECT_EQ(text.find("a:easy"), std::string::npos);
}

}  // namespace
}  // namespace obby::bench
