// Tests how records are matched, and how records that cannot be shown are handled.
#include "view/report.h"

#include <gmock/gmock.h>

#include "course.h"

namespace obby::view_test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(Report, AnswersBeforeTheirQueryBelongToIt) {
  const view::Report report = solvedReport();
  ASSERT_THAT(report.levels, SizeIs(1));
  ASSERT_THAT(report.queries, SizeIs(1));
  const view::QueryEntry& query = report.queries[0];
  EXPECT_EQ(query.id, "ahead");
  EXPECT_TRUE(query.compiled);
  EXPECT_TRUE(query.result);
  ASSERT_THAT(query.paths, SizeIs(3));
  EXPECT_EQ(query.paths[0].kind, view::PathKind::solution);
  EXPECT_FALSE(query.mismatch());
}

TEST(Report, ReplayGivesThePlaythroughTickByTick) {
  const view::Report report = solvedReport();
  const view::Playback& solution = report.queries[0].paths[0].playback;
  EXPECT_EQ(solution.outcome, schema::Outcome::GOAL);
  EXPECT_EQ(solution.ticks(), report.queries[0].answer().getTicks());
  EXPECT_LT(solution.feet.back().z, -17);
  EXPECT_EQ(solution.mismatch, "");
  bool killed = false, fell = false;
  for (const view::PathEntry& path : report.queries[0].paths) {
    killed =
        killed || (path.playback.outcome == schema::Outcome::KILLED && path.playback.part == 1);
    fell =
        fell || path.playback.outcome == schema::Outcome::FELL || path.playback.feet.back().y < -50;
  }
  EXPECT_TRUE(killed);
  EXPECT_TRUE(fell);
}

TEST(Report, OtherStateHashIsAMismatch) {
  auto path = walk(kAhead, 200);
  auto record = path.root().getTrajectory();
  record.setStateHash(record.getStateHash() ^ 1);
  auto report = collect({kLevel, kQuery, line(path)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_TRUE(report->queries[0].mismatch());
  EXPECT_THAT(report->queries[0].paths[0].playback.mismatch, HasSubstr("last state differs"));
}

TEST(Report, OtherOutcomeIsAMismatch) {
  auto path = walk(kLeft, 300);
  path.root().getTrajectory().setOutcome(schema::Outcome::GOAL);
  auto report = collect({kLevel, kQuery, line(path)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_TRUE(report->queries[0].mismatch());
  EXPECT_THAT(report->queries[0].paths[0].playback.mismatch, HasSubstr("recorded as goal"));
}

TEST(Report, AMismatchNamesEveryOutcome) {
  auto path = walk(kAhead, 200);
  path.root().getTrajectory().setOutcome(schema::Outcome::FORBIDDEN);
  auto report = collect({kLevel, kQuery, line(path)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_EQ(report->queries[0].paths[0].playback.mismatch,
            "recorded as forbidden, replayed as goal");
}

TEST(Report, OtherTicksAreAMismatch) {
  auto path = walk(kAhead, 200);
  auto record = path.root().getTrajectory();
  record.setTicks(record.getTicks() + 1);
  auto report = collect({kLevel, kQuery, line(path)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(report->queries[0].paths[0].playback.mismatch, HasSubstr("ticks"));
}

TEST(Report, QueryWithoutLevelIsAnErrorAtItsLevel) {
  auto report = collect({kQuery});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().path, "level");
}

TEST(Report, ForgivenRecordsAreLeftOutAndTheRestIsShown) {
  std::vector<Error> errors;
  auto path = walk(kAhead, 200);
  path.root().getTrajectory().setLevel("elsewhere");
  auto report = collect({kLevel, kQuery, line(path)}, &errors);
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(errors, SizeIs(1));
  EXPECT_THAT(report->levels, SizeIs(1));
}

TEST(Report, SameLevelTwiceIsOneLevel) {
  auto report = collect({kLevel, kQuery, kLevel, resultLine("unknown", 0)});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(report->levels, SizeIs(1));
  EXPECT_THAT(report->queries, SizeIs(1));
}

// Several versions of a level share a name.
TEST(Report, QueriesBelongToThePrecedingLevelOfTheirName) {
  std::string second = kLevel, other = kLevel;
  second.replace(second.find(R"("size":[10,1,30])"), 16, R"("size":[12,1,30])");
  other.replace(other.find("Course </script><b>"), 19, "Another");
  const auto levelOf = [&](const std::vector<std::string>& levels) {
    std::vector<std::string> lines = levels;
    lines.push_back(kQuery);
    const auto report = collect(lines);
    EXPECT_TRUE(report) << report.error().text();
    EXPECT_THAT(report->levels, SizeIs(3));
    return report->queries[0].level;
  };
  EXPECT_EQ(levelOf({kLevel, second, other}), 1);
  EXPECT_EQ(levelOf({kLevel, second, other, kLevel}), 0);
  EXPECT_EQ(levelOf({other, kLevel, second}), 2);
  EXPECT_EQ(levelOf({kLevel, second, other, kLevel, other}), 1);
}

// A query may omit its level. The query then refers to the level before it in the stream, even if
// that level is a repeated one.
TEST(Report, QueriesAfterARepeatedLevelBelongToIt) {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string query = replaced(kQuery, R"("level":"Course </script><b>",)", "");
  const std::string other = replaced(kLevel, "Course", "Another");
  const std::string elsewhere =
      replaced(query, R"("position":[0,2,-20])", R"("position":[0,2,-16])");
  auto ahead = walk(kAhead, 200);
  auto report = collect({kLevel, query, line(ahead), other, elsewhere, kLevel, query});
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(report->levels, SizeIs(2));
  ASSERT_THAT(report->queries, SizeIs(2));
  EXPECT_EQ(report->queries[0].level, 0);
  EXPECT_FALSE(report->queries[0].mismatch());
  EXPECT_EQ(report->queries[1].level, 1);
  EXPECT_EQ(report->queries[1].reader().getGoal().getPosition().getZ(), -16);
}

TEST(Report, QueriesAfterAnInvalidLevelAreNotOfTheOneBefore) {
  std::vector<Error> errors;
  const std::string bad = R"({"type":"level","name":"Bad","parts":[{"size":[-1,1,1]}]})";
  std::string query = kQuery;
  query.erase(query.find(R"("level":)"), std::string(R"("level":"Course </script><b>",)").size());
  auto report = collect({kLevel, bad, query}, &errors);
  ASSERT_TRUE(report) << report.error().text();
  ASSERT_THAT(errors, SizeIs(2));
  EXPECT_THAT(errors[1].message, HasSubstr("level of this query is not in the stream"));
}

TEST(Report, LastProgressIsShownUntilThereIsASolution) {
  auto best = walk(kAhead, 40);
  const auto progress = [&](float closest) {
    io::RecordBuilder builder;
    auto p = builder.root().initProgress();
    p.setQuery("ahead");
    p.setClosest(closest);
    p.setBest(best.reader().getTrajectory());
    return line(builder);
  };
  auto open = collect({kLevel, kQuery, progress(9), progress(5)});
  ASSERT_TRUE(open) << open.error().text();
  ASSERT_THAT(open->queries[0].paths, SizeIs(1));
  EXPECT_EQ(open->queries[0].paths[0].kind, view::PathKind::closest);
  auto solution = walk(kAhead, 200);
  auto done = collect({kLevel, kQuery, progress(9), line(solution)});
  ASSERT_TRUE(done) << done.error().text();
  ASSERT_THAT(done->queries[0].paths, SizeIs(1));
  EXPECT_EQ(done->queries[0].paths[0].kind, view::PathKind::solution);
}

TEST(Report, UnfinishedSearchesShowTheirProgress) {
  auto trajectory = walk(kAhead, 40);
  io::RecordBuilder builder;
  auto p = builder.root().initProgress();
  p.setQuery("ahead");
  p.setBest(trajectory.reader().getTrajectory());
  p.setNewest(trajectory.reader().getTrajectory());
  p.initDeaths(2);
  p.getDeaths().setWithCaveats(0, trajectory.reader().getTrajectory());
  p.getDeaths().setWithCaveats(1, trajectory.reader().getTrajectory());
  const auto kinds = [](const view::Report& report) {
    std::vector<view::PathKind> result;
    for (const auto& path : report.queries[0].paths) result.push_back(path.kind);
    return result;
  };
  using enum view::PathKind;
  auto open = collect({kLevel, kQuery, line(builder)});
  ASSERT_TRUE(open) << open.error().text();
  EXPECT_EQ(kinds(*open), (std::vector{attempt, attempt, closest, newest}));
  EXPECT_EQ(open->queries[0].paths[1].reader().getTicks(), 40u);
  auto attempted = walk(kAhead, 30);
  auto unknown = collect({kLevel, kQuery, line(builder), line(attempted)});
  ASSERT_TRUE(unknown) << unknown.error().text();
  EXPECT_EQ(kinds(*unknown), (std::vector{attempt, closest}));
}

TEST(Report, SelectsQueriesById) {
  std::string other = kQuery;
  other.replace(other.find("ahead"), 5, "later");
  auto report = collect({kLevel, kQuery, other}, nullptr, {"later"});
  ASSERT_TRUE(report) << report.error().text();
  ASSERT_THAT(report->queries, SizeIs(1));
  EXPECT_EQ(report->queries[0].id, "later");
  auto none = collect({kLevel, kQuery}, nullptr, {"never"});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("never"));
}

}  // namespace
}  // namespace obby::view_test
