// Tests the distance left along a guide, and which section of the guide counts for a player.
#include "train/guide.h"

#include <gtest/gtest.h>

#include <cmath>

#include "train/gaps.h"

namespace obby::train {
namespace {

TEST(Guide, TheDistanceIsAlongTheLineAndToTheLine) {
  const Guide guide({{0, 0, 0}, {0, 0, -10}, {10, 0, -10}});
  EXPECT_FLOAT_EQ(guide.studs(), 20);
  EXPECT_FLOAT_EQ(guide.left({0, 0, 0}, 0, 0), 20);
  EXPECT_FLOAT_EQ(guide.left({0, 3, -4}, 0, 0), 3 * 3 + 16);
  EXPECT_FLOAT_EQ(guide.left({10, 0, -10}, 0, 0), 0);
  EXPECT_FLOAT_EQ(guide.left({10, 0, -9}, 0, 0), 3) << "a shortcut counts";
}

TEST(Guide, TheNextTurnOfASpiralDoesNotCountYet) {
  const Guide guide({{0, 0, 0}, {10, 2, 0}, {10, 4, 10}, {0, 6, 10}, {0, 8, 0}, {10, 10, 0}});
  const float whole = guide.studs();
  EXPECT_FLOAT_EQ(guide.left({0, 0, 0}, whole - 5, 0), whole);
  // This position is straight above the start. The guide passes it after four sides of the spiral.
  EXPECT_LT(guide.left({0, 7, 0}, 0, 0), whole / 2);
  EXPECT_FLOAT_EQ(guide.left({0, 7, 0}, whole - 5, 0),
                  whole - 14 / std::sqrt(104.0f) + 3 * std::sqrt(49 - 196.0f / 104));
  EXPECT_GT(guide.left({-50, 0, 0}, 2 * whole, 0), whole)
      << "far away, some distance is still left";
}

// The guide doubles back after a waypoint, and its later lane is near.
TEST(Guide, APartBehindAnUnpassedWaypointDoesNotCount) {
  const Vec3 waypoint{-61, 2, 0};
  const Guide guide({{0, 0, 0}, {-60, 0, 0}, {70, 0, 0}}, std::span(&waypoint, 1));
  EXPECT_FLOAT_EQ(guide.left({-40, 0, 0}, 130, 0), 150);
  EXPECT_FLOAT_EQ(guide.left({-40, 0, 0}, 130, 1), 110);
  EXPECT_FLOAT_EQ(guide.left({-60, 0, 0}, 130, 0), 130) << "at the end of the part that counts";
}

TEST(Guide, WaypointsAreInTheOrderOfTheGuide) {
  // The guide passes the same place twice.
  const Vec3 waypoints[] = {{10, 0, 0}, {20, 0, 0}, {10, 0, 1}};
  const Guide guide({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}, {10, 0, 0}, {10, 0, 50}}, waypoints);
  const GuideView view = guide.view();
  ASSERT_EQ(view.stopCount, 3u);
  EXPECT_EQ(view.stops[0], 1u);
  EXPECT_EQ(view.stops[1], 2u);
  EXPECT_EQ(view.stops[2], 3u);
}

TEST(Guide, AWaypointAtTheStartLeavesTheWholeDistance) {
  const Vec3 waypoint{0, 0, 0};
  const Guide guide({{0, 0, 0}, {-60, 0, 0}, {70, 0, 0}}, std::span(&waypoint, 1));
  EXPECT_FLOAT_EQ(guide.left({0, 0, 0}, 0, 0), 190);
}

// Returns a level with a waypoint far away and a goal near the start.
Result<std::shared_ptr<const TrainingLevel>> outAndBack(const std::vector<Vec3>& route) {
  support::LevelBuilder b;
  b.block({-30, -0.5f, 0}, {80, 1, 8});
  b.spawn({0, 0, 0});
  capnp::MallocMessageBuilder query;
  auto q = query.initRoot<schema::Query>();
  q.setId("out and back");
  auto region = q.initWaypoints(1)[0].initRegion();
  support::set(region.initPosition(), {-60, 2, 0});
  support::set(region.initSize(), {4, 4, 4});
  support::set(q.initGoal().initPosition(), {5, 2, 0});
  support::set(q.getGoal().initSize(), {4, 4, 4});
  auto places = q.initRoute(uint32_t(route.size()));
  for (uint32_t i = 0; i < places.size(); ++i) support::set(places[i], route[i]);
  return TrainingLevel::make(b.record(), q.asReader());
}

TEST(Guide, HasTheWaypointsOfItsQuery) {
  for (const auto& level :
       {outAndBack({}),
        outAndBack({{0, 0, 0}, {-30, 0, 0}, {-60, 0, 0}, {-30, 0, 0}, {5, 0, 0}})}) {
    const TrainingView view = (*level)->view(3);
    Player p;
    p.world = (*level)->start();
    p.world.position = {-40, 0, 0};
    p.minLeft = 88;  // so large that the guide's way back counts
    judge(view, {}, p);
    EXPECT_GT(p.minLeft, 65 + 19) << "on the way out";
    p.world.waypoints = 1;
    judge(view, {}, p);
    EXPECT_LT(p.minLeft, 45 + 7) << "on the way back";
  }
}

TEST(Guide, AGuideNeedsPointsWithinTheWorld) {
  const std::pair<std::vector<Vec3>, const char*> bad[] = {
      {{{0, 0, 0}}, "route: expected 2 to 4096 places, found 1"},
      {std::vector<Vec3>(4097), "route: expected 2 to 4096 places, found 4097"},
      {{{0, 0, 0}, {0, NAN, 0}}, "route[1]: expected three numbers"},
      {{{0, 0, 0}, {0, 0, 0}, {2e6f, 0, 0}}, "route[2]: expected three numbers"}};
  for (const auto& [route, says] : bad) {
    const auto level = outAndBack(route);
    ASSERT_FALSE(level) << says;
    EXPECT_NE(level.error().text().find(says), std::string::npos) << level.error().text();
  }
}

}  // namespace
}  // namespace obby::train
