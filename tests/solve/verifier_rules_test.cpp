// The verifier refuses an answer that breaks any rule that a query can add. (verifier_test.cpp
// tests start, goal, order and totals.) For each rule it accepts an answer that just keeps the
// rule, and refuses one that just breaks it.
#include "walked_answer.h"

namespace obby::solve {
namespace {

using Rules = VerifierTest;
using schema::Outcome;

void name(schema::Region::Builder region, int32_t part) {
  region.setPartIndex(part);
  region.setTouch(true);
}

TEST_F(Rules, AnyOfSeveralGoalsEndsIt) {
  setRegion(q().getGoal(), {40, 2, 0}, {4, 4, 4});
  auto goals = q().initGoals(2);
  setRegion(goals[0], {-40, 2, 0}, {4, 4, 4});
  setRegion(goals[1], {0, 2, -16}, {8, 4, 2});
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  EXPECT_TRUE(check()) << check().error().text();
  setRegion(goals[1], {0, 2, -40}, {8, 4, 2});
  expectWrong("outcome");
}

TEST_F(Rules, VisitsCountInAnyOrderAndAllOfThem) {
  auto visits = q().initVisits(2);
  setRegion(visits[0], {0, 2, -16}, {8, 4, 2});
  setRegion(visits[1], {0, 2, -6}, {8, 4, 2});
  auto t = makeTrajectory();
  ASSERT_EQ(t.getOutcome(), Outcome::GOAL);
  EXPECT_EQ(t.getVisited(), 3u);
  EXPECT_TRUE(check()) << check().error().text();
  setRegion(visits[1], {3.5f, 2, -6}, {1, 4, 2});  // the region is next to the trajectory
  expectWrong("outcome");
}

TEST_F(Rules, AThinRegionToAvoidIsPassedBetweenTicks) {
  auto avoid = q().initAvoid(1);
  for (int i = 0; i < 30; ++i) {
    const float z = -16 - 0.01f * float(i);
    setRegion(avoid[0], {40, 2, z}, {8, 4, 0.002f});
    ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
    ASSERT_TRUE(check()) << check().error().text();
    setRegion(avoid[0], {0, 2, z}, {8, 4, 0.002f});
    expectWrong("outcome");
    ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::AVOIDED);
    ASSERT_TRUE(check()) << check().error().text();
  }
}

TEST_F(Rules, MinimumJumps) {
  q().setMinJumps(2);
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  EXPECT_TRUE(check()) << check().error().text();
  q().setMinJumps(3);
  expectWrong("outcome");
}

TEST_F(Rules, JumpsOfASegment) {
  auto waypoint = q().initWaypoints(1)[0];
  setRegion(waypoint.initRegion(), {0, 2, -16}, {8, 4, 2});
  waypoint.setSegmentJumps(1);
  q().setSegmentJumps(1);
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  EXPECT_TRUE(check()) << check().error().text();
  waypoint.setSegmentJumps(0);
  expectWrong("outcome");
  waypoint.setSegmentJumps(1);
  q().setSegmentJumps(0);
  expectWrong("outcome");
}

class TimeRules : public VerifierTest {
 protected:
  uint32_t arrivalAtTheWaypoint() {
    const auto compiled = *level::Query::compile(q().asReader(), level);
    const level::QueryView view = compiled.view();
    const auto plan = *sim::planFromRecord(trajectory.reader().getTrajectory());
    const auto worlds = sim::replay(level.view(), &view, plan).worlds;
    return worlds.back().segmentTick;
  }
};

TEST_F(TimeRules, TimeOfASegmentAndOnArrival) {
  auto waypoint = q().initWaypoints(1)[0];
  setRegion(waypoint.initRegion(), {0, 2, -16}, {8, 4, 2});
  const uint32_t all = makeTrajectory().getTicks();
  ASSERT_TRUE(check()) << check().error().text();
  const uint32_t arrival = arrivalAtTheWaypoint();
  const auto seconds = [](uint32_t ticks) { return float(ticks) / 60.0f; };
  waypoint.setTimeLimit(seconds(arrival));
  waypoint.setSegmentTime(seconds(arrival));
  q().setSegmentTime(seconds(all - arrival));
  EXPECT_TRUE(check()) << check().error().text();
  waypoint.setTimeLimit(seconds(arrival - 1));
  expectWrong("outcome");
  waypoint.setTimeLimit(0);
  waypoint.setSegmentTime(seconds(arrival - 1));
  expectWrong("outcome");
  waypoint.setSegmentTime(0);
  q().setSegmentTime(seconds(all - arrival - 1));
  expectWrong("outcome");
}

TEST_F(Rules, ForbiddenStates) {
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  q().initForbid(1).set(0, schema::PlayerState::CLIMBING);
  EXPECT_TRUE(check()) << check().error().text();
  q().getForbid().set(0, schema::PlayerState::JUMPING);
  expectWrong("outcome");
}

TEST_F(Rules, PartsToTouch) {
  auto visits = q().initVisits(1);
  name(visits[0], 1);
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  EXPECT_TRUE(check()) << check().error().text();
  name(q().getGoal(), 2);
  EXPECT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL) << "lands on the third stone";
  EXPECT_TRUE(check()) << check().error().text();
}

// A post within reach at the middle of the second stone, and one just out of the arms' reach.
class PostRules : public VerifierTest {
 protected:
  PostRules() : VerifierTest(posts()) {}
  static LevelBuilder posts() {
    LevelBuilder b = steppingStones();
    b.block({2.4f, 5, -16}, {1, 10, 1});   // the arms reach to 2.05 studs
    b.block({-2.6f, 5, -16}, {1, 10, 1});  // 0.05 studs beyond the arms' reach
    return b;
  }
};

TEST_F(PostRules, PartsNotToTouch) {
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  auto avoid = q().initAvoid(1);
  name(avoid[0], 4);
  EXPECT_TRUE(check()) << check().error().text();
  name(avoid[0], 3);
  expectWrong("outcome");
  auto t = makeTrajectory();
  EXPECT_EQ(t.getOutcome(), Outcome::AVOIDED);
  EXPECT_EQ(t.getAvoid(), 0);
  EXPECT_EQ(t.getPart(), -1);
  EXPECT_TRUE(check()) << check().error().text();
}

TEST_F(PostRules, AMissedPartWasNotTouched) {
  makeTrajectory();
  name(q().initVisits(1)[0], 3);
  expectWrong("visited");
  name(q().getVisits()[0], 4);
  expectWrong("outcome");
}

// A curtain on the second stone hurts.
class HotRules : public VerifierTest {
 protected:
  HotRules() : VerifierTest(hot()) {}
  static LevelBuilder hot() {
    LevelBuilder b = steppingStones();
    b.block({0, 1, -16}, {8, 2, 1}, [](schema::Part::Builder p) {
      p.setSolid(false);
      p.initKill().setDamage(20);
      p.getKill().setCooldown(10);
    });
    return b;
  }
};

TEST_F(HotRules, MaximumDamage) {
  ASSERT_EQ(makeTrajectory().getOutcome(), Outcome::GOAL);
  q().setMaxDamage(20);
  EXPECT_TRUE(check()) << check().error().text();
  q().setMaxDamage(19);
  expectWrong("outcome");
  EXPECT_EQ(makeTrajectory().getOutcome(), Outcome::HURT);
  EXPECT_TRUE(check()) << check().error().text();
}

}  // namespace
}  // namespace obby::solve
