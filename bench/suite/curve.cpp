#include "suite/curve.h"

#include <fmt/format.h>

#include <cmath>

namespace obby::bench {
namespace {

constexpr double kLeft = 62, kTop = 48, kWidth = 640, kHeight = 340;  // of the plot, in pixels
constexpr double kFirst = 0.001;                                      // seconds, at the left
constexpr int kPoints = 160;                                          // of a curve
// Distinguishable without red and green, and dark enough for text.
constexpr const char* kColors[] = {"#1b62b5", "#c2570c", "#5d3a9b",
                                   "#0e7c66", "#8a6d00", "#444444"};

const char* color(size_t method) { return kColors[method % std::size(kColors)]; }

class Curve {
 public:
  explicit Curve(const Results& results) : results_(results) {}

  std::string svg() {
    text_ = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:g}" height="{1:g}" )"
        R"(viewBox="0 0 {0:g} {1:g}" font-family="sans-serif" font-size="13" fill="#222">)"
        "\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        kLeft + kWidth + 28, kTop + kHeight + 56);
    axes();
    for (size_t m = 0; m < results_.methods.size(); ++m) curve(m);
    legend();
    return text_ + "</svg>\n";
  }

 private:
  double x(double seconds) const {
    return kLeft + kWidth * std::log(seconds / kFirst) / std::log(results_.cap / kFirst);
  }
  static double y(double share) { return kTop + kHeight * (1 - share); }

  void line(double x1, double y1, double x2, double y2, const char* stroke) {
    text_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="{}"/>)"
                         "\n",
                         x1, y1, x2, y2, stroke);
  }
  void label(double atX, double atY, const char* anchor, const std::string& words) {
    text_ += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)"
                         "\n",
                         atX, atY, anchor, words);
  }

  void axes() {
    for (int percent = 0; percent <= 100; percent += 20) {
      line(kLeft, y(percent / 100.0), kLeft + kWidth, y(percent / 100.0), "#e4e4e4");
      label(kLeft - 8, y(percent / 100.0) + 4, "end", fmt::format("{} %", percent));
    }
    for (const double tick : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 90.0}) {
      if (tick > results_.cap * 1.001) break;
      line(x(tick), y(0), x(tick), y(1), "#e4e4e4");
      label(x(tick), y(0) + 20, "middle", fmt::format("{:g}", tick));
    }
    line(kLeft, y(0), kLeft + kWidth, y(0), "#555");
    line(kLeft, y(0), kLeft, y(1), "#555");
    label(kLeft + kWidth / 2, y(0) + 44, "middle", "seconds to the first solution");
    label(kLeft - 50, 26, "start", "runs of solvable queries that are solved");
  }

  void curve(size_t method) {
    std::vector<double> limits;
    for (int i = 0; i <= kPoints; ++i) {
      limits.push_back(kFirst * std::pow(results_.cap / kFirst, double(i) / kPoints));
    }
    const std::vector<Share> shares = solvedShares(results_, method, limits);
    std::string way, above, below;
    for (size_t i = 0; i < limits.size(); ++i) {
      if (std::isnan(shares[i].value)) return;  // it has no runs
      way += fmt::format("{:.1f},{:.1f} ", x(limits[i]), y(shares[i].value));
      above += fmt::format("{:.1f},{:.1f} ", x(limits[i]), y(shares[i].interval.high));
      below = fmt::format("{:.1f},{:.1f} ", x(limits[i]), y(shares[i].interval.low)) + below;
    }
    text_ += fmt::format(R"(<polygon points="{}{}" fill="{}" fill-opacity="0.12"/>)"
                         "\n"
                         R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="2"/>)"
                         "\n",
                         above, below, color(method), way, color(method));
  }

  void legend() {
    for (size_t m = 0; m < results_.methods.size(); ++m) {
      const double at = kTop + 18 + 20 * double(m);
      text_ += fmt::format(
          R"(<line x1="{0:.1f}" y1="{1:.1f}" x2="{2:.1f}" y2="{1:.1f}" stroke="{3}" stroke-width="3"/>)"
          "\n",
          kLeft + 16, at - 4, kLeft + 42, color(m));
      label(kLeft + 50, at, "start", results_.methods[m]);
    }
  }

  const Results& results_;
  std::string text_;
};

}  // namespace

std::string curveSvg(const Results& results) { return Curve(results).svg(); }

}  // namespace obby::bench
