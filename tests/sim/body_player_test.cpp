// Forces between the player and dynamic bodies, against calculated values.
#include <gtest/gtest.h>

#include "play.h"

namespace obby::test {
namespace {

using support::LevelBuilder;

// Returns a floor that is long enough for a push of two seconds.
LevelBuilder longFloor() {
  return LevelBuilder{}.block({0, -1, 0}, {400, 2, 400}, [](auto p) { p.setFriction(0.5f); });
}

void loosen(schema::Part::Builder p, float density) {
  p.setAnchored(false);
  p.setDensity(density);
  p.setFriction(0.5f);
}

// Returns how far two seconds of walking push a box, in studs. The player's initial momentum is
// spent by then.
float pushed(float mass, float pushForce) {
  LevelBuilder b = longFloor();
  b.block({0, 2, 0}, {4, 4, 4}, [=](auto p) { loosen(p, mass / 64); });
  b.physics([=](auto p) { p.setPushForce(pushForce); });
  const level::Level level = b.compile();
  Play play(level, {0, 0, 6});
  play.settle().run(walk(kNorth), 120);
  const float from = play.bodies[0].position.z;
  play.run(walk(kNorth), 120);
  return from - play.bodies[0].position.z;
}

// Friction holds against up to 0.5 x 196.2 per unit of mass. The drive pushes with 12.6 x 2060 x
// the friction of the pair.
TEST(BodyPlayer, PushesBodiesThatFrictionDoesNotHold) {
  const float max = 12.6f * 2060 * 0.4f / (0.5f * 196.2f);
  EXPECT_GT(pushed(0.5f * max, 1e5f), 5);
  EXPECT_GT(pushed(0.85f * max, 1e5f), 1);
  EXPECT_LT(pushed(1.2f * max, 1e5f), 0.1f);
}

TEST(BodyPlayer, PushesNoHarderThanPushForce) {
  const float force = 1000, max = force / (0.5f * 196.2f);
  EXPECT_GT(pushed(0.8f * max, force), 1);
  EXPECT_LT(pushed(1.2f * max, force), 0.1f);
}

// The plank has mass 44.8, on a pillar two studs wide. A load of 12.6 tips it from 3.6 studs beyond
// the edge.
TEST(BodyPlayer, TipsAPlankFarFromItsSupport) {
  const auto tilt = [](float x) {
    LevelBuilder b = longFloor();
    b.block({0, 4, 0}, {2, 8, 4});
    b.block({0, 8.5f, 0}, {16, 1, 4}, [](auto p) { loosen(p, 0.7f); });
    const level::Level level = b.compile();
    Play play(level, {x, 9, 0});
    play.run(stand(), 90);
    return absf(toMat3(play.bodies[0].rotation).x.y);
  };
  EXPECT_LT(tilt(0), 0.01f);
  EXPECT_LT(tilt(3), 0.02f);
  EXPECT_GT(tilt(6.5f), 0.1f);
}

TEST(BodyPlayer, WalkingOnABallRollsItBack) {
  LevelBuilder b = longFloor();
  b.block({0, 4, 0}, {8, 8, 8}, [](auto p) {
    loosen(p, 0.3f);
    p.setShape(schema::Shape::BALL);
  });
  const level::Level level = b.compile();
  Play play(level, {0, 8, 0});
  play.run(stand(), 10).run(walk(kNorth), 10);
  EXPECT_GT(play.bodies[0].velocity.z, 0.5f);
  EXPECT_GT(play.bodies[0].spin.x, 0.1f);  // rolls toward +Z
}

// A falling player has no weight, but can jump from a body that falls at the same speed.
TEST(BodyPlayer, JumpsFromABodyThatFalls) {
  LevelBuilder b = longFloor();
  b.block({0, 200, 0}, {8, 4, 8}, [](auto p) { loosen(p, 4); });
  const level::Level level = b.compile();
  Play play(level, {0, 202, 0});
  play.run(stand(), 6);
  const auto above = [&] { return play.world.position.y - (play.bodies[0].position.y + 2); };
  const float gap = above();
  EXPECT_LT(gap, 1);
  play.run(stand(true), 1).run(stand(), 10);
  EXPECT_GT(above(), gap + 5);
}

// Bodies on a part that vanishes, by a timer or by a touch, fall with it.
TEST(BodyPlayer, BodiesFallWhenTheirFloorLeaves) {
  LevelBuilder b = longFloor();
  b.block({0, 10, 0}, {8, 2, 8}, [](auto p) {
    auto vanish = p.initVanish();
    vanish.setTrigger(schema::VanishTrigger::TIMER);
    vanish.setDelay(3);
    vanish.setAway(3);
  });
  b.block({0, 13, 0}, {4, 4, 4}, [](auto p) { loosen(p, 1); });
  b.block({40, 4, 0}, {20, 2, 8}, [](auto p) { p.initVanish().setDelay(0.2f); });
  b.block({35, 7, 0}, {4, 4, 4}, [](auto p) { loosen(p, 1); });
  const level::Level level = b.compile();
  Play play(level, {45, 9, 0});
  play.run(stand(), 120);
  EXPECT_NEAR(play.bodies[1].position.y, 2, 0.05);
  EXPECT_NEAR(play.bodies[0].position.y, 13, 0.05);
  play.run(stand(), 120);
  EXPECT_NEAR(play.bodies[0].position.y, 2, 0.05);
}

// The player touches a part that carries a body. The body has been asleep for a long time.
TEST(BodyPlayer, BodiesThatSleepFallWhenTheirFloorLeaves) {
  LevelBuilder b = longFloor();
  b.block({0, 4, 0}, {30, 2, 8}, [](auto p) { p.initVanish().setDelay(0.2f); });
  b.block({-10, 7, 0}, {4, 4, 4}, [](auto p) { loosen(p, 1); });
  const level::Level level = b.compile();
  Play play(level, {30, 0, 0});
  play.run(stand(), 300);
  EXPECT_NEAR(play.bodies[0].position.y, 7, 0.05);
  play.world.position = {10, 6, 0};
  play.run(stand(), 120);
  EXPECT_NEAR(play.bodies[0].position.y, 2, 0.05);
}

// The ball is touched at its position at the tick's end, not at its start.
TEST(BodyPlayer, AFastDeadlyBallKillsAtItsCurrentPosition) {
  LevelBuilder b = longFloor();
  b.block({-30, 0.25f, 0}, {0.5f, 0.5f, 0.5f}, [](auto p) {
    p.setAnchored(false);
    p.setShape(schema::Shape::BALL);
    p.initKill();
  });
  const level::Level level = b.compile();
  Play play(level);
  play.settle();
  sim::RigidBody& ball = play.bodies[0];
  ball.position = {-1.5f, 0.25f, 0};
  ball.velocity = {100, 0, 0};
  ball.spin = {};
  ball.state = sim::RigidBodyState::awake;
  play.world.flags |= sim::kBodyAwake;
  play.run(stand());
  EXPECT_EQ(play.world.outcome, sim::Outcome::killed);
}

}  // namespace
}  // namespace obby::test
