// The rules of a query in the simulator, one at a time. The player walks along -Z at 16 studs/s.
#include "sim/rules.h"

#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using sim::Outcome;
using sim::State;
using sim::World;
using support::LevelBuilder;

level::TargetView boxAt(float z, Vec3 half = {3, 3, 1}) { return {{{{0, 2, z}, {}}, half}}; }

struct RulesTest : testing::Test {
  level::Level level = flatLevel();
  level::QueryView query{boxAt(-40)};
  std::vector<level::WaypointView> waypoints;
  std::vector<level::TargetView> visits, goals, avoid;
  std::vector<uint32_t> touched;
  World last{};

  // `jumps` is the number of jumps before the player lets go of the key.
  Outcome play(int ticks = 300, int jumps = 0) {
    query.waypoints = waypoints.data(), query.waypointCount = uint32_t(waypoints.size());
    query.visits = visits.data(), query.visitCount = uint32_t(visits.size());
    query.otherGoals = goals.data(), query.otherGoalCount = uint32_t(goals.size());
    query.avoid = avoid.data(), query.avoidCount = uint32_t(avoid.size());
    query.touched = touched.data(), query.touchedCount = uint32_t(touched.size());
    World w = sim::makeWorld(level.view(), {});
    for (int t = 0; t < ticks; ++t) {
      sim::advance(w, nullptr, level.view(), &query, walk(kNorth, w.jumps < jumps));
    }
    last = w;
    return w.outcome;
  }
  void touch(level::TargetView& target, uint32_t collider) {
    target.firstTouch = uint32_t(touched.size());
    target.touchCount = 1;
    touched.push_back(collider);
  }
};

TEST_F(RulesTest, TheGoalEndsThePlaythrough) {
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_NEAR(last.position.z, -39, 0.4f);
}

TEST_F(RulesTest, TheGoalDoesNotCountBeforeTheWaypoints) {
  waypoints = {{boxAt(50)}};
  EXPECT_EQ(play(), Outcome::running);
  EXPECT_EQ(last.waypoints, 0);
}

TEST_F(RulesTest, WaypointsAreTakenInOrder) {
  waypoints = {{boxAt(-10)}, {boxAt(-20)}};
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_EQ(last.waypoints, 2);
  waypoints = {{boxAt(-20)}, {boxAt(-10)}};
  EXPECT_EQ(play(), Outcome::running);
  EXPECT_EQ(last.waypoints, 1);
}

TEST_F(RulesTest, AnAvoidRegionEndsIt) {
  avoid = {boxAt(-20)};
  EXPECT_EQ(play(), Outcome::avoided);
  EXPECT_EQ(last.part, 0u);
}

TEST_F(RulesTest, AThinAvoidRegionIsNotSteppedOver) {
  for (int i = 0; i < 60; ++i) {  // one tick of walking is 0.27 studs
    const float z = -20 - 0.01f * float(i);
    avoid = {boxAt(z, {3, 3, 0.001f})};
    ASSERT_EQ(play(), Outcome::avoided) << z;
    ASSERT_LT(last.position.z, z);
    ASSERT_GT(last.position.z, z - 0.28f);
    avoid = {boxAt(z, {3, 3, 0.001f}), boxAt(z, {3, 3, 1})};
    avoid[0].region.pose.position.x = 3.01f;  // the region is next to the trajectory
    ASSERT_EQ(play(), Outcome::avoided);
    ASSERT_EQ(last.part, 1u);
  }
}

TEST_F(RulesTest, AThinRegionIsReachedAtATickOnly) {
  int reached = 0;
  for (int i = 0; i < 30; ++i) {
    query.goal = boxAt(-20 - 0.01f * float(i), {3, 3, 0.03f});
    reached += play() == Outcome::goal;
  }
  EXPECT_GT(reached, 0);
  EXPECT_LT(reached, 30);
}

TEST_F(RulesTest, ATeleportPassesNothingInBetween) {
  LevelBuilder b = LevelBuilder().block({0, -1, 0}, {400, 2, 400});
  b.block({0, 2, -10}, {4, 4, 1}, [](schema::Part::Builder p) {
    p.setSolid(false);
    support::set(p.initTeleport().initPosition(), {0, 0, -30});
  });
  level = b.compile();
  avoid = {boxAt(-20)};
  EXPECT_EQ(play(), Outcome::goal);
  avoid = {boxAt(-30)};
  EXPECT_EQ(play(), Outcome::avoided) << "it ends in there";
  avoid = {boxAt(-35)};
  EXPECT_EQ(play(), Outcome::avoided) << "and goes on from there";
}

TEST_F(RulesTest, LanesDoNotSkipRegionsEither) {
  avoid = {boxAt(-20, {3, 3, 0.001f})};
  query.avoid = avoid.data(), query.avoidCount = 1;
  constexpr size_t kWorlds = 1100;  // several blocks
  std::vector<World> worlds(kWorlds, sim::makeWorld(level.view(), {}));
  std::vector<World*> pointers;
  for (size_t i = 0; i < kWorlds; ++i) {
    // Each world crosses the region at a different tick.
    worlds[i].position.z -= 0.25f * float(i) / kWorlds;
    pointers.push_back(&worlds[i]);
  }
  std::vector<World> alone = worlds;
  const std::vector<sim::Action> actions(kWorlds, walk(kNorth));
  for (int t = 0; t < 150; ++t) {
    sim::advanceAll(level.view(), &query, pointers, nullptr, actions.data());
    for (World& w : alone) sim::advance(w, nullptr, level.view(), &query, walk(kNorth));
  }
  for (size_t i = 0; i < kWorlds; ++i) {
    ASSERT_EQ(worlds[i].outcome, Outcome::avoided) << i;
    ASSERT_EQ(sim::stateHash(worlds[i]), sim::stateHash(alone[i])) << i;
  }
}

TEST_F(RulesTest, JumpsInTotal) {
  query.maxJumps = 1;
  EXPECT_EQ(play(300, 2), Outcome::jumps);
  EXPECT_EQ(play(300, 1), Outcome::goal);
}

TEST_F(RulesTest, JumpsOnArrivalAtAWaypoint) {
  waypoints = {{boxAt(-30, {3, 30, 1}), 0}};
  EXPECT_EQ(play(300, 1), Outcome::jumps);
  EXPECT_EQ(play(300, 0), Outcome::goal);
}

TEST_F(RulesTest, TimeInTotal) {
  query.timeLimitTicks = 100;
  EXPECT_EQ(play(), Outcome::timeout);
  EXPECT_EQ(last.tick, 100u);
}

TEST_F(RulesTest, AnyGoalEndsIt) {
  query.goal = boxAt(-400);
  goals = {boxAt(40), boxAt(-20)};
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_NEAR(last.position.z, -19, 0.4f);
}

TEST_F(RulesTest, VisitsAreTakenInAnyOrder) {
  visits = {boxAt(-20), boxAt(-10)};
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_EQ(last.visited, 3u);
  visits.push_back(boxAt(10));
  EXPECT_EQ(play(), Outcome::running);
  EXPECT_EQ(last.visited, 3u);
}

TEST_F(RulesTest, AllThirtyTwoVisitsCount) {
  for (int i = 0; i < 32; ++i) visits.push_back(boxAt(-1 - float(i)));
  EXPECT_EQ(play(), Outcome::goal);
  visits[31] = boxAt(10);
  EXPECT_EQ(play(), Outcome::running);
  EXPECT_EQ(last.visited, 0x7fffffffu);
}

TEST_F(RulesTest, TheGoalWaitsForEnoughJumps) {
  query.minJumps = 2;
  EXPECT_EQ(play(), Outcome::running);
  EXPECT_EQ(play(300, 2), Outcome::goal);
  query.maxJumps = 2;
  EXPECT_EQ(play(300, 2), Outcome::goal) << "exactly two";
  EXPECT_EQ(play(300, 3), Outcome::jumps);
}

TEST_F(RulesTest, JumpsOfASegment) {
  query.goal = boxAt(-60, {3, 30, 1});
  waypoints = {{boxAt(-8, {3, 30, 1})}};  // the waypoint lies below the first jump
  waypoints[0].segment.jumps = 1;
  query.last.jumps = 0;
  EXPECT_EQ(play(300, 1), Outcome::goal);
  EXPECT_EQ(last.segmentJumps, 1);
  EXPECT_EQ(play(300, 2), Outcome::jumps) << "the second jump is in the last segment";
  query.last.jumps = 1;
  EXPECT_EQ(play(300, 2), Outcome::goal);
  waypoints[0].segment.jumps = 0;
  EXPECT_EQ(play(300, 1), Outcome::jumps);
}

TEST_F(RulesTest, TimeOfASegment) {
  ASSERT_EQ(play(), Outcome::goal);
  const uint32_t all = last.tick;
  waypoints = {{boxAt(-20)}};
  ASSERT_EQ(play(), Outcome::goal);
  const uint32_t arrival = last.segmentTick;
  EXPECT_GT(arrival, all / 3);
  waypoints[0].segment.ticks = arrival;
  query.last.ticks = all - arrival;
  EXPECT_EQ(play(), Outcome::goal) << "arrival on the last tick counts";
  query.last.ticks = all - arrival - 1;
  EXPECT_EQ(play(), Outcome::timeout);
  EXPECT_EQ(last.tick, all - 1);
  query.last.ticks = 0;
  waypoints[0].segment.ticks = arrival - 1;
  EXPECT_EQ(play(), Outcome::timeout);
  waypoints[0].segment.ticks = 0;
  waypoints[0].ticks = arrival - 1;
  EXPECT_EQ(play(), Outcome::timeout);
  waypoints[0].ticks = arrival;
  EXPECT_EQ(play(), Outcome::goal);
}

TEST_F(RulesTest, SegmentsCountFromTheStartsTick) {
  waypoints = {{boxAt(-20)}};
  waypoints[0].segment.ticks = 120;
  World w = sim::makeWorld(level.view(), {{}, 0, 5000});
  query.startTick = 5000;
  query.waypoints = waypoints.data();
  query.waypointCount = 1;
  while (w.outcome == Outcome::running) {
    sim::advance(w, nullptr, level.view(), &query, walk(kNorth));
  }
  EXPECT_EQ(w.outcome, Outcome::goal);
}

TEST_F(RulesTest, ForbiddenStatesEndIt) {
  query.forbidden = 1u << uint32_t(State::climbing);
  EXPECT_EQ(play(300, 1), Outcome::goal);
  query.forbidden |= 1u << uint32_t(State::jumping);
  EXPECT_EQ(play(300, 1), Outcome::forbidden);
  EXPECT_EQ(play(300, 0), Outcome::goal);
}

// Posts stand on both sides of the trajectory. The arms reach 2.05 studs to each side.
struct TouchTest : RulesTest {
  TouchTest() {
    LevelBuilder b = LevelBuilder().block({0, -1, 0}, {400, 2, 400});
    b.block({2.5f, 5, -10}, {1, 10, 1});
    b.block({2.6f, 5, -20}, {1, 10, 1});
    level = b.compile();
  }
  uint32_t colliderOf(uint32_t part) const {
    uint32_t i = 0;
    while (level.view().colliders[i].part != part) ++i;
    return i;
  }
};

TEST_F(TouchTest, APartToTouchIsTouchedByAnArm) {
  visits = {boxAt(0)};
  touch(visits[0], colliderOf(1));
  EXPECT_EQ(play(), Outcome::goal);
  touch(visits[0], colliderOf(2));
  EXPECT_EQ(play(), Outcome::running);
}

TEST_F(TouchTest, APartNotToTouchEndsIt) {
  avoid = {boxAt(1000), boxAt(0)};
  touch(avoid[1], colliderOf(2));
  EXPECT_EQ(play(), Outcome::goal);
  touch(avoid[1], colliderOf(1));
  EXPECT_EQ(play(), Outcome::avoided);
  EXPECT_EQ(last.part, 1u) << "the index in the avoid list";
}

TEST_F(TouchTest, TheGoalCanBeAFloorToStandOn) {
  touch(query.goal, colliderOf(0));
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_LT(last.tick, 10u);
}

TEST_F(RulesTest, AMovingPartIsTouchedAtItsCurrentPosition) {
  LevelBuilder b = LevelBuilder().block({0, -1, 0}, {400, 2, 400});
  b.block({6, 2, -20}, {2, 4, 2}, [](schema::Part::Builder p) {
    p.setSolid(false);
    auto motion = p.initMotion();
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {6, 2, -20});
    keys[1].setTime(1);
    support::set(keys[1].initPosition(), {1, 2, -20});
    motion.setRepeat(schema::Repeat::ONCE);
    p.initKill().setDamage(1);
  });
  level = b.compile();
  visits = {boxAt(0)};
  for (uint32_t i = 0; i < level.view().colliderCount; ++i) {
    if (level.view().colliders[i].part == 1) touch(visits[0], i);
  }
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_EQ(last.visited, 1u);
}

TEST_F(RulesTest, TotalLostHealthIsLimited) {
  LevelBuilder b = LevelBuilder().block({0, -1, 0}, {400, 2, 400});
  for (const float z : {-10.0f, -20.0f}) {
    b.block({0, 1, z}, {8, 2, 0.5f}, [](schema::Part::Builder p) {
      p.setSolid(false);
      p.initKill().setDamage(15);
      p.getKill().setCooldown(0.3f);
    });
  }
  level = b.compile();
  EXPECT_EQ(play(), Outcome::goal);
  EXPECT_EQ(last.damage, 30) << "regeneration does not count against it";
  query.maxDamage = 30;
  EXPECT_EQ(play(), Outcome::goal);
  query.maxDamage = 29;
  EXPECT_EQ(play(), Outcome::hurt);
  query.maxDamage = 0;
  EXPECT_EQ(play(), Outcome::hurt);
  EXPECT_GT(last.position.z, -12);
}

}  // namespace
}  // namespace obby::test
