// The exact text of the table and the map.
#include "view/text_report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "course.h"
#include "table/answer_table.h"
#include "table/columns.h"
#include "view/raster.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const table::TerminalTraits kAscii{80, false, false};

std::string queryTable(const view::Report& report, const table::TerminalTraits& terminal) {
  return table::answerTable(view::answersOf(report), terminal);
}

TEST(Text, TableHasOneRowAQuery) {
  const view::Report report = solvedReport();
  const std::string table = queryTable(report, {120, false, false});
  const std::string seconds = fmt::format("{:.2f}", report.queries[0].answer().getTicks() / 60.0);
  EXPECT_EQ(table,
            "query  verdict  from -> to  play time  jumps  found in  reason\n"
            "ahead  solved   s -> Goal      " +
                seconds + " s      0    0.25 s  Straight on.\n");
}

TEST(Text, MismatchTakesTheVerdictsPlace) {
  auto path = walk(kAhead, 200);
  path.root().getTrajectory().setStateHash(1);
  auto report = collect({kLevel, kQuery, line(path), resultLine("solved", 80)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string table = queryTable(*report, kAscii);
  EXPECT_THAT(table, HasSubstr("MISMATCH"));
  EXPECT_THAT(
      table,
      HasSubstr("\n  its solution cannot be reproduced by replaying it: the last state differs"));
}

// The mismatch of an attempt does not affect the answer, so its note comes last.
TEST(Text, AMismatchOfAnAttemptIsShownAfterTheReason) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  left.root().getTrajectory().setStateHash(1);
  const uint32_t ticks = ahead.reader().getTrajectory().getTicks();
  const auto report =
      collect({kLevel, kQuery, line(left), line(ahead), resultLine("solved", ticks)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string table = queryTable(*report, {400, false, false});
  EXPECT_THAT(table, HasSubstr("ahead  solved"));
  EXPECT_THAT(table, HasSubstr("  Straight on. (an attempt cannot be reproduced by replaying it: "
                               "the last state differs"));
}

TEST(Text, NarrowTerminalsGetReasonsOnLinesOfTheirOwn) {
  const std::string table = queryTable(solvedReport(), {70, false, false});
  EXPECT_THAT(table, HasSubstr("0.25 s\n  Straight on.\n"));
}

TEST(Text, QueriesWithOneIdShowTheirLevels) {
  std::string level = kLevel, query = kQuery;
  level.replace(level.find("Course </script><b>"), 19, "Another");
  query.replace(query.find("Course </script><b>"), 19, "Another");
  const auto report = collect({kLevel, kQuery, level, query});
  ASSERT_TRUE(report) << report.error().text();
  const std::string table = queryTable(*report, kAscii);
  EXPECT_THAT(table, HasSubstr("\nahead (Course </script><b>)  not asked in this run"));
  EXPECT_THAT(table, HasSubstr("\nahead (Another)              not asked in this run"));
}

// The causes of failed attempts come last.
TEST(Text, LongReasonsAreShownInFull) {
  const std::string reason =
      "no way found in 12 M steps: the closest came within 3.2 studs of the goal; 71 % of the "
      "attempts fell, 20 % of the attempts were killed by part 7 'Lava'; this does not show that "
      "there is none";
  std::string answer = resultLine("unknown", 0);
  answer.replace(answer.find("Straight on."), 12, reason);
  const auto report = collect({kLevel, kQuery, answer});
  ASSERT_TRUE(report) << report.error().text();
  const std::string narrow = queryTable(*report, kAscii);
  EXPECT_THAT(narrow, HasSubstr("\n  no way found in 12 M steps: the closest came within 3.2 studs "
                                "of the goal; 71\n  % of the attempts fell, "));
  EXPECT_THAT(narrow, ::testing::EndsWith("\n  this does not show that there is none\n"));
  EXPECT_THAT(queryTable(*report, {400, false, false}), HasSubstr("  " + reason + "\n"));
}

TEST(Text, QueryWithoutResultSaysSo) {
  auto report = collect({kLevel, kQuery});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(queryTable(*report, kAscii), HasSubstr("ahead  not asked in this run"));
}

TEST(Text, MapShowsTheCourseFromAbove) {
  auto ahead = walk(kAhead, 200);
  auto report = collect({kLevel, kQuery, line(ahead)});
  ASSERT_TRUE(report) << report.error().text();
  const std::string map = view::queryMap(*report, report->queries[0], {46, false, false});
  EXPECT_EQ(map, R"(ahead, from above, 0.75 studs per column,
-Z to the right



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
S start  G goal  : part  x kills  ~ moves
= jump pad, conveyor or vanishing part
o waypoint  - to avoid  * solution
)");
}

std::vector<std::string> stages(int count) {
  std::vector<std::string> lines = {kLevel};
  for (int i = 1; i <= count; ++i) {
    std::string query = kQuery;
    lines.push_back(query.replace(query.find("ahead"), 5, fmt::format("stage {}", i)));
  }
  return lines;
}

TEST(Text, MapsOfManyQueriesAreDrawnWhenAskedFor) {
  const auto report = collect(stages(7)), four = collect(stages(4));
  ASSERT_TRUE(report) << report.error().text();
  const std::string lower = view::textReport(*four, {kAscii, view::Maps::few});
  EXPECT_THAT(lower, ::testing::HasSubstr("S start")) << "up to six have maps";
  EXPECT_THAT(lower, ::testing::Not(::testing::HasSubstr("For a map")));
  const auto mapsIn = [&](view::Maps maps) {
    const std::string text = view::textReport(*report, {kAscii, maps});
    size_t count = 0;
    for (size_t at = text.find("S start"); at != text.npos; at = text.find("S start", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(mapsIn(view::Maps::none), 0u);
  EXPECT_EQ(mapsIn(view::Maps::few), 0u);
  EXPECT_EQ(mapsIn(view::Maps::all), 7u);
  EXPECT_THAT(view::textReport(*report, {kAscii, view::Maps::few}),
              ::testing::EndsWith("\nFor a map of one query: obby-view --query 'stage 1' FILE\n"));
}

TEST(Text, MapsAreOfTheQueriesThatWereAsked) {
  std::vector<std::string> lines = stages(4);
  std::string answer = resultLine("unknown", 0);
  lines.push_back(answer.replace(answer.find("ahead"), 5, "stage 3"));
  const auto report = collect(lines);
  ASSERT_TRUE(report) << report.error().text();
  const std::string text = view::textReport(*report, {kAscii, view::Maps::few});
  EXPECT_THAT(text, HasSubstr("\n3 other queries were not asked in this run.\n"));
  EXPECT_THAT(text, HasSubstr("\nstage 3, from above"));
  EXPECT_THAT(text, Not(HasSubstr("\nstage 1")));
}

TEST(Text, TrajectoriesWithoutAResultStillCountAsAsked) {
  auto left = walk(kLeft, 300);
  const auto report = collect({kLevel, kQuery, line(left)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(queryTable(*report, kAscii), HasSubstr("ahead  no result"));
}

TEST(Text, LevelsWithoutQueriesAreListed) {
  const auto report = collect(
      {R"({"type":"level","name":"L","parts":[{}]})", R"({"type":"level","parts":[{},{}]})"});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_EQ(view::textReport(*report, {kAscii, view::Maps::few}),
            "No queries.\nLevel L: 1 part\nLevel without a name: 2 parts\n");
}

// Only the keys determine the position of a moving part.
TEST(Text, MapShowsMovingPartsAtTheirStart) {
  const auto report =
      collect({R"({"type":"level","name":"L","spawns":[{}],"parts":[)"
               R"({"position":[0,-0.5,-10],"size":[10,1,30]},)"
               R"({"size":[4,1,4],"motion":{"keys":[{"position":[0,1,-14]},)"
               R"({"time":1,"position":[0,5,-14]}]}}]})",
               R"({"type":"query","id":"q","goal":{"position":[0,2,-20],"size":[4,4,4]}})"});
  ASSERT_TRUE(report) << report.error().text();
  const std::string map = view::queryMap(*report, report->queries[0], {60, false, false});
  size_t start = map.npos, lift = map.npos;  // their first columns
  const size_t legend = map.find("S start");
  for (size_t begin = 0; begin < legend;) {
    const size_t end = map.find('\n', begin);
    const std::string row = map.substr(begin, end - begin);
    start = std::min(start, row.find('S'));
    lift = std::min(lift, row.find('~'));
    begin = end + 1;
  }
  ASSERT_NE(lift, map.npos);
  EXPECT_GT(lift, start + 10);
}

// The simulator has no collider for the goal's part.
TEST(Text, MapShowsAGoalWithoutACollider) {
  const auto goals = [](const char* role) {
    const auto report =
        collect({fmt::format(R"({{"type":"level","name":"L","spawns":[{{}}],"parts":[)"
                             R"({{"position":[0,-0.5,-10],"size":[10,1,30]}},)"
                             R"({{"position":[3,1,-8],"size":[4,1,4],"solid":false{}}}]}})",
                             role),
                 R"({"type":"query","id":"q","goal":{"position":[0,2,-20],"size":[4,4,4]}})"});
    EXPECT_TRUE(report) << report.error().text();
    const std::string map = view::queryMap(*report, report->queries[0], {60, false, false});
    return std::count(map.begin(), map.end(), 'G');
  };
  EXPECT_GT(goals(R"(,"goal":{})"), goals("") + 4);
}

// The tile next to the floor blinks.
TEST(Text, MapMarksPartsAwayAtTheStart) {
  const auto mapOf = [](const char* inverted) {
    const auto report =
        collect({fmt::format(R"({{"type":"level","name":"L","spawns":[{{}}],"parts":[)"
                             R"({{"position":[0,-0.5,-10],"size":[6,1,30]}},)"
                             R"({{"position":[4,0.5,-10],"size":[6,1,6],)"
                             R"("vanish":{{"trigger":"timer","delay":1,"away":1{}}}}}]}})",
                             inverted),
                 R"({"type":"query","id":"q","goal":{"position":[0,2,-20],"size":[4,4,4]}})"});
    EXPECT_TRUE(report) << report.error().text();
    return view::queryMap(*report, report->queries[0], {60, false, false});
  };
  const auto count = [](const std::string& map, char glyph) {  // counts in the map's rows only
    const size_t first = map.find('\n');
    const std::string rows = map.substr(first, map.find("S start") - first);
    return std::count(rows.begin(), rows.end(), glyph);
  };
  const std::string there = mapOf(""), away = mapOf(R"(,"inverted":true)");
  EXPECT_GT(count(there, '='), 20);
  EXPECT_EQ(count(there, ','), 0);
  EXPECT_THAT(there, Not(HasSubstr("absent")));
  EXPECT_EQ(count(away, '='), 0);
  EXPECT_GT(count(away, ','), 5);
  EXPECT_LT(count(away, ','), count(there, '=')) << "the floor below it is seen";
  EXPECT_THAT(away, HasSubstr(", absent at the start"));
}

TEST(Text, AsciiOutputHasNoOtherCharactersAndNoColours) {
  const std::string text = view::textReport(solvedReport(), {kAscii, view::Maps::few});
  for (const char c : text) EXPECT_TRUE(c == '\n' || (c >= 32 && c < 127)) << int(c);
}

TEST(Text, UsesColoursOnlyWhereAllowed) {
  const view::Report report = solvedReport();
  EXPECT_THAT(view::textReport(report, {{80, false, true}, view::Maps::few}),
              Not(HasSubstr("\x1b")));
  EXPECT_THAT(view::textReport(report, {{80, true, true}, view::Maps::few}),
              HasSubstr("\x1b[38;2;"));
}

// Other terminals interpret the numbers of 24-bit colours as bold, blinking, and other colours.
TEST(Text, Uses256ColoursOnTerminalsLimitedToThem) {
  const table::TerminalTraits few{80, true, true, true};
  const std::string text = view::textReport(solvedReport(), {few, view::Maps::few});
  EXPECT_THAT(text, HasSubstr("\x1b[38;5;"));
  EXPECT_THAT(text, HasSubstr("\x1b[48;5;"));
  EXPECT_THAT(text, Not(HasSubstr("8;2;")));
  EXPECT_EQ(table::colored("x", {255, 0, 0}, few), "\x1b[38;5;196mx\x1b[0m");
  EXPECT_EQ(table::colored("x", {18, 21, 28}, few), "\x1b[38;5;233mx\x1b[0m") << "a grey";
  EXPECT_EQ(table::colored("x", {255, 255, 255}, few), "\x1b[38;5;231mx\x1b[0m");
  EXPECT_EQ(table::colored("x", {0, 0, 0}, few), "\x1b[38;5;16mx\x1b[0m");
}

TEST(Terminal, KnowsWhetherItSupports24BitColours) {
  setenv("TERM", "xterm-256color", 1);
  unsetenv("COLORTERM");
  EXPECT_FALSE(table::terminalHasRgb());
  setenv("COLORTERM", "truecolor", 1);
  EXPECT_TRUE(table::terminalHasRgb());
  setenv("COLORTERM", "yes", 1);
  EXPECT_FALSE(table::terminalHasRgb());
  setenv("TERM", "xterm-direct", 1);
  EXPECT_TRUE(table::terminalHasRgb());
}

// 40 columns are the minimum of terminalWidth().
TEST(Text, TheMapFitsANarrowTerminal) {
  const auto mapOf = [](const std::string& id) {
    std::string query = kQuery;
    query.replace(query.find("ahead"), 5, id);
    const auto report = collect({kLevel, query});
    EXPECT_TRUE(report) << report.error().text();
    return view::queryMap(*report, report->queries[0], {40, false, false});
  };
  const std::string map = mapOf("a stage of a name that no narrow terminal can take in a line");
  EXPECT_THAT(map, ::testing::StartsWith("a stage of a name that no narrow ter...,\n"
                                         "from above, "));
  EXPECT_THAT(map, HasSubstr(" studs per column,\n-Z to the right\n"));
  size_t start = 0;
  for (size_t end = map.find('\n'); end != map.npos; end = map.find('\n', start)) {
    EXPECT_LE(end - start, 40u) << map.substr(start, end - start);
    start = end + 1;
  }
  EXPECT_THAT(mapOf("q"), ::testing::StartsWith("q, from above, "));
}

TEST(Text, LinesStayWithinTheWidth) {
  const std::string text = view::textReport(solvedReport(), {{60, false, true}, view::Maps::few});
  size_t start = 0;
  for (size_t end = text.find('\n'); end != text.npos; end = text.find('\n', start)) {
    const std::string row = text.substr(start, end - start);
    // The table is as wide as its columns. The map and its legend stay within the width.
    if (row.find("verdict") == row.npos && row.find("solved") == row.npos) {
      EXPECT_LE(table::columnCount(row), 60u) << row;
    }
    start = end + 1;
  }
}

// Names in places may use any script, and emoji.
TEST(Text, ColumnsAlignForAnyNames) {
  std::string first = kQuery, second = kQuery;
  first.replace(first.find("ahead"), 5, "\u706b\u5c71\U0001f525");
  second.replace(second.find("ahead"), 5, "plain");
  const auto report = collect({kLevel, first, second});
  ASSERT_TRUE(report) << report.error().text();
  const std::string table = queryTable(*report, {120, false, true});
  std::vector<size_t> places;
  for (size_t start = 0; start < table.size();) {
    const size_t end = table.find('\n', start);
    const std::string row = table.substr(start, end - start);
    const size_t at = row.find("not asked");
    if (at != row.npos) places.push_back(table::columnCount(row.substr(0, at)));
    start = end + 1;
  }
  EXPECT_THAT(places, ::testing::ElementsAre(8u, 8u));
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
