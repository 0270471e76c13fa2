// Curves as a picture: one SVG with a plot or several under one another. Readable on light and on
// dark pages: its colours follow what the reader prefers.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace obby::io {

struct ChartAxis {
  std::string title;
  double from = 0, to = 1;  // from < to
  bool logarithmic = false;
  std::vector<std::pair<double, std::string>> ticks;  // where, and what is said there
};

using ChartPoints = std::vector<std::pair<double, double>>;

// From the foot of the plot up to a value, with a whisker.
struct ChartBar {
  double from, to;  // along x
  double value, low, high;
};

struct ChartCurve {
  std::string name;
  ChartPoints points;
  ChartPoints above, below;         // of a band around it; may be empty
  std::vector<ChartBar> bars = {};  // instead of points, or beside them
};

struct ChartPlot {
  ChartAxis x, y;  // y's title stands above the plot
  std::vector<ChartCurve> curves;
  double height = 340;  // pixels
};

// An axis with about six round ticks. `outward`: from tick to tick around the range, otherwise the
// range itself, made wider where it has no width. What is said is `scale` times a tick, with `unit`
// behind it (100 and " %"); without one thousands are k, M, G.
ChartAxis roundAxis(std::string title, double from, double to, bool outward, double scale = 1,
                    const std::string& unit = "");

// Colours are given in order, from the first curve of the first plot to the last of the last;
// curves of one name have one colour.
std::string chartSvg(const std::vector<ChartPlot>& plots);

}  // namespace obby::io
