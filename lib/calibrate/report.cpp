#include "calibrate/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace obby::calibrate {

namespace {

// A time that the simulator counts in whole ticks.
std::string ticksOf(const Fitted& f) {
  const long least = std::lround(f.low / f.tick), most = std::lround(f.high / f.tick);
  if (least == most) return fmt::format("{} ticks", least);
  return fmt::format("{} to {} ticks", least, most);
}

std::string lineOf(const Fitted& f) {
  const Parameter& p = f.parameter;
  if (f.low == p.lowest && f.high == p.highest)
    return fmt::format("  {:<15} {:>10.5g}   not known; to learn of it: {}\n", p.name, f.value,
                       p.manoeuvre);
  const std::string more = f.known ? "" : fmt::format("; to know it better: {}", p.manoeuvre);
  if (f.tick > 0)
    return fmt::format("  {:<15} {:>10.5g}   {}{}\n", p.name, f.value, ticksOf(f), more);
  return fmt::format("  {:<15} {:>10.5g}   {:.5g} to {:.5g} {}{}\n", p.name, f.value, f.low, f.high,
                     p.unit, more);
}

std::string lineOf(const Outcome& o) {
  const Miss& m = o.miss;
  return fmt::format("  {:<32} {:>8.3f} {:>8.3f} {:>8.3f}   {}{}\n", o.name, m.mean, m.last, m.most,
                     m.parted < 0 ? "" : fmt::format("half a stud off after {:.2f} s", m.parted),
                     o.heldOut ? (m.parted < 0 ? "held out" : ", held out") : "");
}

}  // namespace

std::string interruptionOf(const Fit& fit) {
  if (!fit.stopped) return {};
  return "The fit was interrupted: this is the best so far, and what is not known of it may not "
         "have been looked at.";
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
  out += "Parameters, with what they are in 95 of 100 cases\n";
  for (const Fitted& f : fit.parameters) out += lineOf(f);
  out +=
      fmt::format("  {:<15} {:>10.5g}   s from an input to what comes of it\n", "delay", fit.delay);
  if (fit.controlRate > 0)
    out += fmt::format("  {:<15} {:>10}   1/s runs of the rules, with {} physics steps in each\n",
                       "controlRate", fit.controlRate, fit.substeps);
  for (const Tied& t : fit.tied)
    out +=
        fmt::format("  {} and {} cannot be told apart by these recordings (correlation {:.2f})\n",
                    t.one, t.other, t.correlation);
  out += fmt::format("\nRecordings, played to their ends: studs off\n  {:<32} {:>8} {:>8} {:>8}\n",
                     "", "mean", "at last", "at most");
  for (const Outcome& o : outcomes) out += lineOf(o);
  const double mean = meanMiss(outcomes);
  const auto worst = std::max_element(
      outcomes.begin(), outcomes.end(),
      [](const Outcome& a, const Outcome& b) { return a.miss.mean < b.miss.mean; });
  if (mean <= tolerance)
    return out + fmt::format("\n{:.3f} studs off, within the tolerance of {:g}\n", mean, tolerance);
  out += fmt::format("\n{:.3f} studs off, above the tolerance of {:g}: most in '{}'\n", mean,
                     tolerance, worst->name);
  if (!why.empty()) out += fmt::format("\nWhy not nearer\n  {}\n", fmt::join(why, "\n  "));
  return out;
}

}  // namespace obby::calibrate
