// The whole search gives the expected results, which depend only on its inputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"
#include "solve/methods.h"
#include "solve/search/methods/go_explore.h"
#include "untimed.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;

FilterOptions searchStepsOnly(uint64_t maxSteps = 400'000, int threads = 2) {
  FilterOptions o;
  o.threads = threads;
  o.solver.budget.maxSteps = maxSteps;
  o.solver.progressRecords = false;
  return o;
}

// An avoid region across the stones, which makes the query unsolvable.
constexpr const char* kWall = R"(,"avoid":[{"position":[0,0,-10],"size":[200,200,1]}])";

struct Answer {
  std::vector<io::RecordBuilder> trajectories;
  io::RecordBuilder result;
};

Answer answerOf(const std::string& output) {
  Answer a;
  size_t at = 0;
  while (at < output.size()) {
    const size_t end = output.find('\n', at);
    auto record = io::recordFromJson(output.substr(at, end - at));
    EXPECT_TRUE(record) << record.error().text();
    if (record->reader().isTrajectory())
      a.trajectories.push_back(*std::move(record));
    else if (record->reader().isResult())
      a.result = *std::move(record);
    at = end + 1;
  }
  return a;
}

Filtered solve(const std::string& text, FilterOptions options) {
  const LinesFile file(text);
  return runFilter(file.path(), std::move(options));
}

TEST(Search, SolvesTheSteppingStonesAndEveryTrajectoryReplays) {
  const Filtered f = solve(stonesText(), searchStepsOnly());
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved, 1u);
  Answer a = answerOf(f.output);
  const auto result = a.result.reader().getResult();
  EXPECT_EQ(result.getVerdict(), schema::Verdict::SOLVED);
  EXPECT_EQ(result.getSolutions(), 1u);
  ASSERT_GT(a.trajectories.size(), 4u);
  EXPECT_EQ(a.trajectories[0].reader().getTrajectory().getOutcome(), schema::Outcome::GOAL);
  EXPECT_EQ(a.trajectories[0].reader().getTrajectory().getTicks(), result.getTicks());
  FilterOptions verify;
  verify.task = Task::verify;
  const Filtered checked = solve(f.output, verify);
  EXPECT_TRUE(checked.status) << checked.status.error().text();
  EXPECT_EQ(checked.counts.verified, a.trajectories.size());
}

TEST(Search, ATamperedStreamFailsVerification) {
  Filtered f = solve(stonesText(), searchStepsOnly());
  const size_t at = f.output.find("\"heading\":");
  ASSERT_NE(at, std::string::npos);
  f.output.insert(at + 10, "1");
  FilterOptions verify;
  verify.task = Task::verify;
  EXPECT_FALSE(solve(f.output, verify).status);
}

TEST(Search, SameBytesForAnyNumberOfThreads) {
  for (const char* more : {"", R"(,"waypoints":[{"region":{"position":[3,2,-16]},"maxJumps":2}])",
                           R"(,"maxJumps":2,"timeLimit":5)", R"(,"maxJumps":1)"}) {
    std::string expected;
    for (const int threads : {1, 2, 3, 8}) {
      const Filtered f = solve(stonesText(more), searchStepsOnly(120'000, threads));
      ASSERT_TRUE(f.status) << f.status.error().text();
      if (expected.empty()) expected = withoutTiming(f.output);
      EXPECT_EQ(withoutTiming(f.output), expected) << threads << " threads, query" << more;
    }
  }
}

TEST(Search, SameBytesForAnyNumberOfThreadsOnTheLevelsOfTheSuite) {
  for (const char* name : {"kill-checkerboard", "vanishing-run", "sliding-planks"}) {
    std::string expected;
    for (const int threads : {1, 3}) {
      const Filtered f = runFilter(std::string(OBBY_SOURCE_DIR "/levels/") + name + ".jsonl",
                                   searchStepsOnly(40'000, threads));
      ASSERT_TRUE(f.status) << f.status.error().text();
      if (expected.empty()) expected = withoutTiming(f.output);
      EXPECT_EQ(withoutTiming(f.output), expected) << threads << " threads, " << name;
    }
  }
}

TEST(Search, AnotherSeedGivesAnotherSearchWithTheSameVerdict) {
  FilterOptions other = searchStepsOnly();
  other.solver.budget.seed = 99;
  const Filtered a = solve(stonesText(), searchStepsOnly()), b = solve(stonesText(), other);
  EXPECT_EQ(b.counts.solved, 1u);
  EXPECT_NE(withoutTiming(a.output), withoutTiming(b.output));
}

// The gap is wider than any jump, but too narrow for the bound on reach to prove this.
TEST(Search, AGapTooWideIsUnknownWithEvidence) {
  const std::string text =
      R"({"type":"level","name":"gap","physics":{"fallenPartsHeight":-40},"parts":[)"
      R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
      R"({"name":"B","position":[0,-0.5,-27],"size":[8,1,8]},)"
      R"({"name":"Lava","position":[6,0,-4],"size":[2,2,8],"kill":{}}],)"
      R"("spawns":[{"position":[0,0,-2]}]})"
      "\n"
      R"({"type":"query","id":"q","goal":{"position":[0,2,-27],"size":[8,4,8]}})"
      "\n";
  const Filtered f = solve(text, searchStepsOnly());
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.unknown, 1u);
  Answer a = answerOf(f.output);
  const auto result = a.result.reader().getResult();
  EXPECT_EQ(result.getVerdict(), schema::Verdict::UNKNOWN);
  EXPECT_GE(result.getSteps(), 400'000u);
  EXPECT_GT(result.getClosest(), 1);
  EXPECT_LT(result.getClosest(), 21);
  EXPECT_THAT(result.getReason().cStr(), HasSubstr(" % of attempts fell"));
  EXPECT_THAT(result.getReason().cStr(),
              testing::EndsWith(" This does not prove that no solution exists."));
  EXPECT_THAT(f.output, HasSubstr("\"status\":\"budget\""));
  uint64_t ends = 0;
  bool lava = false;
  for (const auto tally : result.getEnds()) {
    ends += tally.getCount();
    lava = lava || (tally.getOutcome() == schema::Outcome::KILLED && tally.getPart() == 2);
  }
  EXPECT_GE(ends, result.getRounds() * GoExploreSettings{}.rollouts);
  EXPECT_TRUE(lava);
  // The closest attempt comes first, at the distance that the result states.
  ASSERT_FALSE(a.trajectories.empty());
  const auto end = a.trajectories[0].reader().getTrajectory().getEndPosition();
  const float off =
      geom::distance(boxAt({0, 2, -27}, {8, 4, 8}).region, {end.getX(), end.getY(), end.getZ()});
  EXPECT_NEAR(off, result.getClosest(), 1e-3);
}

TEST(Search, HonoursEveryConstraintAtOnce) {
  const std::string more =
      R"(,"waypoints":[{"region":{"position":[3,2,-5],"size":[1,4,1]},"maxJumps":0},)"
      R"({"region":{"position":[-3,2,-16],"size":[1,4,1]},"maxJumps":1}],)"
      R"("avoid":[{"position":[0,3,-16],"size":[2,6,8]}],"maxJumps":2,"timeLimit":6)";
  const Filtered f = solve(stonesText(more), searchStepsOnly(2'000'000));
  ASSERT_TRUE(f.status) << f.status.error().text();
  ASSERT_EQ(f.counts.solved, 1u);
  Answer a = answerOf(f.output);
  const auto t = a.trajectories[0].reader().getTrajectory();
  EXPECT_EQ(t.getWaypoints(), 2u);
  EXPECT_LE(t.getJumps(), 2u);
  EXPECT_LE(t.getTicks(), 360u);
}

TEST(Search, FindsSeveralDistinctSolutionsShortestFirst) {
  // A pillar on the middle stone makes left and right distinct.
  std::string text = stonesText();
  text.insert(text.find("],\"spawns\""),
              R"(,{"name":"Pillar","position":[0,10,-16],"size":[3,20,8]})");
  FilterOptions o = searchStepsOnly(3'000'000);
  o.solver.budget.solutions = 3;
  const Filtered f = solve(text, o);
  ASSERT_TRUE(f.status) << f.status.error().text();
  Answer a = answerOf(f.output);
  ASSERT_EQ(a.result.reader().getResult().getSolutions(), 3u);
  uint32_t ticks = 0;
  for (int i = 0; i < 3; ++i) {
    const auto t = a.trajectories[size_t(i)].reader().getTrajectory();
    EXPECT_EQ(t.getOutcome(), schema::Outcome::GOAL);
    EXPECT_EQ(t.getIndex(), uint32_t(i));
    EXPECT_GE(t.getTicks(), ticks);
    ticks = t.getTicks();
  }
}

TEST(Search, ShowsAsManyAttemptsAsAskedAndTheyDiffer) {
  FilterOptions o = searchStepsOnly(200'000);
  o.solver.budget.attempts = 5;
  Answer a = answerOf(solve(stonesText(kWall), o).output);
  EXPECT_EQ(a.trajectories.size(), 5u);
  for (size_t i = 1; i < a.trajectories.size(); ++i) {
    EXPECT_NE(a.trajectories[i].reader().getTrajectory().getStateHash(),
              a.trajectories[i - 1].reader().getTrajectory().getStateHash());
  }
  o.solver.budget.attempts = 0;
  EXPECT_TRUE(answerOf(solve(stonesText(kWall), o).output).trajectories.empty());
}

TEST(Search, StopsSoonOnRequest) {
  std::atomic<bool> stop{true};
  FilterOptions o = searchStepsOnly(1ull << 60);
  o.solver.budget.stop = &stop;
  const Filtered f = solve(stonesText(kWall), o);
  Answer a = answerOf(f.output);
  EXPECT_EQ(a.result.reader().getResult().getRounds(), 1u);
  EXPECT_THAT(a.result.reader().getResult().getReason().cStr(), HasSubstr("interrupted"));
}

TEST(Search, ProgressCarriesTheBestAttempt) {
  FilterOptions o = searchStepsOnly(1ull << 60);
  o.solver.progressRecords = true;
  o.solver.budget.seconds = 0.7;
  const Filtered f = solve(stonesText(kWall), o);
  EXPECT_THAT(f.output, HasSubstr("\"type\":\"progress\""));
  EXPECT_THAT(f.output, HasSubstr("\"best\":{"));
}

}  // namespace
}  // namespace obby::solve
