// An earlier answer is tried first. If it still solves the query, it is found at once; otherwise
// the search continues from it.
#include "solve/answer/earlier_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changed_stones.h"
#include "policy/shipped_policy.h"
#include "scenes.h"
#include "solve/methods.h"
#include "untimed.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;
using testing::Not;

FilterOptions stepsOnly(uint64_t maxSteps = 2'000'000) {
  FilterOptions o;
  o.solver.budget.maxSteps = maxSteps;
  o.solver.progressRecords = false;
  return o;
}

std::string answer(const std::string& text, FilterOptions options) {
  const LinesFile file(text);
  const Filtered f = runFilter(file.path(), std::move(options));
  EXPECT_TRUE(f.status) << f.status.error().text();
  return f.output;
}

std::string answerAfter(const std::string& before, const std::string& text, int threads = 1) {
  FilterOptions o = stepsOnly();
  o.earlier = answersIn(before);
  o.threads = threads;
  return answer(text, std::move(o));
}

uint64_t countIn(const std::string& output, const std::string& field) {
  const size_t at = output.find("\"" + field + "\":\"", output.find("\"type\":\"result\""));
  return at == std::string::npos ? 0 : std::stoull(output.substr(at + field.size() + 4));
}

uint64_t stepsOf(const std::string& output) { return countIn(output, "steps"); }
uint64_t roundsOf(const std::string& output) { return countIn(output, "rounds"); }

TEST(EarlierAnswer, StillWorksOnTheSameLevelAtOnce) {
  const std::string before = answer(stonesText(), stepsOnly());
  const std::string again = answerAfter(before, stonesText());
  EXPECT_THAT(again, HasSubstr("An earlier solution still works."));
  EXPECT_LT(stepsOf(again), 400u);  // steps of one trajectory, not of a round
  FilterOptions verify;
  verify.task = Task::verify;
  const LinesFile file(again);
  EXPECT_TRUE(runFilter(file.path(), verify).status);
}

// Straight trajectories fan out over a field. The ends of any two are at least five studs apart.
TEST(EarlierAnswer, KeepsAsManySolutionsAsRequested) {
  constexpr int kTrajectories = 20;
  const std::string field =
      R"({"type":"level","name":"field","parts":[{"name":"Field","position":[0,-0.5,-50],)"
      R"("size":[400,1,120]}],"spawns":[{"position":[0,0,0]}]})"
      "\n"
      R"({"type":"query","id":"q","goal":{"position":[0,2,-60],"size":[400,4,8]}})"
      "\n";
  std::string before;
  for (int i = 0; i < kTrajectories; ++i) {
    const int heading = (65536 + (i - kTrajectories / 2) * 1000) % 65536;
    before += R"({"type":"trajectory","query":"q","level":"field","outcome":"goal","actions":[)"
              R"({"ticks":500,"walk":true,"heading":)" +
              std::to_string(heading) + "}]}\n";
  }
  FilterOptions o = stepsOnly();
  o.earlier = answersIn(before);
  o.solver.budget.solutions = kTrajectories;
  const std::string output = answer(field, std::move(o));
  EXPECT_THAT(output, HasSubstr("\"solutions\":20")) << output.substr(output.size() / 2);
  EXPECT_EQ(roundsOf(output), 0u) << "all were known";
}

TEST(EarlierAnswer, IsContinuedWhereItFails) {
  const std::string before = answer(stonesText(), stepsOnly());
  const std::string cold = answer(fourStones(), stepsOnly());
  const std::string warm = answerAfter(before, fourStones());
  EXPECT_THAT(warm, HasSubstr("\"verdict\":\"solved\""));
  EXPECT_THAT(warm, Not(HasSubstr("still works")));
  EXPECT_LT(roundsOf(warm), roundsOf(cold));
}

TEST(EarlierAnswer, NeverMakesTheUnsolvableSolved) {
  const std::string before = answer(stonesText(), stepsOnly());
  FilterOptions few = stepsOnly(100'000);
  few.earlier = answersIn(before);
  const std::string wall = R"(,"avoid":[{"position":[0,0,-10],"size":[200,200,1]}])";
  EXPECT_THAT(answer(stonesText(wall), few), HasSubstr("\"verdict\":\"unknown\""));
  EXPECT_THAT(answer(stonesText(R"(,"maxJumps":0)"), few), Not(HasSubstr("still works")));
}

TEST(EarlierAnswer, IsIgnoredForAnotherQuery) {
  const std::string before = answer(stonesText(), stepsOnly());
  const std::string other = replaced(stonesText(), "\"id\":\"q\"", "\"id\":\"p\"");
  EXPECT_EQ(withoutTiming(answerAfter(before, other)), withoutTiming(answer(other, stepsOnly())));
}

TEST(EarlierAnswer, GivesTheSameBytesOnAnyNumberOfThreads) {
  const std::string before = answer(stonesText(), stepsOnly());
  const std::string one = withoutTiming(answerAfter(before, fourStones(), 1));
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(one, withoutTiming(answerAfter(before, fourStones(), threads)));
  }
}

TEST(EarlierAnswer, LeadsFurtherAfterAFailedSearch) {
  // The earlier search was cut off after its first round, but the cells that its attempts reached
  // are kept.
  const std::string before = answer(fourStones(), stepsOnly(1));
  ASSERT_THAT(before, HasSubstr("\"verdict\":\"unknown\""));
  EXPECT_LE(roundsOf(answerAfter(before, fourStones())),
            roundsOf(answer(fourStones(), stepsOnly())));
}

TEST(EarlierAnswer, IsRememberedOnRequest) {
  FilterOptions o = stepsOnly();
  o.remember = true;
  o.solver.method = findMethod("auto");
  const LinesFile file(stonesText());
  std::string output;
  io::SourceOptions source;
  source.inputs = {file.path()};
  io::Pipeline pipeline(std::move(source), {"test", "0", 1},
                        io::StreamWriter::toBytes(io::Format::jsonl, &output));
  Filter filter(o, pipeline);
  ASSERT_TRUE(pipeline.runAndFinish([&](const io::Record& r) { return filter.handle(r); }));
  const EarlierAnswers kept = filter.takeEarlier();
  const EarlierAnswers read = answersIn(output);
  const EarlierAnswers::For who{{}, 60, 60};
  ASSERT_GT(kept.trajectoriesOf("stones", "q", who).size(), 1u);
  EXPECT_EQ(kept.trajectoriesOf("stones", "q", who).size(),
            read.trajectoriesOf("stones", "q", who).size());
  EXPECT_TRUE(kept.trajectoriesOf("stones", "p", who).empty());
}

}  // namespace
}  // namespace obby::solve
