// Draws curves as an SVG with one or several plots, one above the other. It is readable on light
// and on dark pages, because its colours follow the reader's preference.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace obby::table {

struct ChartAxis {
  std::string title;
  double from = 0, to = 1;  // from < to
  bool logarithmic = false;
  std::vector<std::pair<double, std::string>> ticks;  // position and label
};

using ChartPoints = std::vector<std::pair<double, double>>;

// A bar from the bottom of the plot up to a value, with a whisker.
struct ChartBar {
  double from, to;  // along x
  double value, low, high;
};

struct ChartCurve {
  std::string name;
  ChartPoints points;
  ChartPoints above, below;         // edges of a band around the curve; may be empty
  std::vector<ChartBar> bars = {};  // instead of points, or in addition to them
};

struct ChartPlot {
  ChartAxis x, y;  // the title of y is above the plot
  std::vector<ChartCurve> curves;
  double height = 340;  // pixels
};

// Returns an axis with about six round ticks. With `outward` it reaches from tick to tick around
// the range; otherwise it is the range, widened if it is empty. A label is `scale` times its tick,
// followed by `unit` (100 and " %"). Without a unit, thousands are k, M, G.
ChartAxis roundAxis(std::string title, double from, double to, bool outward, double scale = 1,
                    const std::string& unit = "");

// Colours are assigned in order, from the first curve of the first plot to the last curve of the
// last. Curves with the same name have the same colour.
std::string chartSvg(const std::vector<ChartPlot>& plots);

}  // namespace obby::table
