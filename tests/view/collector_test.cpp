// A report that is read while it grows equals, at the end, one that is read at once.
#include <gmock/gmock.h>

#include "collecting.h"
#include "view/page.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Collector, ReadingItAfterEachRecordKeepsTheReport) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300), right = walk(kRight, 300, true);
  auto near = walk(kAhead, 40), nearer = walk(kAhead, 60);
  const std::vector<std::string> stream = {kLevel,
                                           line(left),
                                           kQuery,
                                           progressLine(near, {&left}, 9),
                                           progressLine(nearer, {&right, &left}, 5),
                                           line(right),
                                           line(ahead),
                                           kQuery,
                                           resultLine("solved", 200)};
  for (size_t count = 1; count <= stream.size(); ++count) {
    const std::vector<std::string> part(stream.begin(), stream.begin() + ptrdiff_t(count));
    auto collector = strict();
    addAll(collector, part);
    const auto atOnce = collect(part);
    ASSERT_TRUE(atOnce) << atOnce.error().text();
    EXPECT_EQ(view::pageData(collector.report(), {}), view::pageData(*atOnce, {})) << count;
  }
}

TEST(Collector, TrajectoriesKeepTheirSerialThroughProgress) {
  auto left = walk(kLeft, 300), right = walk(kRight, 300, true), near = walk(kAhead, 40);
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, progressLine(near, {&left}, 9)});
  const auto serials = [&] {
    std::vector<uint64_t> out;
    for (const auto& path : collector.report().queries[0].paths) out.push_back(path.serial);
    return out;
  };
  ASSERT_EQ(serials(), (std::vector<uint64_t>{2, 1}));  // the death, then the closest attempt
  addAll(collector, {progressLine(near, {&right, &left}, 9)});
  EXPECT_EQ(serials(), (std::vector<uint64_t>{3, 2, 1}));
  EXPECT_TRUE(collector.report().queries[0].paths[1].played());
}

TEST(Collector, ALateQueryReplaysItsTrajectories) {
  auto ahead = walk(kAhead, 200);
  auto collector = strict();
  addAll(collector, {kLevel, line(ahead)});
  const auto& path = collector.report().queries[0].paths[0];
  const auto before = path.serial;
  EXPECT_EQ(path.playback.outcome, schema::Outcome::RUNNING);  // the goal is still unknown
  addAll(collector, {kQuery});
  EXPECT_EQ(path.playback.outcome, schema::Outcome::GOAL);
  EXPECT_NE(path.serial, before);
}

TEST(Collector, OtherQueriesAreLeftOutFromTheStart) {
  auto collector = strict({"later"});
  addAll(collector, {kLevel, kQuery});
  EXPECT_TRUE(collector.report().queries.empty());
  const Status missing = collector.checkChosen();
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("later"));
}

TEST(Collector, AnUnplayableTrajectoryKeepsTheOthers) {
  auto ahead = walk(kAhead, 200), lost = walk(kAhead, 20);
  lost.root().getTrajectory().setLevel("elsewhere");
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, line(ahead)});
  ASSERT_TRUE(collector.add(recordOf(line(lost))));
  EXPECT_FALSE(collector.update());
  EXPECT_TRUE(collector.update());  // an error is reported once
  ASSERT_EQ(collector.report().queries[0].paths.size(), 1u);
  EXPECT_TRUE(collector.report().queries[0].paths[0].played());
}

TEST(Collector, ARunningSearchShowsItsNumbers) {
  auto near = walk(kAhead, 40);
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, progressLine(near, {}, 9.5f)});
  EXPECT_THAT(view::pageData(collector.report(), {}),
              HasSubstr(R"("progress":{"seconds":0,"steps":"1000","cells":"0","rounds":"0",)"
                        R"("closest":9.5,"waypoints":0})"));
  addAll(collector, {resultLine("unknown", 0)});
  EXPECT_THAT(view::pageData(collector.report(), {}), ::testing::Not(HasSubstr("\"progress\"")));
}

TEST(Collector, TheFirstSolutionIsShownUntilTheImprovedOneArrives) {
  auto near = walk(kAhead, 40), left = walk(kLeft, 300);
  auto first = walk(kAhead, 200, true), improved = walk(kAhead, 200);
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, progressLine(near, {&left}, 9), firstSolutionLine(first)});
  const view::QueryEntry& entry = collector.report().queries[0];
  ASSERT_EQ(entry.paths.size(), 2u) << "the closest attempt is superseded";
  EXPECT_TRUE(entry.paths[0].provisional());
  EXPECT_EQ(entry.paths[0].playback.outcome, schema::Outcome::GOAL);
  EXPECT_THAT(view::pageData(collector.report(), {}), HasSubstr(R"("provisional":true)"));
  const uint64_t serial = entry.paths[0].serial;
  addAll(collector, {firstSolutionLine(first), progressLine(near, {&left}, 9)});
  ASSERT_EQ(entry.paths.size(), 2u);
  EXPECT_EQ(entry.paths[0].serial, serial) << "later progress keeps it";
  EXPECT_EQ(entry.progress->reader().getProgress().getSteps(), 1000u);
  addAll(collector, {line(improved)});
  ASSERT_EQ(entry.paths.size(), 1u);
  EXPECT_FALSE(entry.paths[0].provisional());
  EXPECT_THAT(view::pageData(collector.report(), {}), Not(HasSubstr("provisional")));
  addAll(collector, {firstSolutionLine(first)});
  EXPECT_EQ(entry.paths.size(), 1u) << "the answer came first";
}

TEST(Collector, TheFirstSolutionAloneIsEnough) {
  auto first = walk(kAhead, 200, true);
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, firstSolutionLine(first), resultLine("solved", 200)});
  ASSERT_EQ(collector.report().queries[0].paths.size(), 1u);
  EXPECT_TRUE(collector.report().queries[0].paths[0].played());
}

// Trajectories that cannot be played are dropped, so a renderer may assume that all others were
// played.
TEST(Collector, AfterAnErrorAllRemainingPathsWerePlayed) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  std::string spawnless = kQuery;
  spawnless.insert(spawnless.find(R"("goal")"), R"("start":{"spawn":5},)");
  auto collector = strict();
  for (const std::string& text : {kLevel, line(ahead), line(left), spawnless}) {
    ASSERT_TRUE(collector.add(recordOf(text)));
  }
  const Status updated = collector.update();
  ASSERT_FALSE(updated);
  EXPECT_THAT(updated.error().path, HasSubstr("start"));
  ASSERT_EQ(collector.report().queries.size(), 1u);
  EXPECT_FALSE(collector.report().queries[0].query);
  ASSERT_EQ(collector.report().queries[0].paths.size(), 2u);
  for (const auto& path : collector.report().queries[0].paths) EXPECT_TRUE(path.played());
}

TEST(Collector, AFailingQueryDoesNotStopOthersFromBeingPlayed) {
  auto ahead = walk(kAhead, 200);
  std::string elsewhere = kQuery;
  elsewhere.replace(elsewhere.find("Course"), 6, "Nowhere");
  auto collector = strict();
  for (const std::string& text : {kLevel, elsewhere, kQuery, line(ahead)}) {
    ASSERT_TRUE(collector.add(recordOf(text)));
  }
  EXPECT_FALSE(collector.update());
  ASSERT_EQ(collector.report().queries.size(), 2u);
  ASSERT_EQ(collector.report().queries[1].paths.size(), 1u);
  EXPECT_TRUE(collector.report().queries[1].paths[0].played());
}

// A query that names parts is rewritten before it is compiled. Errors still name its place in the
// stream.
TEST(Collector, AQueryThatNamesPartsIsRefusedAtItsPlace) {
  const std::string query =
      R"({"type":"query","id":"q","start":{"spawn":5},"goal":{"part":"Rock"}})";
  std::vector<std::string> places;
  view::Collector collector([&](const io::Record& record, Error error) -> Status {
    places.push_back(record.place());
    return error;
  });
  ASSERT_TRUE(collector.add(recordOf(kLevel)));
  const io::Record given = recordOf(query);
  ASSERT_FALSE(given.place().empty());
  ASSERT_TRUE(collector.add(given));
  ASSERT_FALSE(collector.update());
  EXPECT_THAT(places, ::testing::ElementsAre(given.place()));
}

}  // namespace
}  // namespace obby::view_test
