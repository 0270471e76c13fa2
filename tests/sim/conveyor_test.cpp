// Conveyors that move upwards, and turning conveyors on a part that has moved.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using support::LevelBuilder;

// At each of these heights the feet rest exactly on the floor when it begins to lift them.
TEST(Conveyor, a_rising_conveyor_never_exceeds_its_own_speed) {
  constexpr float kSpeed = 8;
  for (const float height : {0.0f, 1.0f, 10.0f, 100.0f, 1000.0f}) {
    const auto level = LevelBuilder()
                           .block({0, height - 1, 0}, {40, 2, 40},
                                  [](Part::Builder p) {
                                    support::set(p.initConveyor().initVelocity(), {0, kSpeed, 0});
                                  })
                           .compile();
    Play play(level, {0, height, 0});
    play.run(stand(), 30);
    float fastest = 0;
    for (const sim::World& w : play.history) fastest = maxf(fastest, w.velocity.y);
    EXPECT_GT(fastest, 0) << height;
    EXPECT_LE(fastest, kSpeed) << height;
  }
}

// The player stands 12 studs from the middle. The middle stays at the motion's only key, or moves
// from there at 6 studs/s, far from the part's own position.
TEST(Conveyor, a_turning_conveyor_turns_about_its_moved_part) {
  constexpr float kTurn = 2;  // rad/s
  for (const uint32_t keyCount : {1u, 2u}) {
    const auto level = LevelBuilder()
                           .block({0, -1, 0}, {60, 2, 60},
                                  [=](Part::Builder p) {
                                    support::set(p.initConveyor().initAngular(), {0, kTurn, 0});
                                    auto keys = p.initMotion().initKeys(keyCount);
                                    for (uint32_t k = 0; k < keyCount; ++k) {
                                      const float at = 100 + 60 * float(k);
                                      support::set(keys[k].initPosition(), {at, -1, 0});
                                      keys[k].setTime(10 * float(k));
                                    }
                                  })
                           .compile();
    Play play(level, {112, 0, 0});
    play.run(stand(), 20);
    const float gone = keyCount == 1 ? 0.0f : 6 * 20 * kTick;
    const Vec3 from = play.world.position - Vec3{100 + gone, 0, 0}, v = play.world.velocity;
    EXPECT_NEAR(v.x, kTurn * from.z, 2)
        << keyCount;  // within 2 studs/s: the conveyor is a tick behind, which is 0.8 studs/s
    EXPECT_NEAR(v.z, -kTurn * from.x, 2) << keyCount;
  }
}

// A box 6 studs east of the middle is carried around it, first northwards, by a radian in one
// second.
TEST(Conveyor, a_turning_conveyor_turns_dynamic_parts_about_its_part) {
  const auto level =
      LevelBuilder()
          .block({0, -1, 0}, {60, 2, 60},
                 [](Part::Builder p) {
                   p.setFriction(1);
                   support::set(p.initConveyor().initAngular(), {0, 1, 0});
                   support::set(p.initMotion().initKeys(1)[0].initPosition(), {100, -1, 0});
                 })
          .block({106, 1, 0}, {4, 2, 4},
                 [](Part::Builder p) {
                   p.setAnchored(false);
                   p.setFriction(1);
                 })
          .compile();
  Play play(level, {120, 0, 20});
  play.run(stand(), 60);
  EXPECT_NEAR(play.bodies[0].position.x, 100 + 6 * 0.540f, 1);
  EXPECT_NEAR(play.bodies[0].position.z, -6 * 0.841f, 1);
}

}  // namespace
}  // namespace obby::test
