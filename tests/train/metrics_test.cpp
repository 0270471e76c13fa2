// Tests the metrics of an evaluation.
#include "train/run/metrics.h"

#include <gtest/gtest.h>

namespace obby::train {
namespace {

std::vector<std::string> namesOf(const std::vector<Metric>& metrics) {
  std::vector<std::string> names;
  for (const Metric& m : metrics) names.push_back(m.name);
  return names;
}

Evaluation evaluationOf(std::vector<Solved> kinds) {
  Evaluation e;
  e.levels = 10;
  e.likeliest = 0.5;
  e.kinds = std::move(kinds);
  return e;
}

const std::vector<std::string> kKinds = {"", "gaps", "spinner"};

TEST(EvaluationMetrics, OneKindHasOnlyTheTotals) {
  const auto metrics = evaluationMetrics(evaluationOf({{}, {10, 0.5}}), 8, kKinds);
  EXPECT_EQ(namesOf(metrics),
            (std::vector<std::string>{"levels", "solvedLikeliest", "solvedDrawn", "solvedAny"}));
  EXPECT_EQ(metrics[0].value, 10);
  EXPECT_EQ(metrics[1].value, 0.5);
}

TEST(EvaluationMetrics, ASingleTryHasNoSampledEpisodes) {
  EXPECT_EQ(namesOf(evaluationMetrics(evaluationOf({}), 1, kKinds)),
            (std::vector<std::string>{"levels", "solvedLikeliest", "solvedAny"}));
}

TEST(EvaluationMetrics, EachPlayedNamedKindFollows) {
  const auto metrics = evaluationMetrics(evaluationOf({{1, 0}, {0, 0}, {9, 0.75}}), 1, kKinds);
  EXPECT_EQ(namesOf(metrics),
            (std::vector<std::string>{"levels", "solvedLikeliest", "solvedAny", "spinner/levels",
                                      "spinner/solvedLikeliest", "spinner/solvedAny"}));
  EXPECT_EQ(metrics[3].value, 9);
  EXPECT_EQ(metrics[4].value, 0.75);
}

}  // namespace
}  // namespace obby::train
