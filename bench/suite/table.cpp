#include "suite/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace obby::bench {
namespace {

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  if (std::fabs(value) >= 1e6) return fmt::format("{:.2f} M", value / 1e6);
  if (std::fabs(value) >= 1e4) return fmt::format("{:.1f} k", value / 1e3);
  return fmt::format("{:.3g}", value);
}

std::string cell(const Measure& m) {
  if (!m.interval) return number(m.value);
  return fmt::format("{} [{}, {}]", number(m.value), number(m.interval->low),
                     number(m.interval->high));
}

}  // namespace

std::string tableText(const std::vector<std::string>& methods,
                      const std::vector<Measure>& measures) {
  std::vector<std::string> metrics;
  for (const Measure& m : measures) {
    if (std::find(metrics.begin(), metrics.end(), m.metric) == metrics.end()) {
      metrics.push_back(m.metric);
    }
  }
  std::string text = fmt::format("{:<30}{:<6}", "", "");
  for (const std::string& method : methods) text += fmt::format("{:>24}", method);
  for (const std::string& metric : metrics) {
    std::string unit, cells;
    for (const std::string& method : methods) {
      const Measure* const found = findMeasure(measures, method, metric);
      cells += fmt::format("{:>24}", found ? cell(*found) : "-");
      if (found) unit = found->unit;
    }
    text += fmt::format("\n{:<30}{:<6}{}", metric, unit, cells);
  }
  return text + "\n";
}

}  // namespace obby::bench
