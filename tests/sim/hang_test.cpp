// A torso rests on an edge where no floor ray hits.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using support::LevelBuilder;

// A wall 4 studs wide along Z, its top 20 studs up. The player falls with 0.1 studs of its torso
// over the east edge.
const level::Level& wall() {
  static const auto level = LevelBuilder().block({0, 10, 0}, {4, 20, 200}).compile();
  return level;
}
constexpr Vec3 kOverTheEdge = {2 + 1 - 0.1f, 20.5f, 0};

TEST(Hang, APlayerCannotWalkAlongAnEdgeOnTheTorso) {
  Play play(wall(), kOverTheEdge);
  play.run(stand(), 60);
  ASSERT_EQ(play.world.state, sim::State::freefall);
  ASSERT_EQ(play.world.velocity.y, 0);
  play.run(walk(kNorth), 120);
  EXPECT_LT(absf(play.world.position.z), 1.0f);
}

// In the first few ticks a player can still walk onto the wall and stand up.
TEST(Hang, APlayerThatWalksInGetsUp) {
  Play play(wall(), kOverTheEdge);
  constexpr Turns kWest = 0x4000;
  play.run(walk(kWest), 8);
  play.run(stand(), 40);
  EXPECT_EQ(play.world.state, sim::State::running);
  EXPECT_NEAR(play.world.position.y, 20, 0.1);
}

}  // namespace
}  // namespace obby::test
