#include "suite/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "table/chart.h"

namespace obby::bench {
namespace {

constexpr double kFirst = 0.001;  // left end of the time axis, seconds
constexpr int kPoints = 160;      // points of a curve

table::ChartCurve curveOf(const Results& results, size_t method) {
  std::vector<double> limits;
  for (int i = 0; i <= kPoints; ++i) {
    limits.push_back(kFirst * std::pow(results.cap / kFirst, double(i) / kPoints));
  }
  const std::vector<Share> shares = solvedShares(results, method, limits);
  table::ChartCurve curve{results.methods[method], {}, {}, {}, {}};
  for (size_t i = 0; i < limits.size(); ++i) {
    if (std::isnan(shares[i].value)) return {results.methods[method], {}, {}, {}, {}};  // no runs
    curve.points.emplace_back(limits[i], shares[i].value);
    curve.above.emplace_back(limits[i], shares[i].interval.high);
    curve.below.emplace_back(limits[i], shares[i].interval.low);
  }
  return curve;
}

constexpr double kTicks[] = {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 90};

table::ChartAxis secondsAxis(std::string title, double from, double to) {
  table::ChartAxis axis{std::move(title), from, to, true, {}};
  for (const double tick : kTicks) {
    if (tick >= from && tick <= to * 1.001)
      axis.ticks.emplace_back(tick, fmt::format("{:g}", tick));
  }
  return axis;
}

table::ChartPlot solvedPlot(const Results& results) {
  table::ChartPlot plot;
  plot.x = secondsAxis("seconds to the first solution", kFirst, results.cap);
  plot.y = {"share of solvable runs solved", 0, 1, false, {}};
  for (int percent = 0; percent <= 100; percent += 20)
    plot.y.ticks.emplace_back(percent / 100.0, fmt::format("{} %", percent));
  for (size_t m = 0; m < results.methods.size(); ++m) plot.curves.push_back(curveOf(results, m));
  return plot;
}

table::ChartPlot thirdsPlot(const Results& results, const std::vector<Measure>& measures) {
  // Lower end of the axis, seconds; share of a third's width that its bars fill.
  constexpr double kFoot = 0.01, kGroup = 0.8;
  const char* const thirds[] = {"Short", "Medium", "Long"};
  table::ChartPlot plot;
  plot.x = {"queries by the time of ge", -0.5, 2.5, false, {}};
  plot.y = secondsAxis("mean seconds to the first solution, and quartiles", kFoot, results.cap);
  const double width = kGroup / double(results.methods.size());
  for (int t = 0; t < 3; ++t) plot.x.ticks.emplace_back(t, thirds[t]);
  for (size_t m = 0; m < results.methods.size(); ++m) {
    table::ChartCurve& bars = plot.curves.emplace_back();
    bars.name = results.methods[m];
    for (int t = 0; t < 3; ++t) {
      const auto read = [&](const char* what) {
        const std::string metric = fmt::format("ge{}{}Seconds", thirds[t], what);
        return std::clamp(findMeasure(measures, bars.name, metric)->value, kFoot, results.cap);
      };
      const double from = t - kGroup / 2 + width * double(m);
      const double mean = read("Mean");
      if (std::isnan(mean)) continue;  // no runs
      bars.bars.push_back(
          {from, from + 0.9 * width, mean, read("LowerQuartile"), read("UpperQuartile")});
    }
  }
  return plot;
}

}  // namespace

std::string suiteSvg(const Results& results, const std::vector<Measure>& measures) {
  std::vector<table::ChartPlot> plots = {solvedPlot(results)};
  if (findMeasure(measures, "ge", "geLongMeanSeconds"))
    plots.push_back(thirdsPlot(results, measures));
  return table::chartSvg(plots);
}

}  // namespace obby::bench
