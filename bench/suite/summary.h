// From runs to the figures of the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "suite/run_log.h"
#include "suite/statistics.h"

namespace obby::bench {

// What the report knows of a query beside its runs.
struct Asked {
  std::string name;      // FILE:ID
  std::string expected;  // verdict
  double effort = 0;

  bool solvable() const { return expected == "solved"; }
};

// All runs that a report is about: runs[method][query] has one for each seed.
struct Results {
  std::vector<std::string> methods;
  std::vector<Asked> queries;
  std::vector<std::vector<std::vector<Run>>> runs;
  double cap = 0;  // seconds, of queries that have a solution
};

struct Measure {
  std::string method, metric;
  double value;
  std::optional<Interval> interval;  // 95 %
  std::string unit;
};

// For each method in turn. Every query weighs the same; those without a solution count in
// falseVerdicts and provedShare only.
//   solvedShare1, 3, 10, 30, 90   within so many seconds; solvedShare90 of a shorter cap: within it
//   par2Seconds, medianSeconds    with an interval; a median run that was not solved has the cap
//   meanSeconds, lowerQuartileSeconds, upperQuartileSeconds   unsolved = cap, as the paper has it
//   medianSteps, medianRounds     simulated ticks and generations, solved or not
//   ge{Short,Medium,Long}MeanSeconds, ...LowerQuartile, ...UpperQuartile   of the thirds of the
//                                 queries by ge's own mean time, as the paper has it;
//                                 geLongPar2Seconds with an interval
//   {easy,middle,hard}ThirdMeanSeconds, hardThirdPar2Seconds, hardThirdSolvedShare   of the thirds
//                                 by effort (effort.h)
//   par2RatioToGe                 par2Seconds of ge by that of the method, over the queries that
//                                 both were asked: 5 is five times better than ge
//   falseVerdicts                 solved where the suite says that there is no solution, and
//                                 unreachable where it says that there is one: runs
//   provedShare                   of the queries that the suite says can be shown to be unreachable
std::vector<Measure> summarise(const Results& results);

// Null where the method has no such figure.
const Measure* findMeasure(const std::vector<Measure>& measures, const std::string& method,
                           const std::string& metric);

// The queries that took the method longest, or that it did not solve, as lines for people.
std::string slowest(const Results& results, size_t method, size_t count);

// Share of the runs of solvable queries that were solved within each of `limits`, every query
// weighing the same, with its interval.
struct Share {
  double value;
  Interval interval;
};
std::vector<Share> solvedShares(const Results& results, size_t method,
                                const std::vector<double>& limits);

}  // namespace obby::bench
