// Parts share a clock if their touches have the same effect.
#include <gtest/gtest.h>

#include "support/level_builder.h"

namespace obby::level {
namespace {

// Returns the number of clocks in addition to one per role.
uint32_t sharedClocks(support::LevelBuilder& b) {
  const Level level = b.compile();
  return level.view().clockCount - level.view().roleCount;
}

TEST(Clocks, BoostsAndTripsThatDoTheSameShareOne) {
  support::LevelBuilder b;
  const auto boost = [&](float walk, float seconds) {
    b.block({0, 0, 0}, {4, 1, 4}, [=](schema::Part::Builder p) {
      p.initBoost().setWalkSpeed(walk);
      p.getBoost().setSeconds(seconds);
    });
  };
  boost(2, 5), boost(2, 5), boost(3, 5), boost(2, 6), boost(3, 5);
  EXPECT_EQ(sharedClocks(b), 3u);
  for (const float seconds : {1.0f, 2.0f, 1.0f}) {
    b.block({0, 0, 0}, {4, 1, 4},
            [=](schema::Part::Builder p) { p.initTrip().setSeconds(seconds); });
  }
  EXPECT_EQ(sharedClocks(b), 5u);
}

}  // namespace
}  // namespace obby::level
