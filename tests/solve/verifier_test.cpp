// The verifier refuses an answer that breaks any one rule. The playthroughs are made by hand: walk
// along -Z over the stepping stones, jump where told, and record what the simulator does.
#include "solve/verifier.h"

#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "scenes.h"
#include "sim/rules.h"

namespace obby::solve {
namespace {

using Setter = std::function<void(schema::Query::Builder)>;

void setRegion(schema::Region::Builder region, Vec3 center, Vec3 size) {
  support::set(region.initPosition(), center);
  support::set(region.initSize(), size);
}

class VerifierTest : public testing::Test {
 protected:
  VerifierTest() {
    record.root().initLevel();
    record.root().setLevel(builder.record());
    auto q = query.root().initQuery();
    q.setId("q");
    setRegion(q.initGoal(), {0, 2, -28}, {8, 4, 8});
  }

  schema::Query::Builder q() { return query.root().getQuery(); }

  // Walks to the goal, pressing jump at the edges; the record says what the search would say.
  schema::Trajectory::Builder makeTrajectory(bool jumping = true) {
    sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
    auto compiled = level::Query::compile(q().asReader(), level);
    EXPECT_TRUE(compiled) << compiled.error().text();
    const level::QueryView view = compiled->view();
    auto t = trajectory.root().initTrajectory();
    std::vector<sim::Action> actions;
    while (w.outcome == sim::Outcome::running && actions.size() < 400) {
      const float z = w.position.z;
      const bool edge = (z < -7 && z > -9) || (z < -19 && z > -21);
      actions.push_back({0, true, jumping && edge});
      sim::advance(w, nullptr, level.view(), &view, actions.back());
    }
    auto runs = t.initActions(uint32_t(actions.size()));
    for (uint32_t i = 0; i < runs.size(); ++i) {
      runs[i].setWalk(true);
      runs[i].setJump(actions[i].jump);
    }
    t.setQuery("q");
    t.setLevel("test");
    t.setOutcome(schema::Outcome(w.outcome));
    support::set(t.initPosition(), level.spawns()[0].feet);
    t.setTicks(uint32_t(actions.size()));
    t.setJumps(w.jumps);
    t.setWaypoints(w.waypoints);
    t.setPart(w.part == level::kNone ? -1 : int32_t(w.part));
    t.setStateHash(sim::stateHash(w));
    return t;
  }

  Status check() {
    return verify(level, record.reader().getLevel(), query.reader().getQuery(),
                  trajectory.reader().getTrajectory());
  }
  void expectWrong(const std::string& field) {
    const Status status = check();
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().path, field) << status.error().text();
  }

  LevelBuilder builder = steppingStones();
  level::Level level = builder.compile();
  io::RecordBuilder record, query, trajectory;
};

TEST_F(VerifierTest, AcceptsARightAnswer) {
  auto t = makeTrajectory();
  ASSERT_EQ(t.getOutcome(), schema::Outcome::GOAL);
  EXPECT_EQ(t.getJumps(), 2u);
  EXPECT_TRUE(check()) << check().error().text();
}

TEST_F(VerifierTest, AcceptsAFailureThatIsRecordedAsOne) {
  EXPECT_EQ(makeTrajectory(false).getOutcome(), schema::Outcome::FELL);
  EXPECT_TRUE(check()) << check().error().text();
}

TEST_F(VerifierTest, RefusesAnEndShortOfTheGoal) {
  makeTrajectory();
  setRegion(q().initGoal(), {0, 2, -100}, {8, 4, 8});
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesAGoalReachedOnlyInARotatedBoxsBounds) {
  makeTrajectory();
  setRegion(q().initGoal(), {14, 2, -30}, {1, 4, 30});  // crosses the way only when turned
  expectWrong("outcome");
  auto r = q().getGoal().initRotation();
  r.setY(0.38268343f);  // 45 degrees
  r.setW(0.92387953f);
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesAnotherStart) {
  makeTrajectory();
  setRegion(q().initStart().initRegion(), {1, 2.5f, -2}, {2, 5, 2});
  expectWrong("position");
  setRegion(q().getStart().initRegion(), {0, 2.5f, -2}, {2, 5, 2});  // feet at the spawn
  EXPECT_TRUE(check()) << check().error().text();
}

TEST_F(VerifierTest, RefusesAnotherStartTick) {
  makeTrajectory();
  q().initStart().setTick(60);
  expectWrong("startTick");
}

TEST_F(VerifierTest, RefusesAMissedWaypoint) {
  makeTrajectory();
  setRegion(q().initWaypoints(1)[0].initRegion(), {3.5f, 2, -16}, {1, 4, 8});
  expectWrong("outcome");
}

TEST_F(VerifierTest, AcceptsWaypointsInOrderAndRefusesThemOutOfOrder) {
  auto waypoints = q().initWaypoints(2);
  setRegion(waypoints[0].initRegion(), {0, 2, -6}, {8, 4, 2});
  setRegion(waypoints[1].initRegion(), {0, 2, -16}, {8, 4, 2});
  ASSERT_EQ(makeTrajectory().getOutcome(), schema::Outcome::GOAL);
  EXPECT_TRUE(check()) << check().error().text();
  setRegion(waypoints[0].initRegion(), {0, 2, -16}, {8, 4, 2});
  setRegion(waypoints[1].initRegion(), {0, 2, -6}, {8, 4, 2});
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesTooManyJumpsAtAWaypoint) {
  auto waypoints = q().initWaypoints(1);
  setRegion(waypoints[0].initRegion(), {0, 2, -16}, {8, 4, 2});
  waypoints[0].setMaxJumps(1);
  ASSERT_EQ(makeTrajectory().getOutcome(), schema::Outcome::GOAL);
  EXPECT_TRUE(check()) << check().error().text();
  waypoints[0].setMaxJumps(0);
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesTooManyJumpsInTotal) {
  makeTrajectory();
  q().setMaxJumps(2);
  EXPECT_TRUE(check());
  q().setMaxJumps(1);
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesAnAvoidedRegion) {
  makeTrajectory();
  auto avoid = q().initAvoid(1);
  setRegion(avoid[0], {3.9f, 1, -16}, {1, 2, 1});  // beside the way
  EXPECT_TRUE(check());
  setRegion(avoid[0], {0, 7, -10}, {8, 6, 0.5f});  // the head passes through on the first jump
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesALateArrival) {
  const uint32_t ticks = makeTrajectory().getTicks();
  q().setTimeLimit(float(ticks) / 60.0f);
  EXPECT_TRUE(check());
  q().setTimeLimit(float(ticks - 1) / 60.0f);
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesADeathSoldAsAGoal) {
  makeTrajectory(false).setOutcome(schema::Outcome::GOAL);
  expectWrong("outcome");
}

TEST_F(VerifierTest, RefusesWrongTotalsAndHashes) {
  auto t = makeTrajectory();
  t.setTicks(t.getTicks() + 1);
  expectWrong("ticks");
  makeTrajectory().setJumps(0);
  expectWrong("jumps");
  makeTrajectory().setWaypoints(1);
  expectWrong("waypoints");
  makeTrajectory().setPart(0);
  expectWrong("part");
  t = makeTrajectory();
  t.setStateHash(t.getStateHash() ^ 1);
  expectWrong("stateHash");
}

TEST_F(VerifierTest, RefusesChangedActions) {
  makeTrajectory().getActions()[20].setHeading(200);
  EXPECT_FALSE(check());
}

}  // namespace
}  // namespace obby::solve
