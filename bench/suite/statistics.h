// The figures that sum up many timed runs, as plain functions of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace obby::bench {

// How one run of a solver went.
struct Timing {
  double seconds = 0;
  bool solved = false;
  double steps = 0, rounds = 0;
};

// NaN for none.
double mean(const std::vector<double>& values);

// Seconds to the first solution as the paper counts them: a run without one took `cap`.
double cappedSeconds(const Timing& run, double cap);

// Penalised seconds of a run: one without a solution counts twice the cap.
double par2(const Timing& run, double cap);

// 0, 1 or 2 for each key: in which third of the keys in ascending order it is. Equal keys keep
// their order, so that thirds are equally large.
std::vector<int> thirds(const std::vector<double>& keys);

struct Interval {
  double low, high;
};

// A statistic of picked groups of runs, by their indices; a group may be picked several times.
using GroupStatistic = std::function<double(const std::vector<size_t>&)>;

// The 95 % percentile interval of `statistic` over 1000 resamples of the groups 0 ... groups - 1.
// Groups (queries) are resampled and not runs, since runs of one query are alike. The same every
// time.
Interval bootstrap(size_t groups, const GroupStatistic& statistic);

}  // namespace obby::bench
