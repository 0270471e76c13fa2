// Queries whose regions name parts.
#include "level/resolve_places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/tower.h"

namespace obby::level {
namespace {

class ResolveTest : public testing::Test {
 protected:
  schema::Query::Builder query() { return record.root().getQuery(); }
  Status resolve() { return resolvePlaces(tower.reader().getLevel(), query()); }
  void expectWrong(const std::function<void(schema::Query::Builder)>& ask,
                   const std::string& path) {
    record.root().initQuery();
    ask(query());
    const Status status = resolve();
    ASSERT_FALSE(status) << path;
    EXPECT_EQ(status.error().path, path) << status.error().text();
  }

  ResolveTest() { record.root().initQuery(); }
  io::RecordBuilder tower = support::tower(), record;
};

TEST_F(ResolveTest, FillsInBoxNameAndIndex) {
  query().initGoal().setPart("S2/Lava");
  EXPECT_TRUE(namesParts(query()));
  ASSERT_TRUE(resolve());
  const auto goal = query().asReader().getGoal();
  EXPECT_EQ(goal.getPartIndex(), 2);
  EXPECT_EQ(goal.getName(), "Lava");
  EXPECT_EQ(goal.getPosition().getZ(), -20);
  EXPECT_EQ(goal.getSize().getX(), 4) << "one stud wider on each side";
}

TEST_F(ResolveTest, KeepsTheNameThatTheQueryGives) {
  auto goal = query().initGoal();
  goal.setPart("Top");
  goal.setName("The end");
  ASSERT_TRUE(resolve());
  EXPECT_EQ(query().getGoal().getName(), "The end");
}

TEST_F(ResolveTest, AStartIsOnTopOfItsPart) {
  query().initStart().initRegion().setPart("Base");
  ASSERT_TRUE(resolve());
  const auto region = query().asReader().getStart().getRegion();
  EXPECT_EQ(region.getPosition().getY() - region.getSize().getY() / 2, 0.5f);
}

TEST_F(ResolveTest, ATagInAListStandsForAllItsParts) {
  auto avoid = query().initAvoid(3);
  avoid[0].setName("box");
  avoid[1].setPart("#Kill");
  avoid[1].setTouch(true);
  avoid[2].setPart("Top");
  ASSERT_TRUE(resolve());
  const auto list = query().asReader().getAvoid();
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].getName(), "box");
  EXPECT_EQ(list[1].getPartIndex(), 1);
  EXPECT_EQ(list[2].getPartIndex(), 2);
  EXPECT_TRUE(list[1].getTouch() && list[2].getTouch());
  EXPECT_EQ(list[3].getPartIndex(), 3);
}

TEST_F(ResolveTest, ANameToAvoidStandsForAllMatchingParts) {
  auto avoid = query().initAvoid(2);
  avoid[0].setPart("Lava");
  avoid[0].setTouch(true);
  avoid[1].setPart("S2/Lava");
  ASSERT_TRUE(resolve());
  const auto list = query().asReader().getAvoid();
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].getPartIndex(), 1);
  EXPECT_EQ(list[1].getPartIndex(), 2);
  EXPECT_TRUE(list[0].getTouch() && list[1].getTouch());
  EXPECT_EQ(list[2].getPartIndex(), 2);
  EXPECT_FALSE(list[2].getTouch());
}

TEST_F(ResolveTest, AnAvoidedNameMayBeTooAmbiguousForAVisit) {
  query().initAvoid(1)[0].setPart("Lava");
  query().initVisits(1)[0].setPart("Lava");
  const Status status = resolve();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().path, "visits[0].part");
}

TEST_F(ResolveTest, AGoalsTagMeansAnyOfItsParts) {
  auto goal = query().initGoal();
  goal.setPart("#Kill");
  goal.setName("Pool");
  goal.setTouch(true);
  query().initGoals(1)[0].setPart("Top");
  ASSERT_TRUE(resolve());
  EXPECT_EQ(query().getGoal().getPartIndex(), 1);
  const auto goals = query().asReader().getGoals();
  ASSERT_EQ(goals.size(), 2u);
  EXPECT_EQ(goals[0].getPartIndex(), 3);
  EXPECT_EQ(goals[1].getPartIndex(), 2);
  EXPECT_EQ(goals[1].getName(), "Pool");
  EXPECT_TRUE(goals[1].getTouch());
}

TEST_F(ResolveTest, IsIdempotent) {
  query().initGoal().setPart("#Kill");
  query().initVisits(1)[0].setPart("#Kill");
  query().initWaypoints(1)[0].initRegion().setPart("Top");
  query().initGoals(1)[0].setPart("Base");
  ASSERT_TRUE(resolve());
  const auto once = io::RecordBuilder(record.reader());
  ASSERT_TRUE(resolve());
  EXPECT_TRUE(capnp::AnyStruct::Reader(record.reader()) == capnp::AnyStruct::Reader(once.reader()));
}

TEST_F(ResolveTest, BoxesStayAsTheyAre) {
  query().initGoal().setName("box");
  EXPECT_FALSE(namesParts(query()));
  ASSERT_TRUE(resolve());
  EXPECT_EQ(query().getGoal().getPartIndex(), -1);
}

TEST_F(ResolveTest, ErrorsStateThePath) {
  expectWrong([](auto q) { q.initGoal().setPart("Lava"); }, "goal.part");
  expectWrong([](auto q) { q.initGoal().setPart("#None"); }, "goal.part");
  expectWrong([](auto q) { q.initStart().initRegion().setPart("x"); }, "start.region.part");
  expectWrong([](auto q) { q.initAvoid(2)[1].setPart("Lavaa"); }, "avoid[1].part");
  expectWrong([](auto q) { q.initVisits(1)[0].setPart("#None"); }, "visits[0].part");
  expectWrong([](auto q) { q.initVisits(1)[0].setPart("Lava"); }, "visits[0].part");
  expectWrong([](auto q) { q.initGoals(2)[1].setPart("Lava"); }, "goals[1].part");
  expectWrong([](auto q) { q.initGoals(1)[0].setPart("part:9"); }, "goals[0].part");
  expectWrong([](auto q) { q.initWaypoints(1)[0].initRegion().setPart("y"); },
              "waypoints[0].region.part");
}

TEST_F(ResolveTest, ATagThatIsListedAgainStandsForTheSameParts) {
  auto visits = query().initVisits(2);
  visits[0].setPart("#Kill");
  visits[1].setPart("#Kill");
  query().initAvoid(1)[0].setPart("#Kill");
  ASSERT_TRUE(resolve());
  const auto list = query().asReader().getVisits();
  ASSERT_EQ(list.size(), 4u);
  for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ(list[i].getPartIndex(), int32_t(1 + i % 2));
  EXPECT_EQ(query().asReader().getAvoid().size(), 2u);
}

// Here a tag stands for two parts. In a large place a tag may stand for so many parts that a short
// list of tags fills the memory.
TEST_F(ResolveTest, TagsStandForABoundedNumberOfPlaces) {
  const auto tags = [](auto list) {
    for (uint32_t i = 0; i < list.size(); ++i) list[i].setPart("#Kill");
  };
  constexpr uint32_t kMax = uint32_t(kMaxPlaces / 2);
  tags(query().initAvoid(kMax - 1));
  tags(query().initGoals(1));
  EXPECT_TRUE(resolve());
  expectWrong([&](auto q) { tags(q.initAvoid(kMax + 1)); }, fmt::format("avoid[{}].part", kMax));
  expectWrong([&](auto q) { tags(q.initAvoid(kMax - 1)), tags(q.initGoals(2)); }, "goals[1].part");
}

}  // namespace
}  // namespace obby::level
