// A report that is looked at while it grows is in the end the one that is read at once.
#include <gmock/gmock.h>

#include "course.h"
#include "view/page.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;

view::Collector strict(const std::vector<std::string>& only = {}) {
  return view::Collector([](const io::Record&, Error error) -> Status { return error; }, only);
}

view::Collector withRoom(view::Room room) {
  return view::Collector([](const io::Record&, Error error) -> Status { return error; }, {}, room);
}

void addAll(view::Collector& collector, const std::vector<std::string>& lines) {
  for (const std::string& text : lines) {
    ASSERT_TRUE(collector.add(recordOf(text)));
    ASSERT_TRUE(collector.update());
  }
}

std::string progressLine(io::RecordBuilder& best, const std::vector<io::RecordBuilder*>& deaths,
                         float closest) {
  io::RecordBuilder builder;
  auto p = builder.root().initProgress();
  p.setQuery("ahead");
  p.setClosest(closest);
  p.setSteps(1000);
  p.setBest(best.reader().getTrajectory());
  auto list = p.initDeaths(uint32_t(deaths.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    list.setWithCaveats(i, deaths[i]->reader().getTrajectory());
  }
  return line(builder);
}

TEST(Collector, LookedAtAfterEachRecordItGivesTheSameReport) {
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

TEST(Collector, WaysKeepTheirSerialThroughProgress) {
  auto left = walk(kLeft, 300), right = walk(kRight, 300, true), near = walk(kAhead, 40);
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, progressLine(near, {&left}, 9)});
  const auto serials = [&] {
    std::vector<uint64_t> out;
    for (const auto& path : collector.report().queries[0].paths) out.push_back(path.serial);
    return out;
  };
  ASSERT_EQ(serials(), (std::vector<uint64_t>{2, 1}));  // the death, the closest
  addAll(collector, {progressLine(near, {&right, &left}, 9)});
  EXPECT_EQ(serials(), (std::vector<uint64_t>{3, 2, 1}));
  EXPECT_TRUE(collector.report().queries[0].paths[1].played());
}

TEST(Collector, QueryThatComesLateHasItsWaysPlayedAgain) {
  auto ahead = walk(kAhead, 200);
  auto collector = strict();
  addAll(collector, {kLevel, line(ahead)});
  const auto& path = collector.report().queries[0].paths[0];
  const auto before = path.serial;
  EXPECT_EQ(path.playback.outcome, schema::Outcome::RUNNING);  // no goal is known
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

TEST(Collector, WhatCannotBePlayedLeavesTheRestThere) {
  auto ahead = walk(kAhead, 200), lost = walk(kAhead, 20);
  lost.root().getTrajectory().setLevel("elsewhere");
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, line(ahead)});
  ASSERT_TRUE(collector.add(recordOf(line(lost))));
  EXPECT_FALSE(collector.update());
  EXPECT_TRUE(collector.update());  // it is said once
  ASSERT_EQ(collector.report().queries[0].paths.size(), 1u);
  EXPECT_TRUE(collector.report().queries[0].paths[0].played());
}

TEST(Collector, RunningSearchTellsItsNumbers) {
  auto near = walk(kAhead, 40);
  auto collector = strict();
  addAll(collector, {kLevel, kQuery, progressLine(near, {}, 9.5f)});
  EXPECT_THAT(view::pageData(collector.report(), {}),
              HasSubstr(R"("progress":{"seconds":0,"steps":"1000","cells":"0","rounds":"0",)"
                        R"("closest":9.5,"waypoints":0})"));
  addAll(collector, {resultLine("unknown", 0)});
  EXPECT_THAT(view::pageData(collector.report(), {}), ::testing::Not(HasSubstr("\"progress\"")));
}

// What cannot be played is left out: whoever draws the rest may rely on its being played.
TEST(Collector, AfterAnErrorAllThatIsLeftWasPlayed) {
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

TEST(Collector, OneQueryThatFailsDoesNotKeepOthersFromBeingPlayed) {
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

// A query that names parts is changed before it is compiled; its place in the stream is not.
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

// A stream of a few lines may ask for hours of play.
TEST(Collector, AttemptsBeyondTheRoomAreLeftOutAndSolutionsAreErrors) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  auto collector = withRoom({2 * ticks});
  addAll(collector, {kLevel, kQuery, line(left), line(left)});
  EXPECT_TRUE(collector.report().notes.empty());
  addAll(collector, {line(left), line(left)});
  EXPECT_EQ(collector.report().queries[0].paths.size(), 2u);
  ASSERT_EQ(collector.report().notes.size(), 1u);
  EXPECT_THAT(collector.report().notes[0], HasSubstr("left out"));
  ASSERT_TRUE(collector.add(recordOf(line(ahead))));
  const Status updated = collector.update();
  ASSERT_FALSE(updated);
  EXPECT_THAT(updated.error().message, HasSubstr("too long"));
}

// Of a stream without an end the newest is shown.
TEST(Collector, WhereWaysRollTheOldestLeaveAndAreCounted) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::Room room;
  room.ticks = 10 * ticks;
  room.rolls = true;
  auto collector = withRoom(room);
  addAll(collector, {kLevel, kQuery, line(ahead)});
  const auto& paths = collector.report().queries[0].paths;
  for (uint32_t i = 0; i < 40; ++i) addAll(collector, {line(left)});
  ASSERT_GT(paths.size(), 3u);
  ASSERT_LT(paths.size(), 12u);
  EXPECT_EQ(paths[0].kind, view::PathKind::solution) << "no attempt drives it out";
  for (size_t i = 1; i < paths.size(); ++i) EXPECT_EQ(paths[i].serial, 42 - paths.size() + i);
  for (const auto& path : paths) EXPECT_TRUE(path.played());
  ASSERT_EQ(collector.report().notes.size(), 1u);
  EXPECT_THAT(collector.report().notes[0],
              HasSubstr(" " + std::to_string(41 - paths.size()) + " of the oldest ways"));
  for (uint32_t i = 0; i < 60; ++i) addAll(collector, {line(ahead)});
  EXPECT_EQ(paths[0].kind, view::PathKind::solution);
  EXPECT_EQ(paths.back().serial, 101u);
  EXPECT_THAT(collector.report().notes[0],
              HasSubstr(" " + std::to_string(101 - paths.size()) + " of the oldest ways"));
}

TEST(Collector, WaysThatLeaveMayBeOfAnotherQuery) {
  auto left = walk(kLeft, 300), other = walk(kLeft, 300);
  other.root().getTrajectory().setQuery("other");
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::Room room;
  room.ticks = 8 * ticks;
  room.rolls = true;
  auto collector = withRoom(room);
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 4; ++i) addAll(collector, {line(other)});
  for (uint32_t i = 0; i < 20; ++i) addAll(collector, {line(left)});
  ASSERT_EQ(collector.report().queries.size(), 2u);
  EXPECT_GT(collector.report().queries[0].paths.size(), 3u);
  EXPECT_TRUE(collector.report().queries[1].paths.empty());
}

// Nothing replaces what a search told on its way once it is over.
TEST(Collector, WhatASearchToldLeavesOnceItIsOver) {
  auto left = walk(kLeft, 300), other = walk(kLeft, 300);
  other.root().getTrajectory().setQuery("other");
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::Room room;
  room.ticks = 6 * ticks;
  room.rolls = true;
  auto collector = withRoom(room);
  addAll(collector, {kLevel, kQuery, progressLine(left, {}, 9)});
  for (uint32_t i = 0; i < 20; ++i) addAll(collector, {line(other)});
  ASSERT_EQ(collector.report().queries.size(), 2u);
  EXPECT_EQ(collector.report().queries[0].paths.size(), 1u) << "it runs";
  addAll(collector, {resultLine("unknown", 0)});
  EXPECT_EQ(collector.report().queries[0].paths.size(), 1u);
  for (uint32_t i = 0; i < 20; ++i) addAll(collector, {line(other)});
  EXPECT_TRUE(collector.report().queries[0].paths.empty());
  EXPECT_GT(collector.report().queries[1].paths.size(), 3u);
  EXPECT_EQ(collector.report().notes.size(), 1u);
}

TEST(Collector, AWayThatIsLongerThanAllOfTheRoomDrivesOutNone) {
  auto near = walk(kAhead, 20), left = walk(kLeft, 300);
  view::Room room;
  room.ticks = left.reader().getTrajectory().getTicks();
  room.rolls = true;
  auto collector = withRoom(room);
  addAll(collector, {kLevel, kQuery, line(near), line(left)});
  ASSERT_EQ(collector.report().queries[0].paths.size(), 1u);
  EXPECT_EQ(collector.report().queries[0].paths[0].serial, 1u);
  ASSERT_EQ(collector.report().notes.size(), 1u);
  EXPECT_THAT(collector.report().notes[0], HasSubstr("left out"));
}

TEST(Collector, WhereThereIsNoRoomForRecordsNothingMoreIsTakenIn) {
  std::string second = kLevel;
  second.replace(second.find("Course"), 6, "Second");
  view::Room room;
  room.bytes = 1;
  auto collector = withRoom(room);
  addAll(collector, {kLevel, kQuery});
  ASSERT_EQ(collector.report().queries.size(), 1u) << "of the first level there is no limit";
  EXPECT_TRUE(collector.report().notes.empty());
  addAll(collector, {resultLine("solved", 200), second, kQuery});
  EXPECT_FALSE(collector.report().queries[0].result);
  EXPECT_EQ(collector.report().levels.size(), 1u);
  ASSERT_EQ(collector.report().notes.size(), 1u) << "it is said once";
  EXPECT_THAT(collector.report().notes[0], HasSubstr("no room"));
}

// Answers that replace one another take the room of one.
TEST(Collector, AnAnswerThatComesAgainTakesNoRoom) {
  view::Room room;
  room.bytes = 20'000;
  auto collector = withRoom(room);
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 200; ++i) addAll(collector, {resultLine("solved", 200 + i)});
  EXPECT_EQ(collector.report().queries[0].answer().getTicks(), 399u);
  EXPECT_TRUE(collector.report().notes.empty());
}

// What came and went leaves its room to what comes.
TEST(Collector, ProgressThatIsReplacedTakesNoRoom) {
  auto left = walk(kLeft, 300);
  auto collector = withRoom({1000});
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 40; ++i) {
    auto nearer = walk(kAhead, 40 + i);
    addAll(collector, {progressLine(nearer, {&left}, float(40 - i))});
  }
  EXPECT_TRUE(collector.report().notes.empty());
}

}  // namespace
}  // namespace obby::view_test
