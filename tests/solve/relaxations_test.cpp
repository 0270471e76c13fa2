// Each relaxation's changes to a query or its level, and the parts that relaxations consider.
#include "solve/report/relaxation/relaxations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "level/resolve_places.h"
#include "scenes.h"
#include "solve/report/relaxation/explain.h"
#include "solve/report/relaxation/frontier.h"

namespace obby::solve {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

io::RecordBuilder relaxationsRecord(const std::string& json) {
  auto decoded = io::recordFromJson(json);
  EXPECT_TRUE(decoded) << decoded.error().text();
  return *std::move(decoded);
}

constexpr const char* kRelaxationsLevel =
    R"({"type":"level","name":"scene","parts":[)"
    R"({"name":"Floor","position":[0,-0.5,-4],"size":[8,1,8]},)"
    R"({"name":"Lift","position":[0,5.5,-14],"size":[6,1,6],"motion":{"carries":true,"repeat":"pingPong",)"
    R"("keys":[{"position":[0,5.5,-14]},{"time":2,"position":[0,8.5,-14]}]}},)"
    R"({"name":"Lava","position":[0,0.5,-4],"size":[2,1,2],"kill":{}},)"
    R"({"name":"Far","position":[0,9.5,-26],"size":[6,1,6]},)"
    R"({"name":"Crate","position":[3,2,-4],"size":[2,2,2],"anchored":false}],)"
    R"("spawns":[{"position":[0,0,-2]}]})";

// A query over the level, with a made-up failed search.
struct RelaxationsScene {
  explicit RelaxationsScene(const std::string& fields)
      : levelRecord(relaxationsRecord(kRelaxationsLevel)),
        queryRecord(relaxationsRecord(R"({"type":"query","id":"q",)" + fields + "}")),
        level(compileLevel()),
        query(compileQuery()),
        posed{level, levelRecord.reader().getLevel(), query, queryRecord.reader().getQuery()} {}

  level::Level compileLevel() { return *level::Level::compile(levelRecord.reader().getLevel()); }
  level::Query compileQuery() {
    EXPECT_TRUE(
        level::resolvePlaces(levelRecord.reader().getLevel(), queryRecord.root().getQuery()));
    return *level::Query::compile(queryRecord.reader().getQuery(), level);
  }
  Failure failure() const { return {posed, outcome, footprints}; }
  RelaxedQuery relaxed(const Change& change, uint32_t notches) const {
    auto r = RelaxedQuery::make(posed, change, notches);
    EXPECT_TRUE(r.has_value());
    return *std::move(r);
  }

  io::RecordBuilder levelRecord, queryRecord;
  level::Level level;
  level::Query query;
  PosedQuery posed;
  SearchOutcome outcome;
  Footprints footprints;
};

const std::string kGoal = R"("goal":{"position":[0,12,-26],"size":[6,4,6]})";

TEST(Relaxations, MissingLimitsAreNotRelaxed) {
  EXPECT_THAT(limitChanges(RelaxationsScene(kGoal).failure()), IsEmpty());
}

TEST(Relaxations, EveryLimitIsRelaxedSeparately) {
  const RelaxationsScene s(
      kGoal + R"(,"maxJumps":2,"timeLimit":3,"segmentJumps":1,"segmentTime":2,"maxDamage":0,)"
              R"("waypoints":[{"region":{"part":"Lift"},"maxJumps":1,"segmentTime":1.5}])");
  std::vector<std::string> fields;
  for (const Change& c : limitChanges(s.failure())) {
    fields.push_back(c.field);
    const RelaxedQuery r = s.relaxed(c, 4);
    const auto q = r.posed().queryRecord;
    const auto w = q.getWaypoints()[0];
    const auto by = [&](const char* field, double amount) { return c.field == field ? amount : 0; };
    EXPECT_EQ(q.getMaxJumps(), 2 + by("maxJumps", 4));
    EXPECT_FLOAT_EQ(q.getTimeLimit(), float(3 + by("timeLimit", 0.4)));
    EXPECT_EQ(q.getSegmentJumps(), 1 + by("segmentJumps", 4));
    EXPECT_FLOAT_EQ(q.getSegmentTime(), float(2 + by("segmentTime", 0.4)));
    EXPECT_FLOAT_EQ(q.getMaxDamage(), float(by("maxDamage", 4)));
    EXPECT_EQ(w.getMaxJumps(), 1 + by("waypoints[0].maxJumps", 4));
    EXPECT_FLOAT_EQ(w.getSegmentTime(), float(1.5 + by("waypoints[0].segmentTime", 0.4)));
    EXPECT_EQ(w.getSegmentJumps(), -1);
    EXPECT_EQ(&r.posed().level, &s.level) << "the level stays";
  }
  EXPECT_THAT(fields,
              ElementsAre("maxJumps", "segmentJumps", "timeLimit", "segmentTime", "maxDamage",
                          "waypoints[0].maxJumps", "waypoints[0].segmentTime"));
}

TEST(Relaxations, ATrajectoryShowsTheSufficientLimit) {
  const RelaxationsScene s(kGoal + R"(,"maxJumps":2,"timeLimit":3)");
  Trajectory p;
  p.end.jumps = 5;
  p.ticks = 194;  // 3.233 s
  const auto changes = limitChanges(s.failure());
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].enough(p), 3u);
  EXPECT_EQ(changes[1].enough(p), 3u);
  EXPECT_EQ(changes[0].text(3), "solvable with 5 jumps instead of 2");
  EXPECT_EQ(changes[1].text(3), "solvable in 3.3 s instead of 3");
  EXPECT_EQ(changes[1].text(kOff), "solvable without the limit of 3 s");
}

TEST(Relaxations, HigherJumpsAreHigherByThatShare) {
  const RelaxationsScene s(kGoal);
  const auto changes = jumpHeightChanges(s.failure());
  ASSERT_EQ(changes.size(), 1u);
  const RelaxedQuery r = s.relaxed(changes[0], 5);
  const auto height = [](const Params& p) { return riseOfLaunch(p, p.gravity, p.jumpSpeed); };
  const float before = height(s.level.view().params), after = height(r.posed().level.view().params);
  EXPECT_NEAR(after / before, 1.1f, 1e-4f);
  EXPECT_NEAR(changes[0].amount(5), double(after - before), 1e-3);
}

TEST(Relaxations, HigherJumpsAreNotTriedWithoutJumping) {
  EXPECT_THAT(jumpHeightChanges(RelaxationsScene(kGoal + R"(,"maxJumps":0)").failure()), IsEmpty());
  EXPECT_THAT(jumpHeightChanges(RelaxationsScene(kGoal + R"(,"forbid":["jumping"])").failure()),
              IsEmpty());
}

TEST(Relaxations, APartIsLoweredWithItsMotionAndTheGoalOnIt) {
  RelaxationsScene s(
      R"("goal":{"position":[0,8,-14],"size":[4,4,4]},"avoid":[{"position":[0,12,-26]}])");
  s.outcome.cut.emplace();
  s.outcome.cut->missing.to = 1;
  const auto changes = loweredChanges(s.failure());
  ASSERT_FALSE(changes.empty());
  EXPECT_EQ(changes[0].part, 1);
  const RelaxedQuery r = s.relaxed(changes[0], 15);
  const auto lift = r.posed().levelRecord.getParts()[1];
  EXPECT_FLOAT_EQ(lift.getPosition().getY(), 4);
  EXPECT_FLOAT_EQ(lift.getMotion().getKeys()[1].getPosition().getY(), 7);
  EXPECT_FLOAT_EQ(r.posed().levelRecord.getParts()[3].getPosition().getY(), 9.5f);
  EXPECT_FLOAT_EQ(r.posed().queryRecord.getAvoid()[0].getPosition().getY(), 12);
  EXPECT_FLOAT_EQ(r.posed().queryRecord.getGoal().getPosition().getY(), 6.5f);
  EXPECT_EQ(changes[0].text(15), "solvable with 'Lift' 1.5 studs lower");
}

TEST(Relaxations, APartThatKillsStaysAsSolidAsItWas) {
  RelaxationsScene s(kGoal);
  s.outcome.ends = {{sim::Outcome::fell, kNone, 9}, {sim::Outcome::killed, 2, 5}};
  const auto changes = killPartChanges(s.failure());
  ASSERT_EQ(changes.size(), 1u);
  const RelaxedQuery r = s.relaxed(changes[0], kOff);
  EXPECT_FALSE(r.posed().levelRecord.getParts()[2].hasKill());
  EXPECT_TRUE(r.posed().levelRecord.getParts()[2].getSolid());
  EXPECT_EQ(r.posed().levelRecord.getParts().size(), 5u);
}

TEST(Relaxations, TheOtherAvoidRegionsStay) {
  RelaxationsScene s(kGoal + R"(,"avoid":[{"name":"a"},{"name":"b"},{"name":"c"}])");
  s.outcome.ends = {{sim::Outcome::avoided, 1, 5}};
  const auto changes = avoidChanges(s.failure());
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].field, "avoid[1]");
  const RelaxedQuery r = s.relaxed(changes[0], kOff);
  const auto rest = r.posed().queryRecord.getAvoid();
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_EQ(std::string(rest[0].getName()), "a");
  EXPECT_EQ(std::string(rest[1].getName()), "c");
}

// The search has visited the floor and the lift, but not the far platform. Lava and crate do not
// count.
TEST(Relaxations, PartsToLowerAreOutsideTheVisitedPlaces) {
  RelaxationsScene s(kGoal);
  s.footprints.note({{0, 0, -2}, {0, 0, -6}, {0, 6, -14}});
  EXPECT_THAT(partsBeyond(s.failure(), 4), ElementsAre(3u));
}

// A method that always returns the same wrong trajectory, even after it was rejected.
SearchOutcome guess(const Problem& p, const Budget&, const Watcher& watcher, const Machine&) {
  Trajectory wrong;
  wrong.end = p.start;
  wrong.end.outcome = sim::Outcome::goal;
  wrong.actions = {{{0, true, false}, 30}};
  wrong.ticks = 30;
  SearchOutcome outcome;
  outcome.stopped = Stopped::outOfSteps;
  outcome.statistics.steps = 1'000'000;
  if (watcher.accept(wrong)) outcome.solutions.push_back(wrong);
  return outcome;
}

TEST(Relaxations, OnlyVerifiedSolutionsCount) {
  const RelaxationsScene s(kGoal + R"(,"maxJumps":2,"forbid":["climbing"])");
  const Method method{"guess", "", guess};
  ThreadPool pool(1);
  Budget budget;
  budget.maxSteps = 100'000'000;
  EXPECT_THAT(explain(s.failure(), method, budget, pool), IsEmpty());
}

}  // namespace
}  // namespace obby::solve
