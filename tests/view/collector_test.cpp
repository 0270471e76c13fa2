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

}  // namespace
}  // namespace obby::view_test
