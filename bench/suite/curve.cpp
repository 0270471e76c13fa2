#include "suite/curve.h"

#include <fmt/format.h>

#include <cmath>

#include "io/chart.h"

namespace obby::bench {
namespace {

constexpr double kFirst = 0.001;  // seconds, at the left
constexpr int kPoints = 160;      // of a curve

io::ChartCurve curveOf(const Results& results, size_t method) {
  std::vector<double> limits;
  for (int i = 0; i <= kPoints; ++i) {
    limits.push_back(kFirst * std::pow(results.cap / kFirst, double(i) / kPoints));
  }
  const std::vector<Share> shares = solvedShares(results, method, limits);
  io::ChartCurve curve{results.methods[method], {}, {}, {}};
  for (size_t i = 0; i < limits.size(); ++i) {
    if (std::isnan(shares[i].value))
      return {results.methods[method], {}, {}, {}};  // it has no runs
    curve.points.emplace_back(limits[i], shares[i].value);
    curve.above.emplace_back(limits[i], shares[i].interval.high);
    curve.below.emplace_back(limits[i], shares[i].interval.low);
  }
  return curve;
}

}  // namespace

std::string curveSvg(const Results& results) {
  io::ChartPlot plot;
  plot.x = {"seconds to the first solution", kFirst, results.cap, true, {}};
  for (const double tick : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 90.0}) {
    if (tick <= results.cap * 1.001) plot.x.ticks.emplace_back(tick, fmt::format("{:g}", tick));
  }
  plot.y = {"runs of solvable queries that are solved", 0, 1, false, {}};
  for (int percent = 0; percent <= 100; percent += 20)
    plot.y.ticks.emplace_back(percent / 100.0, fmt::format("{} %", percent));
  for (size_t m = 0; m < results.methods.size(); ++m) plot.curves.push_back(curveOf(results, m));
  return io::chartSvg({plot});
}

}  // namespace obby::bench
