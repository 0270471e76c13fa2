// The verifier refuses an answer whose replay differs from its record.
#include "walked_answer.h"

namespace obby::solve {
namespace {

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
  setRegion(q().initGoal(), {14, 2, -30},
            {1, 4, 30});  // the trajectory meets the box only if the rotation is applied
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

TEST_F(VerifierTest, RefusesAnotherFacing) {
  makeTrajectory();
  setRegion(q().initStart().initRegion(), {0, 2.5f, -2}, {2, 5, 2});  // feet at the spawn
  q().getStart().setYaw(1.5f);
  expectWrong("yawTurns");
  q().getStart().setYaw(0);
  EXPECT_TRUE(check()) << check().error().text();
}

TEST_F(VerifierTest, RefusesAnotherFacingThanTheSpawns) {
  makeTrajectory();
  ASSERT_TRUE(check()) << check().error().text();
  record.root().getLevel().getSpawns()[0].setYaw(1.5f);
  expectWrong("yawTurns");
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
  setRegion(avoid[0], {3.9f, 1, -16}, {1, 2, 1});  // the region is next to the trajectory
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

TEST_F(VerifierTest, RefusesADeathDeclaredAsAGoal) {
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
  makeTrajectory().setVisited(1);
  expectWrong("visited");
  makeTrajectory().setPart(0);
  expectWrong("part");
  makeTrajectory().setAvoid(0);
  expectWrong("avoid");
  t = makeTrajectory();
  t.setStateHash(t.getStateHash() ^ 1);
  expectWrong("stateHash");
}

// These fields serve readers that cannot replay.
TEST_F(VerifierTest, RefusesAPathThatItsActionsDoNotTake) {
  auto t = makeTrajectory();
  const auto plan = sim::planFromRecord(t.asReader());
  ASSERT_TRUE(plan);
  const std::vector<sim::World> worlds = sim::replay(level.view(), nullptr, *plan).worlds;
  support::set(t.initEndPosition(), worlds.back().position);
  auto path = t.initPath();
  path.setStep(1);
  auto points = path.initPoints(uint32_t(worlds.size()));
  std::vector<uint32_t> jumps;
  for (uint32_t i = 0; i < points.size(); ++i) {
    support::set(points[i], worlds[i].position);
    if (i > 0 && worlds[i].jumps > worlds[i - 1].jumps) jumps.push_back(i);
  }
  ASSERT_EQ(jumps.size(), 2u);
  auto jumpTicks = path.initJumpTicks(2);
  for (uint32_t i = 0; i < 2; ++i) jumpTicks.set(i, jumps[i]);
  EXPECT_TRUE(check()) << check().error().text();
  t.getEndPosition().setX(1);
  expectWrong("endPosition");
  support::set(t.getEndPosition(), worlds.back().position);
  points[7].setY(50);
  expectWrong("path.points[7]");
  support::set(points[7], worlds[7].position);
  jumpTicks.set(1, jumps[1] + 1);
  expectWrong("path.jumpTicks[1]");
  jumpTicks.set(1, jumps[1]);
  path.setStep(2);
  expectWrong("path.points");
  // Earlier versions omitted the last point and its tick.
  path.setStep(t.getTicks() - 1);
  auto two = path.initPoints(2);
  support::set(two[0], worlds[0].position);
  support::set(two[1], worlds[t.getTicks() - 1].position);
  EXPECT_TRUE(check()) << check().error().text();
  path.setTicks(t.getTicks());
  expectWrong("path.points");
}

// The path ends at the trajectory's end, however long the last key is held.
TEST_F(VerifierTest, AcceptsActionsBeyondTheEnd) {
  auto t = makeTrajectory();
  const uint32_t ticks = t.getTicks();
  t.getActions()[ticks - 1].setTicks(500);
  EXPECT_TRUE(check()) << check().error().text();
  const auto plan = sim::planFromRecord(t.asReader());
  ASSERT_TRUE(plan);
  const std::vector<sim::World> worlds = sim::replay(level.view(), nullptr, *plan).worlds;
  ASSERT_GT(worlds.size(), ticks + 2);
  auto path = t.initPath();
  path.setStep(ticks);
  auto points = path.initPoints(2);
  support::set(points[0], worlds[0].position);
  support::set(points[1], worlds[ticks].position);
  auto jumpTicks = path.initJumpTicks(t.getJumps());
  uint32_t jumps = 0;
  for (uint32_t i = 1; i <= ticks; ++i) {
    if (worlds[i].jumps > worlds[i - 1].jumps) jumpTicks.set(jumps++, i);
  }
  EXPECT_TRUE(check()) << check().error().text();
  path.setTicks(ticks + 1);
  expectWrong("path.ticks");
}

TEST_F(VerifierTest, RefusesChangedActions) {
  auto actions = makeTrajectory().getActions();
  for (uint32_t i = 10; i < 30; ++i) actions[i].setHeading(20000);
  EXPECT_FALSE(check());
}

}  // namespace
}  // namespace obby::solve
