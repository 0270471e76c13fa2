// Searches with mechanics that scripts add: gravity changed by touch, parts that only the root
// touches, air jumps.
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"

namespace obby::solve {
namespace {

FilterCounts ask(const std::string& lines, uint64_t steps = 3'000'000) {
  const LinesFile file(lines);
  FilterOptions o;
  o.threads = 2;
  o.solver.budget.maxSteps = steps;
  o.solver.budget.attempts = 0;
  o.solver.progressRecords = false;
  const Filtered f = runFilter(file.path(), std::move(o));
  EXPECT_TRUE(f.status) << f.status.error().text();
  return f.counts;
}

// Returns a level with a gap of 17 studs after a floor that has `role`.
std::string gapBehind(const std::string& role) {
  return R"({"type":"level","name":"gap","physics":{"fallenPartsHeight":-40},"parts":[)"
         R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8])" +
         role +
         R"(},{"name":"B","position":[0,-0.5,-29],"size":[8,1,8]}],"spawns":[{"position":[0,0,-2]}]})"
         "\n"
         R"({"type":"query","id":"q","goal":{"position":[0,2,-29],"size":[8,4,8]}})"
         "\n";
}

TEST(TouchedSearch, ALightPlayerCrossesAWiderGap) {
  EXPECT_EQ(ask(gapBehind("")).unreachable, 1u);
  EXPECT_EQ(ask(gapBehind(R"(,"boost":{"gravity":0.4,"forever":true})")).solved, 1u);
}

// An air jump crosses a gap of 17 studs, and the verdict is never `unreachable`.
TEST(TouchedSearch, AnAirJumpCrossesAWiderGap) {
  const auto with = [](const char* more) {
    std::string lines = gapBehind("");
    const std::string physics = "\"fallenPartsHeight\":-40";
    return lines.replace(lines.find(physics), physics.size(), physics + more);
  };
  EXPECT_EQ(ask(with(",\"airJumps\":1")).solved, 1u);
  EXPECT_EQ(ask(with(",\"airJumps\":1,\"jumpSpeed\":1"), 100'000).unknown, 1u);
}

// Returns a level whose floor leads between two killing boxes that are 0.8 studs apart.
std::string betweenKills(bool byRoot) {
  const std::string role =
      std::string(R"(,"solid":false,"kill":{})") + (byRoot ? R"(,"byRoot":true)" : "");
  return R"({"type":"level","name":"slit","physics":{"fallenPartsHeight":-40},"parts":[)"
         R"({"name":"A","position":[0,-0.5,-10],"size":[12,1,24]},)"
         R"({"name":"L","position":[-4.4,4,-10],"size":[8,20,4])" +
         role + R"(},{"name":"R","position":[4.4,4,-10],"size":[8,20,4])" + role +
         R"(}],"spawns":[{"position":[0,0,-2]}]})"
         "\n"
         R"({"type":"query","id":"q","maxDamage":0,"goal":{"position":[0,2,-18],"size":[8,4,4]}})"
         "\n";
}

TEST(TouchedSearch, LimbsMayPassThroughPartsTouchedByTheRoot) {
  EXPECT_EQ(ask(betweenKills(true)).solved, 1u);
  EXPECT_EQ(ask(betweenKills(false), 200'000).solved, 0u);
}

}  // namespace
}  // namespace obby::solve
