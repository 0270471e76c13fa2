// Queries from the command line, and their order in the stream.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.h"
#include "support/tower.h"

namespace obby::solve {
namespace {

using testing::HasSubstr;

class QuickQueryTest : public testing::Test {
 protected:
  schema::Level::Reader level() { return record.reader().getLevel(); }
  io::RecordBuilder record = support::tower();
};

TEST_F(QuickQueryTest, AQueryOfSelectorsBecomesARecord) {
  QuickQuery quick;
  quick.start = "S1/Lava";
  quick.goals = {"Top"};
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

TEST_F(QuickQueryTest, AStartOnASpawnsPartIsThatSpawnAndTheGoalDefaultsToTheLastCheckpoint) {
  QuickQuery quick;
  quick.start = "Base";
  const auto query = buildQuery(level(), quick, "q");
  ASSERT_TRUE(query) << query.error().text();
  EXPECT_EQ(query->reader().getQuery().getStart().getSpawn(), 0);
  EXPECT_EQ(query->reader().getQuery().getGoal().getName(), "Top");
}

TEST_F(QuickQueryTest, ATitleStaysWhileItApplies) {
  io::RecordBuilder own;
  auto query = own.root().initQuery();
  query.setTitle("Stage 1: the start to 'Top'");
  query.initGoal().setPart("Top");
  QuickQuery limits, other;
  limits.maxJumps = 4;
  other.goals = {"Base"};
  const io::Record asked(std::move(own));
  const auto limited = changeQuery(level(), limits, asked),
             moved = changeQuery(level(), other, asked);
  ASSERT_TRUE(limited && moved);
  EXPECT_EQ(limited->reader().getQuery().getTitle(), "Stage 1: the start to 'Top'");
  EXPECT_EQ(moved->reader().getQuery().getTitle(), "");
}

TEST_F(QuickQueryTest, EveryKindOfLimitBecomesAField) {
  QuickQuery quick;
  quick.goals = {"Top", "Base"};
  quick.visits = {"touch:#Kill", "0,1,-5,2,2,2"};
  quick.avoid = {"touch:S1/Lava"};
  quick.forbid = {"climbing", "fallingDown"};
  quick.minJumps = 2;
  quick.maxDamage = 30;
  const auto built = buildQuery(level(), quick, "q");
  ASSERT_TRUE(built) << built.error().text();
  const auto query = built->reader().getQuery();
  EXPECT_EQ(query.getGoal().getName(), "Top");
  ASSERT_EQ(query.getGoals().size(), 1u);
  EXPECT_EQ(query.getGoals()[0].getPartIndex(), 0);
  ASSERT_EQ(query.getVisits().size(), 3u) << "both parts with the tag, and the box";
  EXPECT_TRUE(query.getVisits()[1].getTouch());
  EXPECT_EQ(query.getVisits()[1].getPartIndex(), 2);
  EXPECT_FALSE(query.getVisits()[2].getTouch());
  EXPECT_EQ(query.getAvoid()[0].getPartIndex(), 1);
  ASSERT_EQ(query.getForbid().size(), 2u);
  EXPECT_EQ(query.getForbid()[1], schema::PlayerState::FALLING_DOWN);
  EXPECT_EQ(query.getMinJumps(), 2);
  EXPECT_EQ(query.getMaxDamage(), 30);
}

TEST_F(QuickQueryTest, ABoxCannotBeTouched) {
  QuickQuery quick;
  quick.avoid = {"touch:0,1,-5,2,2,2"};
  const auto built = buildQuery(level(), quick, "q");
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().path, "--avoid");
  EXPECT_THAT(built.error().text(), HasSubstr("only a part can be touched"));
}

TEST_F(QuickQueryTest, ErrorsNameTheOption) {
  QuickQuery quick;
  quick.goals = {"Lava"};
  EXPECT_EQ(buildQuery(level(), quick, "q").error().path, "--goal");
  quick.goals = {"Top"};
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

TEST(Filter, AnswersFollowTheirQueryAndOtherRecordsPass) {
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

TEST(Filter, ALevelWithoutQueriesGetsAQueryForItsEnd) {
  std::string text = stonesText();
  text.erase(text.find("{\"type\":\"query\""));
  const Filtered f = filter(text);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved, 1u);
  EXPECT_THAT(f.output, HasSubstr("\"id\":\"whole\""));
}

TEST(Filter, ALevelWithoutAnEndNeedsAQuery) {
  const Filtered f = filter(R"({"type":"level","name":"bare","parts":[{"name":"A"}],"spawns":[{}]})"
                            "\n");
  ASSERT_FALSE(f.status);
  EXPECT_THAT(
      f.status.error().text(),
      HasSubstr(":1: level 'bare' has no query, no goal part and no checkpoint (give --goal PLACE, "
                "or put a query record after the level)"));
}

// A user may mean a limit on the command line for the queries of the stream. The error says how to
// apply it to these.
TEST(Filter, ALimitOfANewQueryNeedsAGoalAndTheErrorNamesEach) {
  const std::string level = R"({"type":"level","name":"bare","parts":[{"name":"A"}],"spawns":[{}]})"
                            "\n";
  const std::string query = R"({"type":"query","id":"q","goal":{"position":[0,2,0]}})"
                            "\n";
  FilterOptions o;
  o.quick = QuickQuery{};
  o.quick->maxJumps = 0;
  const auto errorOf = [&](const std::string& text) {
    const Filtered f = filter(text, o);
    EXPECT_FALSE(f.status);
    EXPECT_EQ(f.counts.solved + f.counts.unknown, 0u) << f.output;
    return f.status ? "" : f.status.error().text();
  };
  const std::string wrong =
      ":1: --max-jumps: this option starts a new query, but level 'bare' has no goal part and no "
      "checkpoint (give --goal PLACE";
  EXPECT_THAT(errorOf(level), testing::EndsWith(wrong + ")"));
  EXPECT_THAT(
      errorOf(level + query),
      testing::EndsWith(wrong + ", or --each to apply the option to the level's own query)"));
  EXPECT_THAT(
      errorOf(level + query + query + query),
      testing::EndsWith(wrong + ", or --each to apply the option to the level's own 3 queries)"));
  EXPECT_THAT(errorOf(level + query + level), testing::EndsWith("the level's own query)"));
  o.quick->waypoints = {"A"};
  EXPECT_THAT(errorOf(level), HasSubstr(":1: --waypoint: this option starts a new query"));
  o.each = true;
  EXPECT_TRUE(filter(level + query, o).status);
  EXPECT_THAT(filter(level, o).status.error().text(),
              HasSubstr(":1: level 'bare' has no query, no goal part and no checkpoint (give"));
}

TEST(Filter, AQueryOnTheCommandLineReplacesThoseOfTheStream) {
  FilterOptions o;
  o.quick = QuickQuery{};
  o.quick->goals = {"B"};
  const Filtered f = filter(stonesText(), o);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved + f.counts.unknown, 1u);
  EXPECT_THAT(f.output, HasSubstr("\"query\":\"command-line\""));
  EXPECT_THAT(f.output, testing::Not(HasSubstr("\"query\":\"q\"")));
}

TEST(Filter, LimitsChangeEachQueryOfTheStream) {
  FilterOptions o;
  o.quick = QuickQuery{};
  o.quick->timeLimit = 1;
  o.each = true;
  const Filtered f = filter(stonesText(), o);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.unreachable, 1u) << "26 studs in a second";
  EXPECT_THAT(f.output, HasSubstr("\"query\":\"q\""));
  EXPECT_THAT(f.output, HasSubstr("\"timeLimit\":1")) << "the changed query goes out";
  o.quick->timeLimit = 5;
  EXPECT_EQ(filter(stonesText(), o).counts.solved, 1u);
}

TEST(Filter, PartsNamedByAQueryAreWrittenWithTheirBoxes) {
  std::string text = stonesText();
  const std::string box = R"("goal":{"position":[0,2,-28],"size":[8,4,8]})";
  text.replace(text.find(box), box.size(), R"("goal":{"part":"C","touch":true})");
  const Filtered f = filter(text);
  ASSERT_TRUE(f.status) << f.status.error().text();
  EXPECT_EQ(f.counts.solved, 1u);
  EXPECT_THAT(f.output, HasSubstr(R"("part":"C","touch":true,"partIndex":2)"));
  text.replace(text.find("\"part\":\"C\""), 10, "\"part\":\"D\"");
  EXPECT_THAT(filter(text).status.error().text(),
              HasSubstr("goal.part: no part of level 'stones'"));
}

TEST(Filter, AnswersOnlyTheNamedQueriesAndMissesUnknownNames) {
  FilterOptions o;
  o.only = {"other"};
  const Filtered f = filter(stonesText(), o);
  ASSERT_FALSE(f.status);
  EXPECT_EQ(f.status.error().text(), "--query: the stream has no query 'other' (it has 'q')");
  o.only = {"q"};
  EXPECT_TRUE(filter(stonesText(), o).status);
}

TEST(Filter, AnInvalidQueryIsNotUsedToVerify) {
  std::string visits;
  for (int i = 0; i < 33; ++i) visits += R"({"position":[0,2,-28]},)";
  visits.pop_back();
  FilterOptions o;
  o.task = Task::verify;
  const Filtered f = filter(stonesText(R"(,"visits":[)" + visits + "]"), o);
  ASSERT_FALSE(f.status);
  EXPECT_EQ(f.status.error().path, "visits") << f.status.error().text();
  o.only = {"other"};
  EXPECT_THAT(filter(stonesText(R"(,"visits":[)" + visits + "]"), o).status.error().text(),
              HasSubstr("the stream has no query 'other'"));
}

TEST(Filter, AQueryOfAnUnknownLevelIsAnError) {
  const Filtered f = filter(stonesText(R"(,"level":"elsewhere")"));
  ASSERT_FALSE(f.status);
  EXPECT_THAT(f.status.error().text(), HasSubstr("no level 'elsewhere' before this record"));
}

}  // namespace
}  // namespace obby::solve
