#include "calibrate/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text.h"
#include "table/chart.h"

namespace obby::calibrate {

namespace {

constexpr double kBar = 220;        // width of an interval's bar, pixels
constexpr double kPlotWidth = 640;  // pixels, as in table::chartSvg
constexpr double kLow = 150, kHigh = 460;
constexpr double kMinMap = 4;       // min width of a map, studs; smaller ones would show only
                                    // noise
constexpr size_t kMaxPoints = 600;  // max points of a curve; more are not visible

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Calibration</title>
<style>
:root{color-scheme:light dark;--text:#222;--page:#fff;--faint:#6b6b6b;--line:#ddd;--mark:#1b62b5;--bad:#b3261e}
@media(prefers-color-scheme:dark){:root{--text:#ddd;--page:#181a1f;--faint:#9a9a9a;--line:#34373d;--mark:#74b2ff;--bad:#ff9f8e}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--text);background:var(--page);max-width:62rem;margin:2rem auto;padding:0 1rem}
h1{font-size:1.5rem;margin:0 0 .25rem}h2{font-size:1.15rem;margin:2rem 0 .5rem}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:.25rem .75rem .25rem 0;border-bottom:1px solid var(--line);vertical-align:middle}
th{font-weight:600}td.n,th.n{text-align:right}.faint{color:var(--faint)}.bad{color:var(--bad)}
.lead{font-size:1.1rem}summary{cursor:pointer;padding:.35rem 0;border-bottom:1px solid var(--line)}
summary:focus-visible{outline:2px solid var(--mark)}svg.bar .range{fill:var(--line)}svg.bar .is{fill:var(--mark)}
svg.bar .was{stroke:var(--faint);stroke-width:2}details svg{max-width:100%;height:auto}
.wide{overflow-x:auto}
</style></head><body>
)";

std::string number(double value) { return fmt::format("{:.5g}", value); }

double placeOf(const Parameter& p, double value) { return kBar * shareOf(p, value); }

// Draws the interval within the bounds, and the value before the fit as a line.
std::string barOf(const Fitted& f) {
  const Parameter& p = f.parameter;
  const double low = placeOf(p, f.low), high = placeOf(p, f.high);
  std::string out = fmt::format(
      "<svg class=\"bar\" width=\"{0}\" height=\"16\" role=\"img\" aria-label=\"{1}; searched: "
      "{2} to {3}\"><rect class=\"range\" y=\"6\" width=\"{0}\" height=\"4\"/>",
      kBar, rangeText(number(f.low), number(f.high)), number(p.lowest), number(p.highest));
  const bool unknown = f.low == p.lowest && f.high == p.highest;
  if (!unknown)
    out += fmt::format("<rect class=\"is\" x=\"{:.1f}\" y=\"3\" width=\"{:.1f}\" height=\"10\"/>",
                       low, std::max(high - low, 2.0));
  const double was = placeOf(p, f.before);
  return out +
         fmt::format("<line class=\"was\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"16\"/></svg>",
                     was);
}

std::string rowOf(const Fitted& f) {
  const Parameter& p = f.parameter;
  const bool unknown = f.low == p.lowest && f.high == p.highest;
  const std::string wider = unknown ? "not determined; to measure it: " : "to narrow it down: ";
  return fmt::format(
      "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n faint\">{}</td><td>{}</td><td>{}</td>"
      "<td class=\"faint\">{}</td></tr>\n",
      io::escapeMarkup(p.name), unknown ? "" : number(f.value), number(f.before),
      io::escapeMarkup(p.unit), barOf(f),
      f.known ? rangeText(number(f.low), number(f.high)) : io::escapeMarkup(wider + p.manoeuvre));
}

std::string parametersOf(const Fit& fit) {
  std::string out =
      "<h2>Parameters</h2><p class=\"faint\">Bar: range searched. Filled: 95 % confidence "
      "interval. Line: value before the fit.</p>\n<div "
      "class=\"wide\"><table><tr><th>parameter</th><th "
      "class=\"n\">found</th><th class=\"n\">before</th><th>unit</th><th></th><th></th></tr>\n";
  for (const Fitted& f : fit.parameters) out += rowOf(f);
  out += fmt::format(
      "<tr><td>delay</td><td class=\"n\">{}</td><td class=\"n faint\">0</td><td>s</td><td></td><td "
      "class=\"faint\">from an input to its effect</td></tr>\n",
      number(fit.delay));
  if (fit.controlRate > 0)
    out += fmt::format(
        "<tr><td>controlRate</td><td class=\"n\">{}</td><td></td><td>1/s</td><td></td><td "
        "class=\"faint\">ticks, with {} physics step{} each</td></tr>\n",
        fit.controlRate, fit.substeps, fit.substeps == 1 ? "" : "s");
  out += "</table></div>\n";
  if (fit.tied.empty()) return out;
  out += "<p>The recordings determine only a combination of each of these pairs:</p><ul>\n";
  for (const Tied& t : fit.tied)
    out += fmt::format("<li>{} and {} <span class=\"faint\">(correlation {:.2f})</span></li>\n",
                       io::escapeMarkup(t.one), io::escapeMarkup(t.other), t.correlation);
  return out + "</ul>\n";
}

// Samples every n-th point, and the last.
template <class Point>
table::ChartCurve curveOf(const std::string& name, size_t count, const Point& point) {
  table::ChartCurve curve{name, {}, {}, {}};
  const size_t step = count / kMaxPoints + 1;
  for (size_t i = 0; i < count; i += step) curve.points.push_back(point(i));
  if (count > 0 && (count - 1) % step != 0) curve.points.push_back(point(count - 1));
  return curve;
}

struct Range {
  double from = 1e300, to = -1e300;
};

Range rangeOf(const std::vector<table::ChartCurve>& curves, bool second) {
  Range out;
  for (const table::ChartCurve& curve : curves) {
    for (const auto& [x, y] : curve.points) {
      out.from = std::min(out.from, second ? y : x);
      out.to = std::max(out.to, second ? y : x);
    }
  }
  return out;
}

table::ChartPlot plotOf(const std::string& across, const std::string& up,
                        std::vector<table::ChartCurve> curves) {
  const Range x = rangeOf(curves, false), y = rangeOf(curves, true);
  return {table::roundAxis(across, x.from, x.to, true), table::roundAxis(up, y.from, y.to, true),
          std::move(curves), 200};
}

Range widened(Range range, double size) {
  const double more = std::max(0.0, size - (range.to - range.from)) / 2;
  return {range.from - more, range.to + more};
}

// A map has the same scale on both axes.
table::ChartPlot mapOf(const std::string& across, const std::string& up,
                       std::vector<table::ChartCurve> curves) {
  Range x = rangeOf(curves, false), y = rangeOf(curves, true);
  const double size = std::max({x.to - x.from, (y.to - y.from) * kPlotWidth / kHigh, kMinMap});
  x = widened(x, size);
  y = widened(y, size * kLow / kPlotWidth);
  return {table::roundAxis(across, x.from, x.to, false), table::roundAxis(up, y.from, y.to, false),
          std::move(curves), kPlotWidth * (y.to - y.from) / size};
}

std::string chartsOf(const Path& path) {
  const size_t count = path.seconds.size();
  const auto pair = [&](const auto& point) {
    return std::vector<table::ChartCurve>{
        curveOf("recorded", count, [&](size_t i) { return point(i, path.recorded[i]); }),
        curveOf("simulated", count, [&](size_t i) { return point(i, path.simulated[i]); })};
  };
  const auto above = pair([](size_t, Vec3 p) { return std::pair(double(p.x), -double(p.z)); });
  const auto height =
      pair([&](size_t i, Vec3 p) { return std::pair(path.seconds[i], double(p.y)); });
  std::vector<table::ChartCurve> off = {curveOf("distance", count, [&](size_t i) {
    return std::pair(path.seconds[i], double(length(path.simulated[i] - path.recorded[i])));
  })};
  return table::chartSvg({mapOf("x, studs", "from above: -z, studs", above)}) +
         table::chartSvg({plotOf("seconds", "height, studs", height)}) +
         table::chartSvg({plotOf("seconds", "distance, studs", std::move(off))});
}

std::string recordingOf(const Outcome& o, bool open) {
  const std::string parted =
      o.miss.parted < 0 ? ""
                        : fmt::format(" <span class=\"bad\">half a stud off after {:.2f} s</span>",
                                      o.miss.parted);
  return fmt::format(
      "<details{}><summary>{}: {:.3f} studs off, {:.3f} at the end, max "
      "{:.3f}{}{}</summary>\n{}</details>\n",
      open ? " open" : "", io::escapeMarkup(o.name), o.miss.mean, o.miss.last, o.miss.max, parted,
      o.heldOut ? " <span class=\"faint\">(held out from the fit)</span>" : "", chartsOf(o.path));
}

std::string reasonsIn(const std::vector<std::string>& why) {
  if (why.empty()) return {};
  std::string out = "<h2>Why the fit is not closer</h2>\n<ul>\n";
  for (const std::string& reason : why) out += "<li>" + io::escapeMarkup(reason) + "</li>\n";
  return out + "</ul>\n";
}

}  // namespace

std::string pageOf(const Fit& fit, const std::vector<Outcome>& outcomes, double tolerance,
                   const std::vector<std::string>& why) {
  const double mean = meanMiss(outcomes);
  std::string out = kHead;
  out += fmt::format(
      "<h1>Calibration</h1><p class=\"lead\">With these parameters the simulator is <strong>{:.3f} "
      "studs</strong> off the recordings, <span class=\"{}\">{} the tolerance of "
      "{:g}</span>.</p>\n",
      mean, mean <= tolerance ? "good" : "bad", mean <= tolerance ? "within" : "above", tolerance);
  if (fit.stopped) out += "<p class=\"bad\">" + interruptionOf(fit) + "</p>\n";
  out += reasonsIn(why);
  out += parametersOf(fit);
  out += "<h2>Recordings, replayed to the end</h2><p class=\"faint\">Worst first.</p>\n";
  std::vector<const Outcome*> byMiss;
  for (const Outcome& o : outcomes) byMiss.push_back(&o);
  std::stable_sort(byMiss.begin(), byMiss.end(),
                   [](const Outcome* a, const Outcome* b) { return a->miss.mean > b->miss.mean; });
  for (const Outcome* o : byMiss) out += recordingOf(*o, o == byMiss.front());
  return out + "</body></html>\n";
}

}  // namespace obby::calibrate
