// Queries from the command line and the stream's order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"
#include "solve/select_parts.h"

namespace obby::solve {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kLevel =
    R"({"type":"level","name":"tower","parts":[)"
    R"({"name":"Base","position":[0,0,0],"size":[8,1,8]},)"
    R"({"name":"Lava","position":[0,0,-10],"size":[2,1,2],"source":{"path":"Workspace/S1/Lava"},"tags":["Kill"]},)"
    R"({"name":"Lava","position":[0,0,-20],"size":[2,1,2],"source":{"path":"Workspace/S2/Lava"},"tags":["Kill","Hot"]},)"
    R"({"name":"Top","position":[0,9,-30],"size":[4,1,2],"rotation":[0,0,0.70710678,0.70710678],)"
    R"("source":{"path":"Workspace/S2/Top","guid":"AB12"},"checkpoint":{"stage":2}}],)"
    R"("spawns":[{"position":[0,0.5,0],"part":0}]})";

class SelectTest : public testing::Test {
 protected:
  SelectTest() : record(*io::recordFromJson(kLevel)) {}
  schema::Level::Reader level() { return record.reader().getLevel(); }
  std::vector<uint32_t> parts(const std::string& selector) {
    auto found = matchParts(level(), selector);
    EXPECT_TRUE(found) << found.error().text();
    return found ? *found : std::vector<uint32_t>();
  }
  std::string error(const std::string& selector) {
    const auto found = matchPart(level(), selector);
    EXPECT_FALSE(found);
    return found ? "" : found.error().text();
  }
  io::RecordBuilder record;
};

TEST_F(SelectTest, ByNamePathEndOfPathTagGuidAndIndex) {
  EXPECT_THAT(parts("Base"), ElementsAre(0));
  EXPECT_THAT(parts("Workspace/S2/Lava"), ElementsAre(2));
  EXPECT_THAT(parts("S1/Lava"), ElementsAre(1));
  EXPECT_THAT(parts("Lava"), ElementsAre(1, 2));
  EXPECT_THAT(parts("#Kill"), ElementsAre(1, 2));
  EXPECT_THAT(parts("#Hot"), ElementsAre(2));
  EXPECT_THAT(parts("AB12"), ElementsAre(3));
  EXPECT_THAT(parts("part:3"), ElementsAre(3));
}

TEST_F(SelectTest, SeveralMatchesAreListed) {
  EXPECT_EQ(error("Lava"),
            "'Lava' names 2 parts of level 'tower' "
            "(one of part:1 Workspace/S1/Lava, part:2 Workspace/S2/Lava)");
}

TEST_F(SelectTest, NoMatchSuggestsSimilarNames) {
  EXPECT_THAT(error("lav"), HasSubstr("similar: part:1 Workspace/S1/Lava"));
  EXPECT_THAT(error("nothing"), HasSubstr("part:INDEX"));
  EXPECT_THAT(error("part:9"), HasSubstr("parts 0 to 3"));
}

TEST(BoxFromText, ReadsSixNumbersAndNothingElse) {
  const auto box = boxFromText("1,-2.5,3e1,4,5,6");
  ASSERT_TRUE(box && *box);
  EXPECT_TRUE((*box)->position == (Vec3{1, -2.5f, 30}));
  EXPECT_TRUE((*box)->size == (Vec3{4, 5, 6}));
  for (const char* text : {"", "1,2,3", "1,2,3,4,5,6,7", "1,2,3,4,5,x", "Part,1", "1;2;3;4;5;6"}) {
    const auto other = boxFromText(text);
    ASSERT_TRUE(other) << text;
    EXPECT_FALSE(other->has_value()) << text;
  }
  EXPECT_FALSE(boxFromText("1,2,3,4,0,6"));
  EXPECT_FALSE(boxFromText("1,2,3,4,nan,6"));
  EXPECT_FALSE(boxFromText("inf,2,3,4,5,6"));
}

TEST_F(SelectTest, RegionsGrowUpwardAlsoForPartsThatLieOnTheirSide) {
  const PlainRegion base = regionAround(level().getParts()[0]);
  EXPECT_TRUE(base.size == (Vec3{10, 1.5f, 10}));
  EXPECT_FLOAT_EQ(base.position.y, 0.25f);
  const PlainRegion top = regionAround(level().getParts()[3]);  // local X points up
  EXPECT_TRUE(top.size == (Vec3{4.5f, 3, 4}));
  EXPECT_NEAR(top.position.y, 9.25f, 1e-5);
  const PlainRegion standing = regionOnTop(level().getParts()[3]);
  EXPECT_NEAR(standing.position.y - standing.size.y / 2, 11, 1e-5);
}

TEST_F(SelectTest, AQueryOfSelectorsBecomesARecord) {
  QuickQuery quick;
  quick.start = "S1/Lava";
  quick.goal = "Top";
  quick.waypoints = {"S2/Lava", "0,1,-5,2,2,2"};
  quick.avoid = {"#Kill"};
  quick.maxJumps = 4;
  quick.timeLimit = 2.5f;
  const auto record2 = buildQuery(level(), quick, "q");
  ASSERT_TRUE(record2) << record2.error().text();
  const auto query = record2->reader().getQuery();
  EXPECT_EQ(query.getLevel(), "tower");
  EXPECT_FLOAT_EQ(query.getStart().getRegion().getPosition().getZ(), -10);
  EXPECT_EQ(query.getGoal().getName(), "Top");
  EXPECT_EQ(query.getWaypoints().size(), 2u);
  EXPECT_EQ(query.getAvoid().size(), 2u);
  EXPECT_EQ(query.getMaxJumps(), 4);
  EXPECT_FLOAT_EQ(query.getTimeLimit(), 2.5f);
}

TEST_F(SelectTest, AStartOnASpawnsPartIsThatSpawnAndTheGoalDefaultsToTheLastCheckpoint) {
  QuickQuery quick;
  quick.start = "Base";
  const auto query = buildQuery(level(), quick, "q");
  ASSERT_TRUE(query) << query.error().text();
  EXPECT_EQ(query->reader().getQuery().getStart().getSpawn(), 0);
  EXPECT_EQ(query->reader().getQuery().getGoal().getName(), "Top");
}

TEST_F(SelectTest, ErrorsNameTheOption) {
  QuickQuery quick;
  quick.goal = "Lava";
  EXPECT_EQ(buildQuery(level(), quick, "q").error().path, "--goal");
  quick.goal = "Top";
  quick.waypoints = {"none"};
  EXPECT_EQ(buildQuery(level(), quick, "q").error().path, "--waypoint");
  quick.waypoints = {};
  quick.avoid = {"none"};
  EXPECT_EQ(buildQuery(level(), quick, "q").error().path, "--avoid");
  quick.avoid = {};
  quick.start = "Lava";
  EXPECT_EQ(buildQuery(level(), quick, "q").error().path, "--start");
}

Filtered filter(const std::string& text, FilterOptions options = {}) {
  const LinesFile file(text);
  options.solver.budget.maxSteps = 60'000;
  options.solver.progressRecords = false;
  return runFilter(file.path(), std::move(options));
}

TEST(Filter, AnswersStandBehindTheirQueryAndOthersPass) {
  const std::string metrics = R"({"type":"metrics","source":"x","step":"3"})";
  const Filtered f = filter(stonesText() + metrics + "\n");
  ASSERT_TRUE(f.status) << f.status.error().text();
  const size_t level = f.output.find("\"type\":\"level\""),
               query = f.output.find("\"type\":\"query\""),
               trajectory = f.output.find("\"type\":\"trajectory\""),
               result = f.output.find("\"type\":\"result\""), other = f.output.find(metrics);
  EXPECT_LT(level, query);
  EXPECT_LT(query, trajectory);
  EXPECT_LT(trajectory, result);
  EXPECT_LT(result, other);
  ASSERT_NE(other, std::string::npos);
}

TEST(Filter, ALevelWithoutQueriesIsAskedForItsEnd) {
  std::string text = stonesText();
  text.erase(text.find("{\"type\":\"query\""));
  const Filtered f = filter(text);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved, 1u);
  EXPECT_THAT(f.output, HasSubstr("\"id\":\"whole\""));
}

TEST(Filter, ALevelThatNamesNoEndNeedsAQuery) {
  const Filtered f = filter(R"({"type":"level","name":"bare","parts":[{"name":"A"}],"spawns":[{}]})"
                            "\n");
  ASSERT_FALSE(f.status);
  EXPECT_THAT(f.status.error().text(), HasSubstr("no query, no goal part and no checkpoint"));
}

TEST(Filter, AQueryOnTheCommandLineReplacesThoseOfTheStream) {
  FilterOptions o;
  o.quick = QuickQuery{};
  o.quick->goal = "B";
  const Filtered f = filter(stonesText(), o);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved + f.counts.unknown, 1u);
  EXPECT_THAT(f.output, HasSubstr("\"query\":\"command-line\""));
  EXPECT_THAT(f.output, testing::Not(HasSubstr("\"query\":\"q\"")));
}

TEST(Filter, AnswersOnlyTheNamedQueriesAndMissesUnknownNames) {
  FilterOptions o;
  o.only = {"other"};
  const Filtered f = filter(stonesText(), o);
  ASSERT_FALSE(f.status);
  EXPECT_EQ(f.status.error().text(), "--query: no query 'other' in the stream (there is q)");
  o.only = {"q"};
  EXPECT_TRUE(filter(stonesText(), o).status);
}

TEST(Filter, AQueryOfAnUnknownLevelIsAnError) {
  const Filtered f = filter(stonesText(R"(,"level":"elsewhere")"));
  ASSERT_FALSE(f.status);
  EXPECT_THAT(f.status.error().text(), HasSubstr("no level 'elsewhere' before this record"));
}

}  // namespace
}  // namespace obby::solve
