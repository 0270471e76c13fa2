// Where the simulator has to leave parts out.
#include "solve/proof/crowding.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "sim/candidates.h"
#include "solve/proof/boxes.h"

namespace obby::solve {
namespace {

// Of a floor, and a row of small posts on it. `more`: of each post.
std::vector<Box> placesAmong(int posts, const LevelBuilder::PartSetter& more = {}) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {40, 1, 40}).spawn({0, 0, 0});
  for (int i = 0; i < posts; ++i) {
    b.block({0.1f * float(i) - 3, 0.5f, 5}, {0.05f, 1, 0.05f}, more);
  }
  const level::Level level = b.compile();
  return crowdedPlaces(level.view());
}

TEST(Crowding, IsWhereMorePartsAreNearThanATickHolds) {
  EXPECT_TRUE(placesAmong(0).empty());
  EXPECT_TRUE(placesAmong(sim::kMaxCandidates - 1).empty()) << "with the floor as many as it holds";
  const std::vector<Box> places = placesAmong(sim::kMaxCandidates);
  const Vec3 middle{0.05f * float(sim::kMaxCandidates) - 3, 0, 5};
  const bool found = std::any_of(places.begin(), places.end(), [&](const Box& b) {
    return isWithin({middle, middle}, b);
  });
  EXPECT_TRUE(found) << "of " << places.size();
}

TEST(Crowding, FewerMayMove) {
  const auto turns = [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(1); };
  EXPECT_TRUE(placesAmong(sim::kMaxMovingCandidates, turns).empty());
  EXPECT_FALSE(placesAmong(sim::kMaxMovingCandidates + 1, turns).empty());
  EXPECT_TRUE(placesAmong(sim::kMaxMovingCandidates + 1).empty()) << "standing still";
}

// However many the places are, some hundreds of boxes hold them.
TEST(Crowding, ManyPlacesAreJoined) {
  LevelBuilder b;
  b.spawn({0, 0, 0});
  for (int x = 0; x < 8; ++x) {
    for (int z = 0; z < 8; ++z) {
      const Vec3 at{60 * float(x), 0, 60 * float(z)};
      for (int i = 0; i <= sim::kMaxCandidates; ++i) b.block(at, {1, 1, 1});
    }
  }
  const level::Level level = b.compile();
  const std::vector<Box> places = crowdedPlaces(level.view());
  ASSERT_FALSE(places.empty());
  EXPECT_LE(places.size(), 256u);
  Box all = places[0];
  for (const Box& place : places) all = join(all, place);
  EXPECT_TRUE(isWithin({{0, 0, 0}, {420, 0, 420}}, all));
}

}  // namespace
}  // namespace obby::solve
