#include "solve/model/route.h"

#include <gtest/gtest.h>

#include "hand_played.h"

namespace obby::solve {
namespace {

using Route = std::vector<int32_t>;

TEST(Route, ListsSupportingPartsInOrder) {
  const level::Level level = steppingStones().compile();
  PlainQuery asked(level);
  const Problem problem = asked.problem();
  const auto keys = [](const sim::World& w) {
    const float z = w.position.z;
    return sim::Action{0, true, (z < -7 && z > -9) || (z < -19 && z > -21)};
  };
  const Course course = courseOf(problem, playByHand(problem, keys));
  ASSERT_EQ(course.replay.worlds.back().outcome, sim::Outcome::goal);
  EXPECT_EQ(course.ticks(), course.replay.worlds.size() - 1);
  // The player reaches the goal in the air above the third stone.
  EXPECT_EQ(routeOf(course), (Route{0, 1}));
}

TEST(Route, SegmentsCoverTheCourseWithoutGaps) {
  GapScene scene(5);
  scene.problem.query.goal = boxAt({0, 2, -20}, {8, 4, 2});
  const Course course = scene.jumpAt(-7);
  ASSERT_EQ(course.replay.worlds.back().outcome, sim::Outcome::goal);
  const std::vector<Segment> segments = segmentsOf(course);
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].start, 0u);
  EXPECT_EQ(segments[0].from, 0);
  EXPECT_EQ(segments[0].to, 1);
  EXPECT_EQ(segments[0].jumps, 1u);
  EXPECT_EQ(segments[1].start, segments[0].end());
  EXPECT_EQ(segments[1].from, 1);
  EXPECT_EQ(segments[1].to, -1);
  EXPECT_EQ(segments[1].jumps, 0u);
  EXPECT_EQ(segments[1].end(), course.ticks());
  // The segment begins with the landing on the second platform.
  EXPECT_LT(course.at(segments[1].start - 1).velocity.y, -30);
  EXPECT_LT(course.at(segments[1].start).position.z, -12.5f);
}

TEST(Route, AStartInTheAirHasNoSupport) {
  LevelBuilder b = GapScene::build(5, 8);
  b.block({0, 9.5f, -2}, {2, 1, 2}, [](schema::Part::Builder p) { p.setSolid(false); });
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.start.position.y = 10;
  problem.query.goal = boxAt({0, 2, -7}, {8, 4, 1});
  const auto keys = [](const sim::World& w) { return sim::Action{0, w.position.y < 1, false}; };
  const std::vector<Segment> segments = segmentsOf(courseOf(problem, playByHand(problem, keys)));
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].from, -1);
  EXPECT_EQ(segments[0].to, 0);
}

TEST(Route, TrussesAndMovingPlatformsCarry) {
  LevelBuilder b;
  b.block({0, -0.5f, -4}, {8, 1, 8});
  b.part([](schema::Part::Builder p) {
    p.setShape(schema::Shape::TRUSS);
    support::set(p.initPosition(), {0, 6, -9});
    support::set(p.initSize(), {2, 12, 2});
  });
  b.block({0, 11.5f, -14}, {8, 1, 8}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 11.5f, -14});
    support::set(keys[1].initPosition(), {1, 11.5f, -14});
    keys[1].setTime(2);
  });
  b.spawn({0, 0, -2});
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.query.goal = boxAt({0, 13, -17}, {8, 4, 2});
  const Trajectory p = playByHand(problem, [](const sim::World&) {
    return sim::Action{0, true, false};
  });
  ASSERT_EQ(p.end.outcome, sim::Outcome::goal);
  const Route route = routeOf(courseOf(problem, p));
  ASSERT_GE(route.size(), 3u);
  EXPECT_EQ(route.front(), 0);
  EXPECT_EQ(route[1], 1);
  EXPECT_EQ(route.back(), 2);
}

TEST(Route, SeatsAndDynamicPartsCarry) {
  LevelBuilder b;
  b.block({0, -0.5f, -10}, {8, 1, 20});
  b.block({0, 0.5f, -6}, {2, 1, 2}, [](schema::Part::Builder p) { p.initSeat(); });
  b.block({0, 0.5f, -16}, {8, 1, 4}, [](schema::Part::Builder p) { p.setAnchored(false); });
  b.spawn({0, 0, -2});
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.query.goal = boxAt({0, 3, -17.5f}, {8, 4, 1});
  const Trajectory p = playByHand(problem, [](const sim::World& w) {
    const bool leaves = w.state == sim::State::seated && w.tick > 60;
    return sim::Action{0, true, leaves};
  });
  ASSERT_EQ(p.end.outcome, sim::Outcome::goal);
  const Route route = routeOf(courseOf(problem, p));
  ASSERT_GE(route.size(), 3u);
  EXPECT_EQ(route[0], 0);
  EXPECT_EQ(route[1], 1);
  EXPECT_EQ(route.back(), 2);
}

TEST(Route, AToeBeyondTheSeamIsNotAnotherSupport) {
  LevelBuilder b;
  // Two adjacent floors, and a pebble that the player brushes.
  b.block({-4, -0.5f, -20}, {8, 1, 40}).block({4, -0.5f, -20}, {8, 1, 40});
  b.block({-0.9f, 0.05f, -10}, {0.2f, 0.1f, 0.2f});
  b.spawn({0, 0, -2});
  const level::Level level = b.compile();
  PlainQuery asked(level);
  Problem problem = asked.problem();
  problem.query.goal = boxAt({0, 2, -30}, {8, 4, 2});
  const Trajectory p = playByHand(problem, [](const sim::World&) {
    return sim::Action{0, true, false};
  });
  ASSERT_EQ(p.end.outcome, sim::Outcome::goal);
  EXPECT_EQ(routeOf(courseOf(problem, p)), (Route{0}));
}

}  // namespace
}  // namespace obby::solve
