// A collector that has used up its budget drops new records or discards older ones.
#include <gmock/gmock.h>

#include "collecting.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;

// Returns the same trajectory, with one action run for each tick.
std::string inRunsOfATick(const io::RecordBuilder& trajectory) {
  io::RecordBuilder out(trajectory.reader());
  const auto held = trajectory.reader().getTrajectory();
  auto runs = out.root().getTrajectory().initActions(held.getTicks());
  for (uint32_t i = 0; i < runs.size(); ++i) {
    runs.setWithCaveats(i, held.getActions()[0]);
    runs[i].setTicks(1);
  }
  return line(out);
}

// A stream of a few lines may ask for hours of play.
TEST(Collector, DropsAttemptsBeyondTheBudgetAndRefusesSolutions) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  auto collector = withBudget({2 * ticks});
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

// An endless stream shows its newest trajectories.
TEST(Collector, ARollingBudgetDropsAndCountsTheOldestTrajectories) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::PageBudget space;
  space.ticks = 10 * ticks;
  space.rolls = true;
  auto collector = withBudget(space);
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
              HasSubstr(" " + std::to_string(41 - paths.size()) + " of the oldest trajectories"));
  for (uint32_t i = 0; i < 60; ++i) addAll(collector, {line(ahead)});
  EXPECT_EQ(paths[0].kind, view::PathKind::solution);
  EXPECT_EQ(paths.back().serial, 101u);
  EXPECT_THAT(collector.report().notes[0],
              HasSubstr(" " + std::to_string(101 - paths.size()) + " of the oldest trajectories"));
}

// If the action changes at every tick, the actions take as much memory as the positions.
TEST(Collector, ActionRunsCountTowardsTheBudget) {
  const auto left = walk(kLeft, 300);
  const std::string restless = inRunsOfATick(left);
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::PageBudget space;
  space.ticks = 4 * ticks;
  space.runTicks = 1;
  auto collector = withBudget(space);
  addAll(collector, {kLevel, kQuery, restless, restless});
  EXPECT_TRUE(collector.report().notes.empty());
  addAll(collector, {restless});
  EXPECT_EQ(collector.report().queries[0].paths.size(), 2u);
  ASSERT_EQ(collector.report().notes.size(), 1u);
  EXPECT_THAT(collector.report().notes[0], HasSubstr("left out"));
}

TEST(Collector, ActionRunsOfDroppedTrajectoriesFreeTheirBudget) {
  const auto left = walk(kLeft, 300);
  const std::string restless = inRunsOfATick(left);
  view::PageBudget space;
  space.ticks = 4 * (left.reader().getTrajectory().getTicks() + 1);
  space.runTicks = 1;
  space.rolls = true;
  auto collector = withBudget(space);
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 20; ++i) addAll(collector, {restless});
  ASSERT_FALSE(collector.report().queries[0].paths.empty());
  EXPECT_EQ(collector.report().queries[0].paths.back().serial, 20u);
  ASSERT_EQ(collector.report().notes.size(), 1u);
  EXPECT_THAT(collector.report().notes[0], HasSubstr("of the oldest trajectories"));
}

TEST(Collector, DroppedTrajectoriesMayBeOfAnotherQuery) {
  auto left = walk(kLeft, 300), other = walk(kLeft, 300);
  other.root().getTrajectory().setQuery("other");
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::PageBudget space;
  space.ticks = 8 * ticks;
  space.rolls = true;
  auto collector = withBudget(space);
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 4; ++i) addAll(collector, {line(other)});
  for (uint32_t i = 0; i < 20; ++i) addAll(collector, {line(left)});
  ASSERT_EQ(collector.report().queries.size(), 2u);
  EXPECT_GT(collector.report().queries[0].paths.size(), 3u);
  EXPECT_TRUE(collector.report().queries[1].paths.empty());
}

// Progress of a finished search is no longer replaced.
TEST(Collector, ProgressOfAFinishedSearchCanBeDropped) {
  auto left = walk(kLeft, 300), other = walk(kLeft, 300);
  other.root().getTrajectory().setQuery("other");
  const size_t ticks = left.reader().getTrajectory().getTicks() + 1;
  view::PageBudget space;
  space.ticks = 6 * ticks;
  space.rolls = true;
  auto collector = withBudget(space);
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

TEST(Collector, ATrajectoryAboveTheWholeBudgetDropsNoOthers) {
  auto near = walk(kAhead, 20), left = walk(kLeft, 300);
  view::PageBudget space;
  space.ticks = left.reader().getTrajectory().getTicks();
  space.rolls = true;
  auto collector = withBudget(space);
  addAll(collector, {kLevel, kQuery, line(near), line(left)});
  ASSERT_EQ(collector.report().queries[0].paths.size(), 1u);
  EXPECT_EQ(collector.report().queries[0].paths[0].serial, 1u);
  ASSERT_EQ(collector.report().notes.size(), 1u);
  EXPECT_THAT(collector.report().notes[0], HasSubstr("left out"));
}

TEST(Collector, DropsAllFurtherRecordsWithoutABudget) {
  std::string second = kLevel;
  second.replace(second.find("Course"), 6, "Second");
  view::PageBudget space;
  space.bytes = 1;
  auto collector = withBudget(space);
  addAll(collector, {kLevel, kQuery});
  ASSERT_EQ(collector.report().queries.size(), 1u) << "of the first level there is no limit";
  EXPECT_TRUE(collector.report().notes.empty());
  addAll(collector, {resultLine("solved", 200), second, kQuery});
  EXPECT_FALSE(collector.report().queries[0].result);
  EXPECT_EQ(collector.report().levels.size(), 1u);
  ASSERT_EQ(collector.report().notes.size(), 1u) << "it is said once";
  EXPECT_THAT(collector.report().notes[0], HasSubstr("memory budget is full"));
  // A file has no such budget, as the note says.
  EXPECT_THAT(collector.report().notes[0], HasSubstr("view it without --live"));
  auto whole = strict();
  addAll(whole, {kLevel, kQuery, resultLine("solved", 200), second});
  EXPECT_TRUE(whole.report().queries[0].result);
  EXPECT_EQ(whole.report().levels.size(), 2u);
}

// Answers that replace one another take the memory of one.
TEST(Collector, ARepeatedAnswerTakesNoBudget) {
  view::PageBudget space;
  space.bytes = 20'000;
  auto collector = withBudget(space);
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 200; ++i) addAll(collector, {resultLine("solved", 200 + i)});
  EXPECT_EQ(collector.report().queries[0].answer().getTicks(), 399u);
  EXPECT_TRUE(collector.report().notes.empty());
}

// Replaced progress frees its budget for new progress.
TEST(Collector, ReplacedProgressTakesNoBudget) {
  auto left = walk(kLeft, 300);
  auto collector = withBudget({1000});
  addAll(collector, {kLevel, kQuery});
  for (uint32_t i = 0; i < 40; ++i) {
    auto nearer = walk(kAhead, 40 + i);
    addAll(collector, {progressLine(nearer, {&left}, float(40 - i))});
  }
  EXPECT_TRUE(collector.report().notes.empty());
}

}  // namespace
}  // namespace obby::view_test
