// Tests the verdict `unreachable`, its reasons, and that it is not claimed where a solution may
// exist.
#include "solve/proof/unreachable.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "io/json_codec.h"
#include "scenes.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;

// Returns the answers of a short search.
Filtered answered(const std::string& text) {
  const LinesFile file(text);
  FilterOptions o;
  o.solver.budget.maxSteps = 20'000;
  o.solver.progressRecords = false;
  return runFilter(file.path(), std::move(o));
}

// Searches a level of stones with gaps of 12 and 11 studs. The third stone is 3 studs higher, and a
// ledge is far above.
Filtered unreachableAsk(const std::string& limits, const std::string& more = {}) {
  return answered(R"({"type":"level","name":"stones","parts":[)"
                  R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
                  R"({"name":"B","position":[0,-0.5,-24],"size":[8,1,8]},)"
                  R"({"name":"C","position":[0,2.5,-43],"size":[8,1,8]},)"
                  R"({"name":"Ledge","position":[0,29.5,-53],"size":[8,1,8]})" +
                  more +
                  R"(],"spawns":[{"position":[0,0,-2]}]})"
                  "\n"
                  R"({"type":"query","id":"q",)" +
                  limits + "}\n");
}

constexpr const char* kThird = R"("goal":{"name":"third","position":[0,6,-43],"size":[8,4,8]})";

void expectUnreachable(const Filtered& f, const std::string& words) {
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.unreachable, 1u) << f.output;
  EXPECT_THAT(f.output, HasSubstr("\"verdict\":\"unreachable\""));
  EXPECT_THAT(f.output, HasSubstr(words));
  EXPECT_THAT(f.output, testing::Not(HasSubstr("\"trajectory\"")));
}

TEST(Unreachable, NamesTheStepThatIsMissing) {
  const Filtered f = unreachableAsk(R"("goal":{"part":"Ledge"})");
  expectUnreachable(
      f, "No player can reach the goal 'Ledge'. From 'C', the goal 'Ledge' is 17.5 studs ");
  EXPECT_THAT(f.output, HasSubstr(" studs too high. At most 3 parts are reachable. "));
  EXPECT_THAT(f.output, HasSubstr(R"("reached":[0,1,2],"from":2,"rise":)"));
}

// Returns a goal `rise` studs above the head of a player on the last stone. A jump gains 7.3 studs.
std::string goalAbove(float rise) {
  return fmt::format(R"("goal":{{"name":"up","position":[0,{},-43],"size":[8,4,8]}})",
                     5 + 5 + rise);
}

TEST(Unreachable, NamesHelpfulTricksAndWhetherItHoldsWithAll) {
  const Filtered low = unreachableAsk(goalAbove(10)), high = unreachableAsk(goalAbove(60));
  expectUnreachable(low, " This assumes normal play; a trick (held jump");
  EXPECT_THAT(low.output, HasSubstr(R"("mayHelp":["heldJump")"));
  expectUnreachable(high, " No trick changes this.");
  EXPECT_THAT(high.output, HasSubstr(R"("withTricks":true)"));
}

// The reason must say that jumping is forbidden, as a player who may jump is not excluded.
TEST(Unreachable, TheReasonMentionsForbiddenJumping) {
  const std::string words = "No player can reach the goal 'third' without jumping. From '";
  expectUnreachable(unreachableAsk(std::string(kThird) + R"(,"maxJumps":0)"), words);
  expectUnreachable(unreachableAsk(std::string(kThird) + R"(,"forbid":["jumping"])"), words);
}

TEST(Unreachable, AWaypointsLimitsApplyOnlyUntilIt) {
  const Filtered f = unreachableAsk(
      std::string(kThird) +
      R"(,"waypoints":[{"region":{"position":[0,2,-6],"size":[8,4,2]},"maxJumps":0,"segmentJumps":0}])");
  EXPECT_EQ(f.counts.unreachable, 0u) << "the jumps come after it";
}

TEST(Unreachable, CountsTheJumpsOfEveryRoute) {
  expectUnreachable(
      unreachableAsk(std::string(kThird) + R"(,"maxJumps":1)"),
      "Every route to the goal 'third' takes at least 2 jumps, but only 1 is allowed.");
  EXPECT_EQ(unreachableAsk(std::string(kThird) + R"(,"maxJumps":2)").counts.unreachable, 0u);
}

TEST(Unreachable, CountsTheJumpsToAWaypoint) {
  expectUnreachable(
      unreachableAsk(
          std::string(kThird) +
          R"(,"waypoints":[{"region":{"name":"second","position":[0,2,-24],"size":[8,4,8]},"maxJumps":0}])"),
      "Every route to waypoint 1 'second' takes at least 1 jump, but none is allowed.");
}

TEST(Unreachable, KnowsTheLengthOfTheRoute) {
  expectUnreachable(unreachableAsk(std::string(kThird) + R"(,"timeLimit":1.6)"),
                    "but only 1.60 s is allowed");
  EXPECT_EQ(unreachableAsk(std::string(kThird) + R"(,"timeLimit":2.8)").counts.unreachable, 0u);
  const std::string back =
      R"(,"waypoints":[{"region":{"position":[0,2,-24],"size":[8,4,8]}},{"region":{"position":[0,2,-2],"size":[8,4,2]}}])";
  expectUnreachable(unreachableAsk(std::string(kThird) + back + R"(,"timeLimit":3.5)"),
                    "but only 3.50 s is allowed");
}

TEST(Unreachable, MakesNoTimeClaimIfPlayersCanBeMovedAtOnce) {
  const std::string limit = std::string(kThird) + R"(,"timeLimit":1.6)";
  for (const char* more :
       {R"(,{"name":"Seat","position":[0,0.5,-6],"size":[2,1,2],"seat":{}})",
        R"(,{"name":"Gate","position":[0,1,-6],"size":[2,1,2],"teleport":{"position":[0,3,-44]}})",
        R"(,{"name":"Ghost","position":[0,1,-6],"size":[2,1,20],"vanish":{"delay":0.2}})"}) {
    EXPECT_EQ(unreachableAsk(limit, more).counts.unreachable, 0u) << more;
  }
  const char* pusher =
      R"(,{"name":"Pusher","position":[0,2,0],"size":[8,4,1],"motion":{"carries":false,"repeat":"loop",)"
      R"("keys":[{"position":[0,2,0]},{"time":0.5,"position":[0,2,-30]},{"time":1,"position":[0,2,0]}]}})";
  EXPECT_EQ(unreachableAsk(limit, pusher).counts.unreachable, 0u);
}

TEST(Unreachable, MakesNoTimeClaimIfATallWallPushes) {
  const char* wall =
      R"(,{"name":"Wall","position":[3.75,11,4],"size":[1.5,20,1],"motion":{"repeat":"pingPong",)"
      R"("keys":[{"position":[3.75,11,4]},{"time":1,"position":[3.75,11,-48]}]}})";
  const std::string limit = std::string(kThird) + R"(,"timeLimit":1.6)";
  EXPECT_EQ(unreachableAsk(limit, wall).counts.unreachable, 0u);
  EXPECT_EQ(unreachableAsk(limit).counts.unreachable, 1u) << "without it";
}

// From 16,384 studs on, floats are 1/512 stud apart. A tick of walking is 136.5 of these steps,
// which rounds to 137.
TEST(Unreachable, AllowsForRoundingFarOut) {
  LevelBuilder b;
  b.block({0, -0.5f, -17500}, {8, 1, 2040}).spawn({0, 0, -16500});
  const level::Level level = b.compile();
  sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
  for (int t = 0; t < 7488; ++t) {
    sim::advance(w, nullptr, level.view(), nullptr, {0, true, false});
  }
  EXPECT_LT(w.position.z, -18501) << "2,001 studs in 124.8 s are more than 16 a second";
  const auto run = [](const std::string& seconds) {
    return answered(R"({"type":"level","name":"far","parts":[)"
                    R"({"name":"Floor","position":[0,-0.5,-17500],"size":[8,1,2040]}],)"
                    R"("spawns":[{"position":[0,0,-16500]}]})"
                    "\n"
                    R"({"type":"query","id":"q","goal":{"position":[0,2,-18505],"size":[6,4,10]},)"
                    R"("maxJumps":0,"timeLimit":)" +
                    seconds + "}\n");
  };
  EXPECT_EQ(run("124.8").counts.unreachable, 0u);
  expectUnreachable(run("90"), "but only 90.00 s is allowed");
}

TEST(Unreachable, IsNotClaimedAtHeightsThatRoundJumps) {
  const auto counted = [](const std::string& height) {
    return unreachableAsk(R"("goal":{"part":"Ledge"})",
                          R"(,{"name":"High","position":[0,)" + height + R"(,0],"size":[4,1,4]})")
        .counts.unreachable;
  };
  EXPECT_EQ(counted("20000"), 0u);
  EXPECT_EQ(counted("10000"), 1u);
  const auto fallen = [](const std::string& height) {
    return unreachableAsk(R"("goal":{"position":[5000,2,0],"size":[8,4,8]},)"
                          R"("start":{"region":{"position":[0,)" +
                          height + R"(,0],"size":[2,2,2]}})")
        .counts.unreachable;
  };
  EXPECT_EQ(fallen("20000"), 0u) << "falls are longer, too";
  EXPECT_EQ(fallen("10000"), 1u);
}

TEST(Unreachable, IsNotClaimedIfATeleporterLeadsTooHigh) {
  const auto counted = [](const std::string& height) {
    return unreachableAsk(R"("goal":{"part":"Ledge"})",
                          R"(,{"name":"Gate","position":[0,5000,0],"size":[4,4,4],"solid":false,)"
                          R"("teleport":{"position":[0,)" +
                              height + R"(,0]}})")
        .counts.unreachable;
  };
  EXPECT_EQ(counted("20000"), 0u);
  EXPECT_EQ(counted("10000"), 1u);
}

// The level's clock wraps to its first tick, at which a lift may be elsewhere.
TEST(Unreachable, IsNotClaimedIfALiftsClockWraps) {
  LevelBuilder b;
  b.block({0, -0.5f, -4}, {8, 1, 8}).block({0, -5, -4}, {2, 1, 2}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    motion.setRepeat(schema::Repeat::PING_PONG);
    motion.setOffset(7);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, -5, -4});
    support::set(keys[1].initPosition(), {0, 0.2f, -4});
    keys[1].setTime(7);
  });
  const level::Level level = b.compile();
  sim::World w = sim::makeWorld(level.view(), {{0, 0, -4}, 0, 4294967000u});
  for (int t = 0; t < 400; ++t) sim::advance(w, nullptr, level.view(), nullptr, {});
  const std::string ledge = R"("goal":{"part":"Ledge"})";
  const std::string lift =
      R"(,{"name":"Lift","position":[0,-5,-4],"size":[2,1,2],"motion":{"carries":true,"repeat":"pingPong",)"
      R"("offset":7,"keys":[{"position":[0,-5,-4]},{"time":7,"position":[0,0.2,-4]}]}})";
  EXPECT_EQ(unreachableAsk(ledge + R"(,"start":{"tick":4294967000})", lift).counts.unreachable, 0u);
  EXPECT_EQ(unreachableAsk(ledge + R"(,"start":{"tick":1000})", lift).counts.unreachable, 1u);
  EXPECT_EQ(unreachableAsk(ledge + R"(,"start":{"tick":4294967000})").counts.unreachable, 1u)
      << "no lift";
}

TEST(Unreachable, OneVisitOutOfReachIsEnough) {
  expectUnreachable(unreachableAsk(std::string(kThird) +
                                   R"(,"visits":[{"part":"B"},{"part":"Ledge","touch":true}])"),
                    "No player can reach 'Ledge'. From '");
}

TEST(Unreachable, OneReachableGoalIsEnough) {
  EXPECT_EQ(
      unreachableAsk(std::string(kThird) + R"(,"goals":[{"part":"Ledge"}])").counts.unreachable,
      0u);
}

TEST(Unreachable, NamesTheGoalWithTheSmallestMissingStep) {
  const std::string far = R"("goal":{"position":[0,900,-4]},"goals":[{"part":"Ledge"}])";
  const Filtered both = unreachableAsk(far), one = unreachableAsk(R"("goal":{"part":"Ledge"})");
  const auto cutOf = [](const Filtered& f) {
    const size_t at = f.output.find("\"cut\":");
    return f.output.substr(at, f.output.find('}', at) - at);
  };
  expectUnreachable(both, "No player can reach any goal. From '");
  EXPECT_EQ(cutOf(both), cutOf(one));
}

TEST(Unreachable, IsNotClaimedWithDynamicParts) {
  const Filtered f =
      unreachableAsk(R"("goal":{"part":"Ledge"})",
                     R"(,{"name":"Box","position":[0,3,-4],"size":[2,2,2],"anchored":false})");
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.unreachable, 0u);
  EXPECT_EQ(f.counts.unknown, 1u);
}

// Returns a row of small posts on the first stone, moved by `aside` studs.
std::string posts(int count, float aside) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += R"(,{"name":"Post","position":[)" + std::to_string(aside + 0.1f * float(i) - 3) +
            R"(,0.5,-7],"size":[0.05,1,0.05]})";
  }
  return text;
}

// The simulator ignores some of the posts for a player among them.
TEST(Unreachable, IsNotClaimedIfTheSimulatorIgnoresParts) {
  const std::string ledge = R"("goal":{"part":"Ledge"})";
  EXPECT_EQ(unreachableAsk(ledge, posts(60, 0)).counts.unreachable, 0u);
  EXPECT_EQ(unreachableAsk(ledge, posts(40, 0)).counts.unreachable, 1u)
      << "all of them are looked at";
  EXPECT_EQ(unreachableAsk(ledge, posts(60, 500)).counts.unreachable, 1u) << "no player gets there";
}

// Parts that the importer left out may lead to the goal.
TEST(Unreachable, IsNotClaimedForAnIncompleteImport) {
  const auto answer = [](const std::string& text) { return answered(text).output; };
  std::string text = stonesText(R"(,"timeLimit":0.5)");
  EXPECT_NE(answer(text).find("\"verdict\":\"unreachable\""), std::string::npos);
  const std::string name = R"("name":"stones",)";
  text.insert(text.find(name), R"("unmodelled":[{"kind":"terrain","count":2}],)");
  const std::string output = answer(text);
  EXPECT_NE(output.find("\"verdict\":\"unknown\""), std::string::npos);
  EXPECT_NE(output.find("Not simulated in this place: terrain (2)."), std::string::npos);
}

}  // namespace
}  // namespace obby::solve
