// Charts have axes with round ticks, and an SVG shows all the data.
#include "table/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace obby::table {
namespace {

using testing::HasSubstr;

std::vector<std::string> spokenOf(const ChartAxis& axis) {
  std::vector<std::string> out;
  for (const auto& tick : axis.ticks) out.push_back(tick.second);
  return out;
}

TEST(Chart, TicksAreRoundAndWithinTheRange) {
  using testing::ElementsAre;
  EXPECT_THAT(spokenOf(roundAxis("", 0, 3.9e6, false)), ElementsAre("0", "1 M", "2 M", "3 M"));
  EXPECT_THAT(spokenOf(roundAxis("", 0, 1, true, 100, " %")),
              ElementsAre("0 %", "20 %", "40 %", "60 %", "80 %", "100 %"));
  EXPECT_THAT(spokenOf(roundAxis("", 12'000, 20'000, false)),
              ElementsAre("12 k", "14 k", "16 k", "18 k", "20 k"));
  const ChartAxis around = roundAxis("", -0.02, 0.093, true);
  EXPECT_THAT(spokenOf(around), ElementsAre("-0.02", "0", "0.02", "0.04", "0.06", "0.08", "0.1"));
  EXPECT_DOUBLE_EQ(around.from, -0.02);
  EXPECT_DOUBLE_EQ(around.to, 0.1);
  const ChartAxis empty = roundAxis("", 5, 5, false);
  EXPECT_LT(empty.from, empty.to);
  EXPECT_FALSE(empty.ticks.empty());
}

TEST(Chart, DrawsCurvesWhereTheirValuesAre) {
  ChartPlot plot;
  plot.x = {"time", 1, 100, true, {{1, "one"}, {100, "hundred"}}};
  plot.y = {"a < b & c", 0, 1, false, {}};
  plot.curves = {{"mine", {{1, 0}, {10, 0.5}, {100, 1}}, {{1, 0.1}}, {{1, 0}}, {}},
                 {"none", {}, {}, {}, {}}};
  const std::string svg = chartSvg({plot});
  // The plot is 640 x 340 pixels at (62, 48). On the logarithmic axis, 10 is halfway from 1 to 100.
  EXPECT_THAT(svg,
              HasSubstr("<polyline points=\"62.0,388.0 382.0,218.0 702.0,48.0 \" class=\"l0\""));
  EXPECT_THAT(svg, HasSubstr("<polygon points=\"62.0,354.0 62.0,388.0 \" class=\"f0\""));
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(svg, HasSubstr("hundred"));
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(svg, HasSubstr(">none<")) << "in the legend, though it has no points";
  EXPECT_EQ(svg.find("l1\" points"), std::string::npos);
}

TEST(Chart, DrawsBarsFromTheFootWithWhiskers) {
  ChartPlot plot;
  plot.x = {"", 0, 10, false, {}};
  plot.y = {"", 1, 100, true, {}};
  plot.curves = {{"mine", {}, {}, {}, {{0, 5, 10, 1, 100}}}};
  const std::string svg = chartSvg({plot});
  EXPECT_THAT(svg, HasSubstr("<rect x=\"62.0\" y=\"218.0\" width=\"320.0\" height=\"170.0\" "
                             "class=\"f0\""));
  EXPECT_THAT(svg, HasSubstr("<line x1=\"222.0\" y1=\"388.0\" x2=\"222.0\" y2=\"48.0\""));
}

TEST(Chart, CurvesOfOneNameHaveOneColour) {
  ChartPlot first, second;
  first.curves = {{"a", {{0, 0}}, {}, {}, {}}, {"b", {{0, 0}}, {}, {}, {}}};
  second.curves = {{"b", {{1, 1}}, {}, {}, {}}};
  const std::string svg = chartSvg({first, second});
  const size_t plots = svg.rfind("<polyline");
  EXPECT_NE(svg.find("class=\"l1\"", plots), std::string::npos);
  EXPECT_EQ(svg.find("class=\"l2\""), std::string::npos);
}

}  // namespace
}  // namespace obby::table
