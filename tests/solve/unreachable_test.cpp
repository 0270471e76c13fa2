// The verdict `unreachable`: what it names, and that it is not said where something may be
// possible.
#include "solve/proof/unreachable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;

// Stones with gaps of 12 studs, the third 3 studs up, and a ledge far above.
Filtered ask(const std::string& limits, const std::string& more = {}) {
  const LinesFile file(R"({"type":"level","name":"stones","parts":[)"
                       R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
                       R"({"name":"B","position":[0,-0.5,-24],"size":[8,1,8]},)"
                       R"({"name":"C","position":[0,2.5,-44],"size":[8,1,8]},)"
                       R"({"name":"Ledge","position":[0,29.5,-54],"size":[8,1,8]})" +
                       more +
                       R"(],"spawns":[{"position":[0,0,-2]}]})"
                       "\n"
                       R"({"type":"query","id":"q",)" +
                       limits + "}\n");
  FilterOptions o;
  o.solver.budget.maxSteps = 20'000;
  o.solver.progressRecords = false;
  return runFilter(file.path(), std::move(o));
}

constexpr const char* kThird = R"("goal":{"name":"third","position":[0,6,-44],"size":[8,4,8]})";

void expectUnreachable(const Filtered& f, const std::string& words) {
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.unreachable, 1u) << f.output;
  EXPECT_THAT(f.output, HasSubstr("\"verdict\":\"unreachable\""));
  EXPECT_THAT(f.output, HasSubstr(words));
  EXPECT_THAT(f.output, testing::Not(HasSubstr("\"trajectory\"")));
}

TEST(Unreachable, NamesTheStepThatIsMissing) {
  const Filtered f = ask(R"("goal":{"part":"Ledge"})");
  expectUnreachable(
      f, "nobody can reach the goal 'Ledge': from part 2 'C' to the goal 'Ledge' at least");
  EXPECT_THAT(f.output, HasSubstr(R"("reached":[0,1,2],"from":2,"rise":)"));
}

// Somebody else might.
TEST(Unreachable, NobodyWithoutJumpingIsSaidToBeSo) {
  const std::string words = "nobody can reach the goal 'third' without jumping: from part ";
  expectUnreachable(ask(std::string(kThird) + R"(,"maxJumps":0)"), words);
  expectUnreachable(ask(std::string(kThird) + R"(,"forbid":["jumping"])"), words);
}

TEST(Unreachable, LimitsOnTheWayToAWaypointEndThere) {
  const Filtered f = ask(
      std::string(kThird) +
      R"(,"waypoints":[{"region":{"position":[0,2,-6],"size":[8,4,2]},"maxJumps":0,"segmentJumps":0}])");
  EXPECT_EQ(f.counts.unreachable, 0u) << "the jumps come after it";
}

TEST(Unreachable, CountsTheJumpsThatEveryWayTakes) {
  expectUnreachable(ask(std::string(kThird) + R"(,"maxJumps":1)"),
                    "every way to the goal 'third' takes at least 2 jumps, and 1 are allowed");
  EXPECT_EQ(ask(std::string(kThird) + R"(,"maxJumps":2)").counts.unreachable, 0u);
}

TEST(Unreachable, CountsTheJumpsToAWaypoint) {
  expectUnreachable(
      ask(std::string(kThird) +
          R"(,"waypoints":[{"region":{"name":"second","position":[0,2,-24],"size":[8,4,8]},"maxJumps":0}])"),
      "every way to waypoint 1 'second' takes at least 1 jump, and 0 are allowed");
}

TEST(Unreachable, KnowsHowLongTheWayIs) {
  expectUnreachable(ask(std::string(kThird) + R"(,"timeLimit":2)"), "and 2.00 s are allowed");
  EXPECT_EQ(ask(std::string(kThird) + R"(,"timeLimit":2.8)").counts.unreachable, 0u);
  const std::string back =
      R"(,"waypoints":[{"region":{"position":[0,2,-24],"size":[8,4,8]}},{"region":{"position":[0,2,-2],"size":[8,4,2]}}])";
  expectUnreachable(ask(std::string(kThird) + back + R"(,"timeLimit":4)"),
                    "and 4.00 s are allowed");
}

TEST(Unreachable, SaysNothingOfTimeWhereSomethingMovesPlayersAtOnce) {
  const std::string limit = std::string(kThird) + R"(,"timeLimit":2)";
  for (const char* more :
       {R"(,{"name":"Seat","position":[0,0.5,-6],"size":[2,1,2],"seat":{}})",
        R"(,{"name":"Gate","position":[0,1,-6],"size":[2,1,2],"teleport":{"position":[0,3,-44]}})",
        R"(,{"name":"Ghost","position":[0,1,-6],"size":[2,1,20],"vanish":{"delay":0.2}})"}) {
    EXPECT_EQ(ask(limit, more).counts.unreachable, 0u) << more;
  }
  const char* pusher =
      R"(,{"name":"Pusher","position":[0,2,0],"size":[8,4,1],"motion":{"carries":false,"repeat":"loop",)"
      R"("keys":[{"position":[0,2,0]},{"time":0.5,"position":[0,2,-30]},{"time":1,"position":[0,2,0]}]}})";
  EXPECT_EQ(ask(limit, pusher).counts.unreachable, 0u);
}

TEST(Unreachable, SaysNothingOfTimeWhereAWallThatNobodyStandsOnPushes) {
  const char* wall =
      R"(,{"name":"Wall","position":[3.75,11,4],"size":[1.5,20,1],"motion":{"repeat":"pingPong",)"
      R"("keys":[{"position":[3.75,11,4]},{"time":1,"position":[3.75,11,-48]}]}})";
  const std::string limit = std::string(kThird) + R"(,"timeLimit":2)";
  EXPECT_EQ(ask(limit, wall).counts.unreachable, 0u);
  EXPECT_EQ(ask(limit).counts.unreachable, 1u) << "without it";
}

TEST(Unreachable, OneVisitOutOfReachIsEnough) {
  expectUnreachable(
      ask(std::string(kThird) + R"(,"visits":[{"part":"B"},{"part":"Ledge","touch":true}])"),
      "nobody can reach 'Ledge'");
}

TEST(Unreachable, AnyGoalWithinReachWillDo) {
  EXPECT_EQ(ask(std::string(kThird) + R"(,"goals":[{"part":"Ledge"}])").counts.unreachable, 0u);
}

TEST(Unreachable, OfSeveralGoalsTheOneThatLacksLeastIsNamed) {
  const std::string far = R"("goal":{"position":[0,900,-4]},"goals":[{"part":"Ledge"}])";
  const Filtered both = ask(far), one = ask(R"("goal":{"part":"Ledge"})");
  const auto cutOf = [](const Filtered& f) {
    const size_t at = f.output.find("\"cut\":");
    return f.output.substr(at, f.output.find('}', at) - at);
  };
  expectUnreachable(both, "nobody can reach any of the goals");
  EXPECT_EQ(cutOf(both), cutOf(one));
}

TEST(Unreachable, IsNotSaidWhereLoosePartsCanBePiledUp) {
  const Filtered f = ask(R"("goal":{"part":"Ledge"})",
                         R"(,{"name":"Box","position":[0,3,-4],"size":[2,2,2],"anchored":false})");
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.unreachable, 0u);
  EXPECT_EQ(f.counts.unknown, 1u);
}

// A row of small posts across the first stone, so many studs beside it.
std::string posts(int count, float aside) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += R"(,{"name":"Post","position":[)" + std::to_string(aside + 0.1f * float(i) - 3) +
            R"(,0.5,-7],"size":[0.05,1,0.05]})";
  }
  return text;
}

// Some of them are not there for whoever is among them.
TEST(Unreachable, IsNotSaidWhereMorePartsAreNearThanTheSimulatorLooksAt) {
  const std::string ledge = R"("goal":{"part":"Ledge"})";
  EXPECT_EQ(ask(ledge, posts(60, 0)).counts.unreachable, 0u);
  EXPECT_EQ(ask(ledge, posts(40, 0)).counts.unreachable, 1u) << "all of them are looked at";
  EXPECT_EQ(ask(ledge, posts(60, 500)).counts.unreachable, 1u) << "nobody comes there";
}

// What the importer left out may be the way.
TEST(Unreachable, IsNotSaidOfALevelThatLacksPartOfItsPlace) {
  const auto answer = [](const std::string& text) {
    FilterOptions o;
    o.solver.budget.maxSteps = 20'000;
    o.solver.progressRecords = false;
    const LinesFile file(text);
    return runFilter(file.path(), o).output;
  };
  std::string text = stonesText(R"(,"timeLimit":0.5)");
  EXPECT_NE(answer(text).find("\"verdict\":\"unreachable\""), std::string::npos);
  const std::string name = R"("name":"stones",)";
  text.insert(text.find(name), R"("unmodelled":[{"kind":"terrain","count":2}],)");
  const std::string output = answer(text);
  EXPECT_NE(output.find("\"verdict\":\"unknown\""), std::string::npos);
  EXPECT_NE(output.find("what is not simulated: terrain (2)"), std::string::npos);
}

}  // namespace
}  // namespace obby::solve
