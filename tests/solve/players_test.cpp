// A query for several players gives one answer for each, and one result for all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "scenes.h"
#include "solve/model/retimed.h"
#include "solve/players/player_text.h"

namespace obby::solve {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

FilterOptions quickly(uint64_t steps = 300'000) {
  FilterOptions o;
  o.solver.budget.maxSteps = steps;
  o.solver.budget.attempts = 0;
  o.solver.progressRecords = false;
  return o;
}

std::string playersAnswer(const std::string& text, FilterOptions options = quickly()) {
  const LinesFile file(text);
  const Filtered out = runFilter(file.path(), std::move(options));
  EXPECT_TRUE(out.status) << out.status.error().text();
  return out.output;
}

// Returns the lines of records of this type.
std::vector<std::string> lines(const std::string& text, const std::string& type) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(R"({"type":")" + type)) found.push_back(line);
  }
  return found;
}

std::string resultOf(const std::string& text) {
  const auto results = lines(text, "result");
  EXPECT_EQ(results.size(), 1u);
  return results.empty() ? "" : results[0];
}

Filtered checked(const std::string& text) {
  FilterOptions o;
  o.task = Task::verify;
  const LinesFile file(text);
  return runFilter(file.path(), std::move(o));
}

// Returns a level with a ledge. The place's own body has short legs and cannot climb it, but an R6
// body can.
std::string ledge(const std::string& more) {
  return std::string(
             R"({"type":"level","name":"ledge","physics":{"fallenPartsHeight":-40,"hipHeight":0.5,)"
             R"("headBottom":2.5,"bodyTop":3.5},"parts":[)"
             R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
             R"({"name":"B","position":[0,4.3,-12],"size":[8,8.6,8]}],)"
             R"("spawns":[{"position":[0,0,-4]}]})"
             "\n") +
         R"({"type":"query","id":"q","goal":{"position":[0,9.6,-12],"size":[8,2,8]})" + more +
         "}\n";
}

TEST(Players, EachGetsAnAnswerAndANamedTrajectory) {
  const std::string out =
      playersAnswer(stonesText(R"(,"bodies":["r6","r15"],"frameRates":[30,144])"));
  const auto found = lines(out, "trajectory");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_THAT(found[0], HasSubstr(R"("body":"r6","frameRate":30)"));
  EXPECT_THAT(found[3], HasSubstr(R"("body":"r15","frameRate":144)"));
  EXPECT_THAT(found[3], HasSubstr(R"("index":3)"));
  const std::string result = resultOf(out);
  EXPECT_THAT(result, HasSubstr(R"("verdict":"solved","solutions":4)"));
  EXPECT_THAT(
      result,
      HasSubstr(R"("reason":"Solved for R6 and R15 at 30 and 144 frames a second. R6 at 30)"));
  EXPECT_THAT(result, HasSubstr(R"("players":[{"body":"r6","frameRate":30,"verdict":"solved")"));
  EXPECT_EQ(checked(out).counts.verified, 4u);
}

TEST(Players, ATrajectoryReplaysOnlyAsItsPlayer) {
  std::string out = playersAnswer(stonesText(R"(,"frameRates":[30])"));
  const size_t at = out.find(R"("frameRate":30,"verdict")");
  const size_t own = out.find(R"("frameRate":30)");
  ASSERT_LT(own, at);
  out.replace(own, 14, R"("frameRate":60)");
  EXPECT_FALSE(checked(out).status);
}

TEST(Players, AFailingPlayerDecidesTheVerdict) {
  const std::string out = playersAnswer(ledge(R"(,"bodies":["r6","place"])"));
  const std::string result = resultOf(out);
  EXPECT_THAT(result, HasSubstr(R"("verdict":"unreachable")"));
  EXPECT_THAT(result, HasSubstr("Solved for R6 at 60 frames a second; unreachable for the place's "
                                "body at 60 frames a second. The place's body at 60 frames a "
                                "second: No player can reach the goal."));
  EXPECT_THAT(result, HasSubstr(R"("cut":{)"));
  EXPECT_EQ(checked(out).counts.verified, 1u);
}

TEST(Players, StartAtTheSameTimeOfTheLevelsClock) {
  const std::string out =
      playersAnswer(stonesText(R"(,"start":{"spawn":0,"tick":90},"frameRates":[60,240])"));
  const auto found = lines(out, "trajectory");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_THAT(found[0], HasSubstr(R"("startTick":90)"));
  EXPECT_THAT(found[1], HasSubstr(R"("startTick":360)"));
  EXPECT_EQ(checked(out).counts.verified, 2u);
}

TEST(Players, CommandLinePlayersReplaceTheQuerysPlayers) {
  FilterOptions o = quickly();
  o.players = *askedPlayers({"r6,r15", "r6"}, {"each"}, false);
  const std::string out = playersAnswer(stonesText(R"(,"bodies":["place"])"), std::move(o));
  EXPECT_THAT(out, HasSubstr(R"("bodies":["r6","r15"],"frameRates":[30,60,120,144,240])"));
  EXPECT_EQ(lines(out, "trajectory").size(), 10u);
}

TEST(Players, EachBodyMeansAllThatThePlaceAllows) {
  const auto bodies = [](std::vector<std::string> admitted) {
    io::RecordBuilder level, query;
    auto list = level.root().initLevel().initBodies(uint32_t(admitted.size()));
    for (uint32_t i = 0; i < list.size(); ++i) list.set(i, admitted[i]);
    query.root().initQuery();
    const io::Record asked =
        withPlayers(level.reader().getLevel(), *askedPlayers({"each"}, {}, false),
                    io::Record(std::move(query)));
    std::vector<std::string> names;
    for (const auto name : asked.reader().getQuery().getBodies()) names.emplace_back(name.cStr());
    return names;
  };
  EXPECT_THAT(bodies({}), ElementsAre("r6", "r15"));
  EXPECT_THAT(bodies({"r15", "r6"}), ElementsAre("r15", "r6"));
  EXPECT_THAT(bodies({"r15"}), ElementsAre("place"));
}

TEST(Players, AnswersDoNotDependOnThreads) {
  const std::string text = stonesText(R"(,"bodies":["r6","r15"],"frameRates":[30,240])");
  const auto trajectories = [&](int threads) {
    FilterOptions o = quickly();
    o.threads = threads;
    return lines(playersAnswer(text, std::move(o)), "trajectory");
  };
  EXPECT_EQ(trajectories(1), trajectories(3));
}

TEST(SameKeys, SolveTheQueryForEveryPlayer) {
  const std::string out = playersAnswer(
      stonesText(R"(,"bodies":["r6","r15"],"frameRates":[60,30,144],"sameKeys":true)"));
  EXPECT_THAT(resultOf(out),
              HasSubstr(R"("reason":"The same key presses solve it for R6 and R15 at)"));
  EXPECT_EQ(lines(out, "trajectory").size(), 6u);
  EXPECT_EQ(checked(out).counts.verified, 6u);
}

TEST(SameKeys, AreVerifiedForEveryPlayer) {
  // These keys solve the query at 30 frames a second for the R6 body. The changed answer claims
  // them for the place's body, too.
  std::string out = playersAnswer(ledge(R"(,"bodies":["r6"],"frameRates":[30])"));
  const std::string asked = R"("bodies":["r6"],"frameRates":[30])";
  ASSERT_NE(out.find(asked), std::string::npos);
  EXPECT_TRUE(checked(out).status);
  out.replace(out.find(asked), asked.size(),
              R"("bodies":["r6","place"],"frameRates":[30],"sameKeys":true)");
  const Filtered check = checked(out);
  ASSERT_FALSE(check.status);
  EXPECT_THAT(check.status.error().text(),
              HasSubstr("the same key presses do not reach the goal with the place's body at 30"));
}

TEST(SameKeys, AreNotSearchedIfOnePlayerCannot) {
  const std::string out = playersAnswer(ledge(R"(,"bodies":["r6","place"],"sameKeys":true)"));
  EXPECT_THAT(resultOf(out), HasSubstr(R"("verdict":"unreachable")"));
  EXPECT_THAT(resultOf(out), HasSubstr("Unreachable for the place's body at 60 frames a second."));
  EXPECT_EQ(lines(out, "trajectory").size(), 0u);
}

FilterOptions improving() {
  FilterOptions o = quickly(2'000'000);
  o.solver.preference = findPreference("natural");
  o.solver.improveSteps = 200'000;
  return o;
}

TEST(SharedKeys, ReplaceTheSolutionsOfImprovedAnswers) {
  const std::string out =
      playersAnswer(stonesText(R"(,"bodies":["r6","r15"],"frameRates":[60,30,144])"), improving());
  EXPECT_THAT(resultOf(out),
              HasSubstr(R"("reason":"The same key presses solve it for R6 and R15 at)"));
  EXPECT_EQ(lines(out, "trajectory").size(), 6u);
  EXPECT_EQ(checked(out).counts.verified, 6u);
}

// A wall with a low passage on the right, for the short body of the place alone, and a ledge on the
// left that only an R6 body can climb, with no time to try both.
std::string twoRoutes() {
  return R"({"type":"level","name":"two routes","physics":{"fallenPartsHeight":-40,"hipHeight":0.5,)"
         R"("headBottom":2.5,"bodyTop":3.5},"parts":[)"
         R"({"name":"Floor","position":[0,-0.5,-12],"size":[24,1,32]},)"
         R"({"name":"Ledge","position":[-6,4.3,-12],"size":[12,8.6,4]},)"
         R"({"name":"Wall","position":[6,23.6,-12],"size":[12,40,4]}],)"
         R"("spawns":[{"position":[0,0,-4]}]})"
         "\n"
         R"({"type":"query","id":"q","goal":{"position":[0,2,-22],"size":[24,4,8]},)"
         R"("timeLimit":1.1,"bodies":["r6","place"]})"
         "\n";
}

TEST(SharedKeys, AreNotNeeded) {
  const std::string out = playersAnswer(twoRoutes(), improving());
  EXPECT_THAT(resultOf(out), HasSubstr(R"("reason":"Solved for R6 and the place's body at 60)"));
  EXPECT_EQ(lines(out, "trajectory").size(), 2u);
  EXPECT_EQ(checked(out).counts.verified, 2u);
}

TEST(Retimed, KeysRoundToThePlayersNextTick) {
  const sim::Action walk{100, true, false}, jump{100, true, true};
  const ActionRuns runs{{walk, 5}, {jump, 1}, {walk, 10}};
  const auto ticks = [](const ActionRuns& w) {
    std::vector<uint32_t> result;
    for (const sim::ActionRun& run : w) result.push_back(run.ticks);
    return result;
  };
  EXPECT_THAT(ticks(retimed(runs, 30, 240)), ElementsAre(40u, 8u, 80u));
  EXPECT_THAT(ticks(retimed(runs, 30, 144)), ElementsAre(24u, 5u, 48u));
  // The jump begins and ends between two ticks.
  EXPECT_THAT(ticks(retimed(runs, 240, 60)), ElementsAre(2u, 2u));
}

TEST(PlayersText, NamesPlayersWithAndWithoutASolution) {
  constexpr auto kSolved = schema::Verdict::SOLVED, kNot = schema::Verdict::UNREACHABLE,
                 kUnknown = schema::Verdict::UNKNOWN;
  EXPECT_EQ(playersText({{"r6", 60, kSolved}, {"r15", 60, kSolved}}, true),
            "Solved for R6 and R15 at 60 frames a second.");
  EXPECT_EQ(playersText({{"", 30, kNot}, {"", 60, kSolved}, {"", 240, kUnknown}}, false),
            "Solved at 60 frames a second; unreachable at 30 frames a second; no solution found at "
            "240 frames a second.");
  EXPECT_EQ(playersText({{"r6", 30, kSolved}, {"r6", 60, kSolved}, {"r15", 60, kSolved}}, true),
            "Solved for R6 at 30 and 60 frames a second and R15 at 60 frames a second.");
}

}  // namespace
}  // namespace obby::solve
