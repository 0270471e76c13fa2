// Statistics of timed runs, as plain functions of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace obby::bench {

// The result of one run of a solver.
struct Timing {
  double seconds = 0;
  bool solved = false;
  double steps = 0, rounds = 0;
};

// Returns the mean, or NaN for no values.
double mean(const std::vector<double>& values);

// Returns the seconds to the first solution as in the paper: `cap` for a run without one.
double cappedSeconds(const Timing& run, double cap);

// Returns the penalised seconds of a run: twice the cap if it has no solution.
double par2(const Timing& run, double cap);

// Returns 0, 1 or 2 for each key: its third in ascending order. Equal keys keep their order, so
// that the thirds are equally large.
std::vector<int> thirds(const std::vector<double>& keys);

struct Interval {
  double low, high;
};

// A statistic of sampled groups of runs, by index; a group may occur several times.
using GroupStatistic = std::function<double(const std::vector<size_t>&)>;

// Returns the 95 % percentile interval of `statistic` over 1000 resamples of groups 0 to groups -
// 1. Groups (queries) are resampled instead of runs, since the runs of one query are correlated.
// The result is deterministic.
Interval bootstrap(size_t groups, const GroupStatistic& statistic);

}  // namespace obby::bench
