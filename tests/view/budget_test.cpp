// Tests how much of a report fits in a page.
#include "view/budget.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "course.h"
#include "io/json_writer.h"
#include "view/page_parts.h"

namespace obby::view_test {
namespace {

// A level without trajectories is shown from its query's start.
TEST(Budget, MotionIsShownFromTheStartOfAQueryOn) {
  std::string late = kQuery;
  late.insert(late.find(R"("goal")"), R"("start":{"tick":9000},)");
  auto report = collect({kLevel, late});
  ASSERT_TRUE(report) << report.error().text();
  const uint32_t min = view::minTicksShown(report->levels[0]);
  EXPECT_EQ(view::ticksShown(*report), (std::vector<uint32_t>{9000 + min}));
}

TEST(Budget, EachLevelShowsTheMotionOfItsOwnTrajectories) {
  auto left = walk(kLeft, 300);
  left.root().getTrajectory().setStartTick(3000);
  const uint32_t ticks = left.reader().getTrajectory().getTicks();
  std::string other = kLevel, last = kLevel, late = kQuery;
  other.replace(other.find("Course </script><b>"), 19, "Another");
  last.replace(last.find("Course </script><b>"), 19, "Nobody's");
  late.replace(late.find("Course </script><b>"), 19, "Another");
  late.insert(late.find(R"("goal")"), R"("start":{"tick":4000000000},)");
  auto report = collect({kLevel, line(left), other, late, last});
  ASSERT_TRUE(report) << report.error().text();
  const uint32_t min = view::minTicksShown(report->levels[0]);
  ASSERT_GT(3000 + ticks, min);
  EXPECT_EQ(view::ticksShown(*report), (std::vector<uint32_t>{3000 + ticks, 600 * 60, min}));
}

// The page cannot know how a part moves after the cut.
TEST(Budget, CutMotionIsReported) {
  const auto notes = [](const char* seconds, const char* tick) {
    std::string level = kLevel, late = kQuery;
    const std::string fan = R"("spin":{"speed":3})";
    level.replace(level.find(fan), fan.size(),
                  std::string(R"("keys":[{"position":[-30,2,-10]},{"time":)") + seconds +
                      R"(,"position":[-30,20,-10]}])");
    late.insert(late.find(R"("goal")"), std::string(R"("start":{"tick":)") + tick + "},");
    const auto report = collect({level, late});
    EXPECT_TRUE(report) << report.error().text();
    return view::budgetFor(*report, view::kPageTarget).notes;
  };
  EXPECT_TRUE(notes("900", "9000").empty()) << "the page does not show that time";
  EXPECT_TRUE(notes("500", "50000").empty()) << "it repeats by then";
  ASSERT_EQ(notes("900", "50000").size(), 1u);
  EXPECT_NE(notes("900", "50000")[0].find("ten minutes"), std::string::npos);
}

TEST(Budget, ThinsAttemptsBeforeAnythingElse) {
  const view::Report report = solvedReport();
  const view::Budget roomy = view::budgetFor(report, view::kPageTarget);
  EXPECT_EQ(roomy.attemptStride, 1u);
  EXPECT_TRUE(roomy.notes.empty());
  const view::Budget tight = view::budgetFor(report, 20000);
  EXPECT_GT(tight.attemptStride, 1u);
  EXPECT_FALSE(tight.notes.empty());
}

// An overestimate would thin out trajectories of large levels without need.
TEST(Budget, CountsALevelByItsWrittenSize) {
  std::string level = R"({"type":"level","name":"large","parts":[{})";
  for (int i = 0; i < 500; ++i) {
    level += R"(,{"name":"Part","source":{"path":"Workspace/Course/Part )" + std::to_string(i) +
             R"("},"evidence":[{"role":"kill","reason":"script K line 3"}]})";
  }
  auto report = collect({level + "]}"});
  ASSERT_TRUE(report) << report.error().text();
  view::PageSizes sizes;
  sizes.add(report->levels[0], 1200);
  io::JsonWriter json;
  view::writeLevel(json, report->levels[0], 1200, 1);
  EXPECT_GT(sizes.fixed, json.text().size() * 3 / 4);
  EXPECT_LT(sizes.fixed, json.text().size() * 5 / 4);
}

// Names and numbers dominate the size of short trajectories.
TEST(Budget, CountsMoreThanTheTicksOfATrajectory) {
  auto left = walk(kLeft, 5);
  auto report = collect({kLevel, kQuery, line(left)});
  ASSERT_TRUE(report) << report.error().text();
  ASSERT_EQ(report->queries[0].paths.size(), 1u);
  view::PageSizes sizes;
  sizes.add(report->queries[0]);
  io::JsonWriter json;
  view::writePath(json, report->queries[0].paths[0], 1);
  EXPECT_GT(sizes.attempts + sizes.whole, json.text().size() * 3 / 4);
  EXPECT_LT(sizes.attempts + sizes.whole, json.text().size() * 3 / 2);
}

// Thousands of moving parts whose motion never repeats have tracks of this size. With --full
// nothing is thinned out.
TEST(Budget, TooMuchMotionIsSampledMoreCoarsely) {
  view::PageSizes sizes;
  sizes.tracks = size_t(1500) << 20;
  EXPECT_EQ(view::budgetFor(sizes, view::kPageTarget).trackStride, 8u);
  sizes.tracks = size_t(3000) << 20;
  EXPECT_EQ(view::budgetFor(sizes, view::kPageTarget).trackStride, 16u);
  EXPECT_EQ(view::budgetFor(sizes, view::kPageLimit).trackStride, 16u);
  EXPECT_EQ(view::budgetFor(sizes, SIZE_MAX).trackStride, 1u);
}

TEST(Budget, CountsEventsOfPartsInATrajectory) {
  auto left = walk(kLeft, 5);
  auto report = collect({kLevel, kQuery, line(left)});
  ASSERT_TRUE(report) << report.error().text();
  ASSERT_EQ(report->queries[0].paths.size(), 1u);
  view::Playback& playback = report->queries[0].paths[0].playback;
  playback.events.assign(100'000, {12345, 4321, false});
  playback.motions.assign(100'000, {12345, 4321, 12345});
  view::PageSizes sizes;
  sizes.add(report->queries[0]);
  io::JsonWriter json;
  view::writePath(json, report->queries[0].paths[0], 1);
  EXPECT_GT(sizes.attempts + sizes.whole, json.text().size() * 3 / 4);
  EXPECT_LT(sizes.attempts + sizes.whole, json.text().size() * 5 / 4);
}

// A larger stride thins out trajectories, but not the tracks of dynamic bodies.
TEST(Budget, LeavesOutAttemptsWhoseDynamicBodiesDoNotFit) {
  view::PageSizes sizes;
  sizes.attempts = 2u << 20;
  sizes.whole = 30u << 20;
  EXPECT_EQ(view::budgetFor(sizes, 20u << 20).attemptsOneOf, 2u);
  EXPECT_EQ(view::budgetFor(sizes, 40u << 20).attemptsOneOf, 1u);
}

}  // namespace
}  // namespace obby::view_test
