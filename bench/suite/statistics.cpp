#include "suite/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/quantile.h"
#include "base/random.h"

namespace obby::bench {
namespace {

constexpr int kResamples = 1000;
constexpr uint64_t kBootstrapSeed = 20;  // arbitrary but fixed, for reproducible reports
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double mean(const std::vector<double>& values) {
  if (values.empty()) return kNone;
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double cappedSeconds(const Timing& run, double cap) {
  return run.solved ? std::min(run.seconds, cap) : cap;
}

double par2(const Timing& run, double cap) {
  return run.solved && run.seconds <= cap ? run.seconds : 2 * cap;
}

std::vector<int> thirds(const std::vector<double>& keys) {
  std::vector<size_t> order(keys.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return keys[a] < keys[b]; });
  std::vector<int> third(keys.size());
  for (size_t rank = 0; rank < order.size(); ++rank) {
    third[order[rank]] = int(rank * 3 / order.size());
  }
  return third;
}

Interval bootstrap(size_t groups, const GroupStatistic& statistic) {
  if (groups == 0) return {kNone, kNone};
  std::vector<double> values;
  std::vector<size_t> picks(groups);
  for (int resample = 0; resample < kResamples; ++resample) {
    Random random(kBootstrapSeed, uint64_t(resample));
    for (size_t& pick : picks) pick = random.below(uint32_t(groups));
    const double value = statistic(picks);
    if (std::isfinite(value)) values.push_back(value);
  }
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

}  // namespace obby::bench
