// Query records compile to regions and limits. Tests the start, and errors.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/level_builder.h"

namespace obby::level {
namespace {

using support::set;
using QuerySetter = std::function<void(schema::Query::Builder)>;

constexpr float kQueryNan = std::numeric_limits<float>::quiet_NaN();

Level arena() {
  support::LevelBuilder b;
  b.block({0, 0, 0}, {10, 1, 10}).spawn({1, 2, 3}, 0.5f).spawn({4, 5, 6}, 1.5f);
  return b.compile();
}

Result<Query> compile(const QuerySetter& setter, const Level& level = arena()) {
  capnp::MallocMessageBuilder message;
  auto record = message.initRoot<schema::Query>();
  set(record.initGoal().initPosition(), {0, 1, 0});
  setter(record);
  return Query::compile(record.asReader(), level);
}

void queryExpectRefused(const QuerySetter& setter, const std::string& path,
                        const std::string& words) {
  const auto query = compile(setter);
  ASSERT_FALSE(bool(query)) << path;
  EXPECT_EQ(query.error().path, path);
  EXPECT_NE(query.error().message.find(words), std::string::npos) << query.error().text();
}

TEST(QueryStart, DefaultsToTheFirstSpawn) {
  const Query q = *compile([](auto) {});
  EXPECT_TRUE(q.start().feet == (Vec3{1, 2, 3}));
  EXPECT_EQ(q.start().yaw, 0.5f);
}

TEST(QueryStart, IsTheNamedSpawnAtTheNamedTick) {
  const Query q = *compile([](auto r) { r.initStart().setSpawn(1), r.getStart().setTick(77); });
  EXPECT_TRUE(q.start().feet == (Vec3{4, 5, 6}));
  EXPECT_EQ(q.start().tick, 77u);
  EXPECT_EQ(q.view().startTick, 77u);
}

TEST(QueryStart, IsTheCentreOfTheRegionsFloor) {
  const auto at = [](Quat rotation) {
    return compile([=](schema::Query::Builder r) {
             auto region = r.initStart().initRegion();
             set(region.initPosition(), {10, 20, 30});
             set(region.initSize(), {2, 8, 4});
             auto q = region.initRotation();
             q.setX(rotation.x), q.setY(rotation.y), q.setZ(rotation.z), q.setW(rotation.w);
             r.getStart().setYaw(2);
           })
        ->start();
  };
  EXPECT_TRUE(at({}).feet == (Vec3{10, 16, 30}));
  EXPECT_EQ(at({}).yaw, 2.0f);
  EXPECT_NEAR(at({0, 1, 0, 1}).feet.y, 16, 1e-4f);
  EXPECT_NEAR(at({1, 0, 0, 1}).feet.y, 18, 1e-4f);  // lying: Z is up
  EXPECT_NEAR(at({0, 0, 1, 1}).feet.y, 19, 1e-4f);  // lying: X is up
}

TEST(QueryLimits, AreTicksAndCounts) {
  const Query q = *compile([](schema::Query::Builder r) {
    r.setId("a");
    r.setMaxJumps(3);
    r.setTimeLimit(2.5f);
    auto waypoints = r.initWaypoints(2);
    waypoints[0].initRegion();
    waypoints[1].initRegion();
    waypoints[1].setMaxJumps(1);
    r.initAvoid(1);
  });
  EXPECT_EQ(q.id(), "a");
  const QueryView v = q.view();
  EXPECT_EQ(v.maxJumps, 3);
  EXPECT_EQ(v.timeLimitTicks, 150u);
  ASSERT_EQ(v.waypointCount, 2u);
  EXPECT_EQ(v.waypoints[0].maxJumps, -1);
  EXPECT_EQ(v.waypoints[1].maxJumps, 1);
  EXPECT_EQ(v.avoidCount, 1u);
  EXPECT_TRUE(v.goal.region.half == (Vec3{2, 2, 2}));
}

TEST(QueryLimits, CoverSegmentsVisitsGoalsStatesAndHealth) {
  const Query q = *compile([](schema::Query::Builder r) {
    set(r.initGoals(2)[1].initPosition(), {0, 7, 0});
    set(r.initVisits(1)[0].initPosition(), {0, 3, 0});
    auto waypoint = r.initWaypoints(1)[0];
    waypoint.initRegion();
    waypoint.setSegmentJumps(2);
    waypoint.setSegmentTime(1);
    waypoint.setTimeLimit(1.5f);
    r.setSegmentJumps(3);
    r.setSegmentTime(2);
    r.setMinJumps(4);
    r.setMaxDamage(25);
    r.initForbid(1).set(0, schema::PlayerState::CLIMBING);
  });
  const QueryView v = q.view();
  ASSERT_EQ(v.otherGoalCount, 2u);
  EXPECT_EQ(v.otherGoals[1].region.pose.position.y, 7);
  ASSERT_EQ(v.visitCount, 1u);
  EXPECT_EQ(v.visits[0].region.pose.position.y, 3);
  EXPECT_EQ(v.waypoints[0].segment.jumps, 2);
  EXPECT_EQ(v.waypoints[0].segment.ticks, 60u);
  EXPECT_EQ(v.waypoints[0].ticks, 90u);
  EXPECT_EQ(v.last.jumps, 3);
  EXPECT_EQ(v.last.ticks, 120u);
  EXPECT_EQ(v.minJumps, 4);
  EXPECT_EQ(v.maxDamage, 25);
  EXPECT_EQ(v.forbidden, 1u << 5);
}

TEST(QueryLimits, GoalsCanStandInForTheGoal) {
  const Query q = *compile([](schema::Query::Builder r) {
    r.disownGoal();
    set(r.initGoals(1)[0].initPosition(), {0, 7, 0});
  });
  EXPECT_EQ(q.view().goal.region.pose.position.y, 7);
  EXPECT_EQ(q.view().otherGoalCount, 0u);
}

// A part with two hulls and one that nothing can touch.
TEST(QueryTouch, LooksUpThePartsColliders) {
  support::LevelBuilder b;
  b.block({0, 0, 0}, {10, 1, 10}).spawn({0, 1, 0});
  b.block({0, 9, 0}, {1, 1, 1}, [](auto p) { p.setSolid(false); });
  const Level level = b.compile();
  const auto touching = [](uint32_t part) {
    return [=](schema::Query::Builder r) {
      r.getGoal().setTouch(true);
      r.getGoal().setPartIndex(int32_t(part));
    };
  };
  const auto floor = compile(touching(0), level);
  ASSERT_TRUE(floor) << floor.error().text();
  const QueryView v = floor->view();
  ASSERT_EQ(v.goal.touchCount, 1u);
  EXPECT_EQ(level.view().colliders[v.touched[v.goal.firstTouch]].part, 0u);
  const auto air = compile(touching(1), level);
  ASSERT_FALSE(air);
  EXPECT_NE(air.error().message.find("'part:1' cannot be touched"), std::string::npos);
  EXPECT_EQ(compile(touching(7), level).error().path, "goal.partIndex");
}

// Dynamic parts have their colliders after all others, and a part with two hulls has two.
TEST(QueryTouch, ListsEachPartsCollidersOnceAndInOrder) {
  support::LevelBuilder b;
  b.block({0, 9, 0}, {2, 2, 2}, [](auto p) { p.setAnchored(false); }).spawn({0, 1, 0});
  b.block({0, 0, 0}, {10, 1, 10}, [](auto p) {
    p.setShape(schema::Shape::HULL);
    auto hulls = p.initHulls(2);
    for (uint32_t i = 0; i < 2; ++i) {
      auto v = hulls[i].initVertices(4);
      set(v[1], {1, 0, 0}), set(v[2], {0, 1, 0}), set(v[3], {0, 0, 1});
    }
  });
  b.block({0, -9, 0}, {2, 2, 2});
  const Level level = b.compile();
  const auto query = compile(
      [](auto r) {
        auto avoid = r.initAvoid(4);
        const int32_t parts[] = {2, 0, 1, 0};
        for (uint32_t i = 0; i < 4; ++i) {
          avoid[i].setTouch(true);
          avoid[i].setPartIndex(parts[i]);
        }
      },
      level);
  ASSERT_TRUE(query) << query.error().text();
  const QueryView v = query->view();
  const auto touched = [&v](uint32_t i) {
    const uint32_t* first = v.touched + v.avoid[i].firstTouch;
    return std::vector<uint32_t>(first, first + v.avoid[i].touchCount);
  };
  using Colliders = std::vector<uint32_t>;
  EXPECT_EQ(touched(0), (Colliders{2}));
  EXPECT_EQ(touched(1), (Colliders{3}));
  EXPECT_EQ(touched(2), (Colliders{0, 1}));
  EXPECT_EQ(touched(3), (Colliders{3}));
  EXPECT_EQ(v.touchedCount, 4u) << "what is named again is there already";
}

TEST(QueryLimits, AWholeNumberOfTicksIsNotLostToRounding) {
  for (uint32_t ticks = 1; ticks < 100000; ticks = ticks * 21 / 20 + 1) {
    const float seconds = float(double(ticks) / 60);
    EXPECT_EQ(compile([=](auto r) { r.setTimeLimit(seconds); })->view().timeLimitTicks, ticks);
  }
  EXPECT_EQ(compile([](auto r) { r.setTimeLimit(100.7f); })->view().timeLimitTicks, 6042u);
  EXPECT_EQ(compile([](auto r) { r.setTimeLimit(100.69f); })->view().timeLimitTicks, 6041u);
}

TEST(QueryLimits, ATimeLimitBeyondEveryPlaythroughIsFine) {
  for (const float seconds : {1e8f, 1e12f, 1e30f}) {
    EXPECT_GT(compile([=](auto r) { r.setTimeLimit(seconds); })->view().timeLimitTicks, 1u << 30);
  }
}

TEST(QueryErrors, NameThePathAndTheExpectation) {
  queryExpectRefused([](auto r) { r.initStart().setSpawn(2); }, "start.spawn", "0 to 1, found 2");
  queryExpectRefused([](auto r) { r.disownGoal(); }, "goal", "has no goal");
  queryExpectRefused(
      [](auto r) {
        set(r.getGoal().initSize(), {1, 0, 1});
      },
      "goal.size", "above 0");
  queryExpectRefused(
      [](auto r) {
        set(r.getGoal().initPosition(), {kQueryNan, 0, 0});
      },
      "goal.position", "three numbers");
  queryExpectRefused([](auto r) { r.getGoal().initRotation().setW(0); }, "goal.rotation",
                     "length is 0.001 to 1000");
  queryExpectRefused([](auto r) { r.initWaypoints(1); }, "waypoints[0].region", "has no region");
  queryExpectRefused(
      [](auto r) {
        set(r.initAvoid(2)[1].initSize(), {-1, 1, 1});
      },
      "avoid[1].size", "above 0");
  queryExpectRefused([](auto r) { r.initWaypoints(256); }, "waypoints", "at most 255");
  queryExpectRefused([](auto r) { r.setTimeLimit(-1); }, "timeLimit", "seconds");
  queryExpectRefused([](auto r) { r.setTimeLimit(kQueryNan); }, "timeLimit", "seconds");
  queryExpectRefused([](auto r) { r.setSegmentTime(-1); }, "segmentTime", "seconds");
  queryExpectRefused(
      [](auto r) {
        r.initWaypoints(1)[0].initRegion(), r.getWaypoints()[0].setSegmentTime(kQueryNan);
      },
      "waypoints[0].segmentTime", "seconds");
  queryExpectRefused([](auto r) { r.initVisits(33); }, "visits", "at most 32 visits, found 33");
  queryExpectRefused([](auto r) { r.setMinJumps(3), r.setMaxJumps(2); }, "minJumps",
                     "expected minJumps <= maxJumps, found 3 and 2");
  queryExpectRefused([](auto r) { r.setMinJumps(65536); }, "minJumps", "at most 65535");
  queryExpectRefused([](auto r) { r.setMaxDamage(-2); }, "maxDamage", "health");
  queryExpectRefused([](auto r) { r.setMaxJumps(-2); }, "maxJumps", "(-1: any)");
  queryExpectRefused([](auto r) { r.setSegmentJumps(-3); }, "segmentJumps", "(-1: any)");
  queryExpectRefused(
      [](auto r) { r.initWaypoints(1)[0].initRegion(), r.getWaypoints()[0].setMaxJumps(-2); },
      "waypoints[0].maxJumps", "(-1: any)");
  queryExpectRefused(
      [](auto r) { r.initWaypoints(1)[0].initRegion(), r.getWaypoints()[0].setSegmentJumps(-2); },
      "waypoints[0].segmentJumps", "(-1: any)");
  queryExpectRefused([](auto r) { r.initStart().setSpawn(-2); }, "start.spawn", "0 to 1, found -2");
  queryExpectRefused([](auto r) { r.initForbid(1).set(0, schema::PlayerState::FREEFALL); },
                     "forbid[0]", "every trajectory has this state, so it cannot be forbidden");
  queryExpectRefused([](auto r) { r.getGoal().setTouch(true); }, "goal.touch", "only a part");
  queryExpectRefused([](auto r) { r.initVisits(1)[0].setPart("Top"); }, "visits[0].part",
                     "lacks its position and size");
  queryExpectRefused([](auto r) { r.initStart().initRegion().setPart("Top"); }, "start.region.part",
                     "lacks its position and size");
  queryExpectRefused([](auto r) { r.setTimeLimit(0.01f); }, "timeLimit", "one tick");
  for (const float yaw : {kQueryNan, 1e30f}) {
    queryExpectRefused([=](auto r) { r.initStart().initRegion(), r.getStart().setYaw(yaw); },
                       "start.yaw", "radians");
  }
}

// Coordinates are bounded, because the search divides positions into cells and a trajectory stores
// them.
TEST(QueryErrors, AStartRegionWithoutAFloorInReach) {
  const auto refuse = [](float middle, float height) {
    queryExpectRefused(
        [=](auto r) {
          auto region = r.initStart().initRegion();
          set(region.initPosition(), {0, middle, 0});
          set(region.initSize(), {4, height, 4});
        },
        "start.region", "1000000 studs");
  };
  refuse(0, 3e6f);
  refuse(0, 3e38f);
  refuse(-9e5f, 4e5f);
}

TEST(QueryErrors, ALevelWithoutSpawnNeedsAStartRegion) {
  support::LevelBuilder b;
  const auto query = compile([](auto) {}, b.block({0, 0, 0}, {1, 1, 1}).compile());
  ASSERT_FALSE(bool(query));
  EXPECT_EQ(query.error().path, "start");
  EXPECT_NE(query.error().message.find("no spawn"), std::string::npos);
}

}  // namespace
}  // namespace obby::level
