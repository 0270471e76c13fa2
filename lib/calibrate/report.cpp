#include "calibrate/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace obby::calibrate {

namespace {

// Formats a time that counts in whole ticks.
std::string ticksOf(const Fitted& f) {
  const long min = std::lround(f.low / f.tick), max = std::lround(f.high / f.tick);
  return fmt::format("{} tick{}", rangeText(fmt::format("{}", min), fmt::format("{}", max)),
                     min == 1 && max == 1 ? "" : "s");
}

std::string lineOf(const Fitted& f) {
  const Parameter& p = f.parameter;
  if (f.low == p.lowest && f.high == p.highest)
    return fmt::format("  {:<15} {:>10.5g}   not determined; to measure it: {}\n", p.name, f.value,
                       p.manoeuvre);
  const std::string more = f.known ? "" : fmt::format("; to narrow it down: {}", p.manoeuvre);
  if (f.tick > 0)
    return fmt::format("  {:<15} {:>10.5g}   {}{}\n", p.name, f.value, ticksOf(f), more);
  const std::string range = rangeText(fmt::format("{:.5g}", f.low), fmt::format("{:.5g}", f.high));
  return fmt::format("  {:<15} {:>10.5g}   {} {}{}\n", p.name, f.value, range, p.unit, more);
}

std::string lineOf(const Outcome& o) {
  const Miss& m = o.miss;
  return fmt::format("  {:<32} {:>8.3f} {:>8.3f} {:>8.3f}   {}{}\n", o.name, m.mean, m.last, m.max,
                     m.parted < 0 ? "" : fmt::format("half a stud off after {:.2f} s", m.parted),
                     o.heldOut ? (m.parted < 0 ? "held out" : ", held out") : "");
}

}  // namespace

std::string rangeText(const std::string& low, const std::string& high) {
  return low == high ? low : fmt::format("{} to {}", low, high);
}

std::string interruptionOf(const Fit& fit) {
  if (!fit.stopped) return {};
  return "The fit was interrupted. This is the best result so far; parameters that are not "
         "determined may not have been examined.";
}

double meanMiss(const std::vector<Outcome>& outcomes) {
  const bool any =
      std::any_of(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.heldOut; });
  double sum = 0, count = 0;
  for (const Outcome& o : outcomes) {
    if (any && !o.heldOut) continue;
    sum += o.miss.mean;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

std::string textOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance,
                   const std::vector<std::string>& why) {
  std::string out = interruptionOf(fit);
  if (!out.empty()) out += "\n\n";
  out += "Parameters, with 95 % confidence intervals\n";
  for (const Fitted& f : fit.parameters) out += lineOf(f);
  out += fmt::format("  {:<15} {:>10.5g}   s from an input to its effect\n", "delay", fit.delay);
  if (fit.controlRate > 0)
    out += fmt::format("  {:<15} {:>10}   ticks a second, with {} physics step{} each\n",
                       "controlRate", fit.controlRate, fit.substeps, fit.substeps == 1 ? "" : "s");
  for (const Tied& t : fit.tied)
    out +=
        fmt::format("  {} and {} cannot be told apart by these recordings (correlation {:.2f})\n",
                    t.one, t.other, t.correlation);
  out += fmt::format(
      "\nStuds off in each recording, replayed to the end\n  {:<32} {:>8} {:>8} {:>8}\n", "",
      "mean", "at end", "max");
  for (const Outcome& o : outcomes) out += lineOf(o);
  const double mean = meanMiss(outcomes);
  const auto worst = std::max_element(
      outcomes.begin(), outcomes.end(),
      [](const Outcome& a, const Outcome& b) { return a.miss.mean < b.miss.mean; });
  if (mean <= tolerance)
    return out + fmt::format("\nThe simulator is {:.3f} studs off, within the tolerance of {:g}\n",
                             mean, tolerance);
  out +=
      fmt::format("\nThe simulator is {:.3f} studs off, above the tolerance of {:g}; worst: '{}'\n",
                  mean, tolerance, worst->name);
  if (!why.empty())
    out += fmt::format("\nWhy the fit is not closer\n  {}\n", fmt::join(why, "\n  "));
  return out;
}

}  // namespace obby::calibrate
