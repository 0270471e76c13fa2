// For every kind of constraint, the search finds a solution that keeps it. If no solution can keep
// it, the search finds none.
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"
#include "untimed.h"

namespace obby::solve {
namespace {

struct Case {
  const char* what;
  const char* more;  // further fields of the query
  bool solvable;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.what; }

// Returns a level of stones A, B, C at z = -4, -20, -36. Their gaps of 8 studs require a jump. A
// player can cross a gap of 6 without a jump, since the legs still catch the far side.
std::string wideStones(const char* more) {
  return std::string(
             R"({"type":"level","name":"stones","physics":{"fallenPartsHeight":-40},"parts":[)"
             R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
             R"({"name":"B","position":[0,-0.5,-20],"size":[8,1,8]},)"
             R"({"name":"C","position":[0,-0.5,-36],"size":[8,1,8]}],)"
             R"("spawns":[{"position":[0,0,-2]}]})"
             "\n"
             R"({"type":"query","id":"q","goal":{"position":[0,2,-36],"size":[8,4,8]})") +
         more + "}\n";
}

Filtered ask(const Case& c, int threads) {
  const LinesFile file(wideStones(c.more));
  FilterOptions o;
  o.threads = threads;
  o.solver.budget.maxSteps = c.solvable ? 2'000'000 : 150'000;
  o.solver.budget.attempts = 0;
  o.solver.progressRecords = false;
  return runFilter(file.path(), std::move(o));
}

class Constraint : public testing::TestWithParam<Case> {};

// Solutions are verified before they count, so `solved` implies that the constraint is kept.
TEST_P(Constraint, IsKeptOrUnsolvable) {
  const Filtered f = ask(GetParam(), 2);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved, GetParam().solvable ? 1u : 0u) << f.output;
}

TEST_P(Constraint, GivesTheSameBytesOnAnyNumberOfThreads) {
  EXPECT_EQ(withoutTiming(ask(GetParam(), 1).output), withoutTiming(ask(GetParam(), 3).output));
}

INSTANTIATE_TEST_SUITE_P(
    Stones, Constraint,
    testing::Values(
        Case{"five jumps at least", R"(,"minJumps":5)", true},
        Case{"exactly four jumps", R"(,"minJumps":4,"maxJumps":4)", true},
        Case{"exactly one jump", R"(,"minJumps":1,"maxJumps":1)", false},
        Case{
            "corners in any order",
            R"(,"visits":[{"position":[3,2,-20],"size":[2,4,2]},{"position":[-3,2,-2],"size":[2,4,2]},)"
            R"({"position":[3,2,-2],"size":[2,4,2]}])",
            true},
        Case{"a place off the stones", R"(,"visits":[{"position":[30,2,-20],"size":[2,4,2]}])",
             false},
        Case{"any of two goals",
             R"(,"goals":[{"position":[3.5,2,-21.5],"size":[1,4,1]},{"position":[0,90,0]}])", true},
        Case{
            "one jump each segment",
            R"(,"waypoints":[{"region":{"position":[0,2,-20],"size":[8,4,6]},"segmentJumps":1}],"segmentJumps":1)",
            true},
        Case{"no jump in the last segment",
             R"(,"waypoints":[{"region":{"position":[0,2,-20],"size":[8,4,6]}}],"segmentJumps":0)",
             false},
        Case{
            "there and back in time",
            R"(,"waypoints":[{"region":{"position":[0,2,-20],"size":[8,4,6]},"segmentTime":1.3},)"
            R"({"region":{"position":[0,2,-2],"size":[8,4,2]},"segmentTime":1.6}],"segmentTime":2.6)",
            true},
        Case{"faster than walking",
             R"(,"waypoints":[{"region":{"position":[0,2,-20],"size":[8,4,6]},"segmentTime":0.5}])",
             false},
        Case{"without jumping", R"(,"forbid":["jumping"])", false},
        Case{"without climbing", R"(,"forbid":["climbing","seated"])", true},
        Case{"touch the second stone", R"(,"visits":[{"part":"B","touch":true}])", true},
        Case{"without touching the second", R"(,"avoid":[{"part":"B","touch":true}])", false},
        Case{"the goal is a part", R"(,"goals":[{"part":"B","touch":true}],"maxJumps":1)", true}));

// A hurting part covers most of the floor's width, and players can go around it.
TEST(Damage, IsKeptWithinItsBudget) {
  const std::string level =
      R"({"type":"level","name":"hot","parts":[{"name":"Floor","position":[0,-0.5,-15],"size":[40,1,40]},)"
      R"({"name":"Hot","position":[4,0.5,-14],"size":[32,30,4],"solid":false,"kill":{"damage":30,"cooldown":0.2}}],)"
      R"("spawns":[{"position":[4,0,0]}]})"
      "\n";
  const std::string goal =
      R"({"type":"query","id":"q","goal":{"position":[4,2,-30],"size":[8,4,8]},)";
  const auto solved = [&](const std::string& limits) {
    const LinesFile file(level + goal + limits + "}\n");
    FilterOptions o;
    o.solver.budget.maxSteps = 400'000;
    const Filtered f = runFilter(file.path(), std::move(o));
    EXPECT_TRUE(f.status) << f.status.error().text();
    return f.counts.solved == 1;
  };
  EXPECT_TRUE(solved(R"("maxDamage":0)")) << "around it";
  EXPECT_TRUE(solved(R"("maxDamage":60,"timeLimit":2.2)")) << "through it";
  EXPECT_FALSE(solved(R"("maxDamage":29,"timeLimit":2.2)")) << "no time to go around";
}

}  // namespace
}  // namespace obby::solve
