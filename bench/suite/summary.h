// Computes the report's figures from runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "suite/run_log.h"
#include "suite/statistics.h"

namespace obby::bench {

// The report's facts about a query, apart from its runs.
struct Asked {
  std::string name;      // FILE:ID
  std::string expected;  // verdict
  double effort = 0;

  bool solvable() const { return expected == "solved"; }
};

// All runs of a report: runs[method][query] has one for each seed.
struct Results {
  std::vector<std::string> methods;
  std::vector<Asked> queries;
  std::vector<std::vector<std::vector<Run>>> runs;
  double cap = 0;  // seconds, for solvable queries
};

struct Measure {
  std::string method, metric;
  double value;
  std::optional<Interval> interval;  // 95 %
  std::string unit;
};

// Returns the measures of each method. Every query has the same weight. Unsolvable ones count only
// in falseVerdicts and provedShare.
//   solvedShare1, 3, 10, 30, 90   within these seconds, or within a shorter cap
//   par2Seconds, medianSeconds    with an interval; an unsolved median run counts as the cap
//   meanSeconds, lowerQuartileSeconds, upperQuartileSeconds   unsolved = cap, as in the paper
//   medianSteps, medianRounds     simulated ticks and generations, solved or not
//   ge{Short,Medium,Long}MeanSeconds, ...LowerQuartile, ...UpperQuartile   of the thirds of the
//                                 queries by ge's own mean time, as in the paper;
//                                 geLongPar2Seconds with an interval
//   {easy,middle,hard}ThirdMeanSeconds, hardThirdPar2Seconds, hardThirdSolvedShare   of the thirds
//                                 by effort (effort.h)
//   par2RatioToGe                 par2Seconds of ge divided by the method's, over the queries that
//                                 both answered: 5 is five times better than ge
//   falseVerdicts                 number of runs: solved although the suite has no solution, or
//                                 unreachable although it has one
//   provedShare                   share of the queries that can be proven unreachable
std::vector<Measure> summarise(const Results& results);

// Returns null if the method lacks the measure.
const Measure* findMeasure(const std::vector<Measure>& measures, const std::string& method,
                           const std::string& metric);

// Returns the queries that took the method longest or that it did not solve, as lines of text.
std::string slowest(const Results& results, size_t method, size_t count);

// The share of solved runs of solvable queries within a time limit, with its interval. Every query
// has the same weight.
struct Share {
  double value;
  Interval interval;
};
std::vector<Share> solvedShares(const Results& results, size_t method,
                                const std::vector<double>& limits);

}  // namespace obby::bench
