#include "table/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text.h"

namespace obby::table {
namespace {

constexpr double kLeft = 62, kTop = 48, kWidth = 640, kBetween = 88, kBottom = 56;  // pixels
constexpr double kRight = 60, kLetter = 7.4;  // width of the legend, and of each letter in it
// The colours are distinct even to readers who cannot see red or green. They are dark (or light)
// enough for text.
constexpr const char* kColors[] = {"#1b62b5", "#c2570c", "#5d3a9b",
                                   "#0e7c66", "#8a6d00", "#444444"};
constexpr const char* kDarkColors[] = {"#74b2ff", "#ff9f5e", "#bb9ff2",
                                       "#55d3b2", "#e2c350", "#c0c0c0"};

std::string colorRules(const char* const* colors) {
  std::string text;
  for (size_t i = 0; i < std::size(kColors); ++i)
    text += fmt::format(".l{0}{{stroke:{1}}}.f{0}{{fill:{1}}}", i, colors[i]);
  return text;
}

std::string style() {
  return fmt::format(
      "<style>text{{fill:#222}}.page{{fill:#fff}}.grid{{stroke:#e4e4e4}}.axis{{stroke:#555}}"
      "polyline,.key{{fill:none;stroke-width:2}}{}\n"
      "@media(prefers-color-scheme:dark){{text{{fill:#ddd}}.page{{fill:#181a1f}}"
      ".grid{{stroke:#34373d}}.axis{{stroke:#999}}{}}}</style>\n",
      colorRules(kColors), colorRules(kDarkColors));
}

std::string label(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     io::escapeMarkup(words));
}

std::string line(double x1, double y1, double x2, double y2, const std::string& kind) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", x1, y1, x2,
      y2, kind);
}

// Draws one plot with its upper edge at `top`. A curve has the colour of its name's index in
// `names`.
class Drawing {
 public:
  Drawing(const ChartPlot& plot, double top, const std::vector<std::string>& names)
      : plot_(plot), top_(top), names_(names) {}

  std::string svg() const {
    std::string text = axes();
    for (size_t i = 0; i < plot_.curves.size(); ++i)
      text += bars(plot_.curves[i], colorOf(i)) + curve(plot_.curves[i], colorOf(i));
    return text + legend();
  }

 private:
  static double shareOf(const ChartAxis& a, double v) {
    if (a.logarithmic) return std::log(v / a.from) / std::log(a.to / a.from);
    return (v - a.from) / (a.to - a.from);
  }
  double x(double v) const { return kLeft + kWidth * shareOf(plot_.x, v); }
  double y(double v) const { return top_ + plot_.height * (1 - shareOf(plot_.y, v)); }

  std::string axes() const {
    const double foot = top_ + plot_.height, right = kLeft + kWidth;
    std::string text;
    for (const auto& [at, words] : plot_.y.ticks)
      text += line(kLeft, y(at), right, y(at), "grid") + label(kLeft - 8, y(at) + 4, "end", words);
    for (const auto& [at, words] : plot_.x.ticks)
      text += line(x(at), foot, x(at), top_, "grid") + label(x(at), foot + 20, "middle", words);
    return text + line(kLeft, foot, right, foot, "axis") + line(kLeft, foot, kLeft, top_, "axis") +
           label(kLeft + kWidth / 2, foot + 44, "middle", plot_.x.title) +
           label(kLeft - 50, top_ - 22, "start", plot_.y.title);
  }

  std::string pointsOf(const ChartPoints& points) const {
    std::string text;
    for (const auto& [px, py] : points) text += fmt::format("{:.1f},{:.1f} ", x(px), y(py));
    return text;
  }

  size_t colorOf(size_t curve) const {
    const auto found = std::find(names_.begin(), names_.end(), plot_.curves[curve].name);
    return size_t(found - names_.begin()) % std::size(kColors);
  }

  std::string bars(const ChartCurve& c, size_t color) const {
    std::string text;
    for (const ChartBar& b : c.bars) {
      const double left = x(b.from), right = x(b.to), middle = (left + right) / 2;
      text += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"f{}\" "
          "fill-opacity=\"0.55\"/>\n",
          left, y(b.value), right - left, top_ + plot_.height - y(b.value), color);
      text += line(middle, y(b.low), middle, y(b.high), "axis");
      for (const double end : {b.low, b.high})
        text += line(middle - 4, y(end), middle + 4, y(end), "axis");
    }
    return text;
  }

  std::string curve(const ChartCurve& c, size_t color) const {
    if (c.points.empty()) return {};
    std::string text;
    if (!c.above.empty()) {
      text += fmt::format("<polygon points=\"{}{}\" class=\"f{}\" fill-opacity=\"0.12\"/>\n",
                          pointsOf(c.above), pointsOf({c.below.rbegin(), c.below.rend()}), color);
    }
    return text +
           fmt::format("<polyline points=\"{}\" class=\"l{}\"/>\n", pointsOf(c.points), color);
  }

  std::string legend() const {
    std::string text;
    for (size_t i = 0; i < plot_.curves.size(); ++i) {
      const double at = top_ + 14 + 20 * double(i), from = kLeft + kWidth + 14;
      text += line(from, at - 4, from + 20, at - 4, fmt::format("key l{}", colorOf(i)));
      text += label(from + 26, at, "start", plot_.curves[i].name);
    }
    return text;
  }

  const ChartPlot& plot_;
  double top_;
  const std::vector<std::string>& names_;
};

// Returns the names of all curves, each once.
std::vector<std::string> namesOf(const std::vector<ChartPlot>& plots) {
  std::vector<std::string> names;
  for (const ChartPlot& plot : plots) {
    for (const ChartCurve& c : plot.curves) {
      if (std::find(names.begin(), names.end(), c.name) == names.end()) names.push_back(c.name);
    }
  }
  return names;
}

std::string spoken(double value, const std::string& unit) {
  const double size = std::abs(value);
  if (!unit.empty() || size < 1000) return fmt::format("{:g}{}", value, unit);
  if (size < 1e6) return fmt::format("{:g} k", value / 1e3);
  if (size < 1e9) return fmt::format("{:g} M", value / 1e6);
  return fmt::format("{:g} G", value / 1e9);
}

}  // namespace

ChartAxis roundAxis(std::string title, double from, double to, bool outward, double scale,
                    const std::string& unit) {
  if (!(to > from)) to = from + std::max(std::abs(from), 1e-6);
  const double rough = (to - from) / 6, power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double round : {5.0, 2.0, 1.0}) {
    if (round * power >= rough) step = round * power;
  }
  double first = from / step, last = to / step;
  first = outward ? std::floor(first + 1e-9) : std::ceil(first - 1e-9);
  last = outward ? std::ceil(last - 1e-9) : std::floor(last + 1e-9);
  ChartAxis axis{std::move(title), from, to, false, {}};
  if (outward) axis.from = first * step, axis.to = last * step;
  for (double n = first == 0 ? 0 : first; n <= last; ++n)  // adding 0 keeps a tick from reading -0
    axis.ticks.emplace_back(n * step, spoken(n * step * scale, unit));
  return axis;
}

std::string chartSvg(const std::vector<ChartPlot>& plots) {
  std::string body;
  double top = kTop;
  size_t longest = 0;
  const std::vector<std::string> names = namesOf(plots);
  for (const std::string& name : names) longest = std::max(longest, name.size());
  for (const ChartPlot& plot : plots) {
    body += Drawing(plot, top, names).svg();
    top += plot.height + kBetween;
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
             "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"sans-serif\" font-size=\"13\">\n",
             std::ceil(kLeft + kWidth + kRight + kLetter * double(longest)),
             top - kBetween + kBottom) +
         style() + "<rect width=\"100%\" height=\"100%\" class=\"page\"/>\n" + body + "</svg>\n";
}

}  // namespace obby::table
