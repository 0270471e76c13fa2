// The table and the map, to the letter.
#include "view/text_report.h"

#include <gmock/gmock.h>

#include "course.h"
#include "view/raster.h"
#include "view/utf8.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const view::TerminalTraits kAscii{80, false, false};

TEST(Text, TableHasOneRowAQuery) {
  const view::Report report = solvedReport();
  const std::string table = view::queryTable(report, {120, false, false});
  const std::string ticks = std::to_string(report.queries[0].answer().getTicks());
  EXPECT_THAT(
      table, ::testing::MatchesRegex("query +verdict +found in +ticks +play +jumps +steps +reason\n"
                                     "ahead +solved +0.25 s +" +
                                     ticks + " +[0-9.]+ s +0 +1.23M +Straight on.\n"));
}

TEST(Text, MismatchTakesTheVerdictsPlace) {
  auto path = walk(kAhead, 200);
  path.root().getTrajectory().setStateHash(1);
  auto report = collect({kLevel, kQuery, line(path), resultLine("solved", 80)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string table = view::queryTable(*report, kAscii);
  EXPECT_THAT(table, HasSubstr("MISMATCH"));
  EXPECT_THAT(table, HasSubstr("replay: "));
}

TEST(Text, NarrowTerminalsGetReasonsOnLinesOfTheirOwn) {
  const std::string table = view::queryTable(solvedReport(), {70, false, false});
  EXPECT_THAT(table, HasSubstr("1.23M\n  Straight on.\n"));
}

TEST(Text, QueryWithoutResultSaysSo) {
  auto report = collect({kLevel, kQuery});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(view::queryTable(*report, kAscii), HasSubstr("no answer"));
}

TEST(Text, MapShowsTheCourseFromAbove) {
  auto ahead = walk(kAhead, 200);
  auto report = collect({kLevel, kQuery, line(ahead)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string map = view::queryMap(*report, report->queries[0], {46, false, false});
  EXPECT_EQ(map, R"(ahead, from above, 0.75 studs a column; -Z points right



 ::::::::::::::::::::::::::::::::::::::::
 :::::::::::::::::::ooo:::::::::GGGGGG:::
 :::::::::::::::::::o:o:::::::::G::::G:::
 :::::::S************************::::G:::
 :::::::::::::::::::o:o:::::::::G::::G:::
 :::::::::::::::::::o:o:::::::::G::::G:::
 :::::::::::::::::::ooo:::::::::GGGGGG-::
 xxxxxxxxxxxxxxxxxxx
 xxxxxxxxxxxxxxxxxxx
 xxxxxxxxxxxxxxxxxxx
 xxxxxxxxxxxxxxxxxxx
S start  G goal  : part  x kills  ~ moves  = pad, belt, vanishing  * solution
)");
}

TEST(Text, AsciiHoldsNoOtherCharactersAndNoColours) {
  const std::string text = view::textReport(solvedReport(), {kAscii, true});
  for (const char c : text) EXPECT_TRUE(c == '\n' || (c >= 32 && c < 127)) << int(c);
}

TEST(Text, ColoursOnlyWhereAllowed) {
  const view::Report report = solvedReport();
  EXPECT_THAT(view::textReport(report, {{80, false, true}, true}), Not(HasSubstr("\x1b")));
  EXPECT_THAT(view::textReport(report, {{80, true, true}, true}), HasSubstr("\x1b[38;2;"));
}

TEST(Text, LinesKeepToTheWidth) {
  const std::string text = view::textReport(solvedReport(), {{60, false, true}, true});
  size_t start = 0;
  for (size_t end = text.find('\n'); end != text.npos; end = text.find('\n', start)) {
    const std::string row = text.substr(start, end - start);
    // The table needs its columns; the map keeps to the width.
    if (row.find("verdict") == row.npos && row.find("solved") == row.npos &&
        row.find("goal") == row.npos) {
      EXPECT_LE(view::charCount(row), 60u) << row;
    }
    start = end + 1;
  }
}

TEST(Utf8, CutsAtCharactersAndTamesControls) {
  EXPECT_EQ(view::fitted("caf\xc3\xa9 noir", 5, false), "caf\xc3\xa9\xe2\x80\xa6");
  EXPECT_EQ(view::fitted("a\x1b[31mb", 20, false), "a [31mb");
  EXPECT_EQ(view::fitted("\xc3\xa9", 5, true), "?");
  EXPECT_EQ(view::nextChar("\xed\xa0\x80", 0).code, U'\xfffd');
  EXPECT_EQ(view::nextChar("\xc0\xaf", 0).code, U'\xfffd');
}

TEST(Raster, HullOfASquareIsItsCorners) {
  const auto hull = view::convexHull({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}});
  EXPECT_EQ(hull.size(), 4u);
}

TEST(Raster, ShapesOutsideThePictureAreCut) {
  view::Raster raster({0, 0}, {10, 10}, 10, 10, kAscii);
  const view::Ink ink{'#', "#", {}};
  raster.fill({{-1e30f, -1e30f}, {1e30f, -1e30f}, {1e30f, 1e30f}, {-1e30f, 1e30f}}, ink);
  raster.line({-50, 5}, {1e20f, 5}, ink);
  EXPECT_THAT(raster.text(), ::testing::StartsWith("##########\n"));
}

}  // namespace
}  // namespace obby::view_test
