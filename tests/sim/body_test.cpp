// Dynamic bodies fall, rest, stack, slide, roll and sleep. The player pushes them, stands on them
// and jumps from them.
#include <gtest/gtest.h>

#include <cmath>

#include "play.h"

namespace obby::test {
namespace {

using sim::RigidBodyState;
using support::LevelBuilder;

void unanchor(schema::Part::Builder p) { p.setAnchored(false); }

// Returns a floor whose top is at 0. The player is far away, at (0, 0, 40).
LevelBuilder bodyStore() {
  LevelBuilder b;
  b.block({0, -1, 0}, {200, 2, 200}).spawn({0, 0, 40});
  return b;
}

Play playOf(const level::Level& level) { return Play(level, {0, 0, 40}); }

float speedOf(const sim::RigidBody& b) { return length(b.velocity) + length(b.spin); }

TEST(DynamicBodies, FallUnderGravity) {
  for (const float sleepTime : {0.5f, 0.0f}) {
    const auto level = bodyStore()
                           .block({0, 50, 0}, {4, 4, 4}, unanchor)
                           .physics([=](auto p) { p.setSleepTime(sleepTime); })
                           .compile();
    Play play = playOf(level);
    play.run(stand(), 30);
    const double t = 0.5;
    EXPECT_NEAR(play.bodies[0].position.y, 50 - 0.5 * 196.2 * t * t, 0.25);  // semi-implicit
    EXPECT_NEAR(play.bodies[0].velocity.y, -196.2 * t, 1e-2);
  }
}

TEST(DynamicBodies, ComeToRestOnTheFloorAndSleep) {
  const auto level = bodyStore().block({0, 4, 0}, {4, 4, 4}, unanchor).compile();
  Play play = playOf(level);
  play.run(stand(), 180);
  EXPECT_NEAR(play.bodies[0].position.y, 2, 0.02);
  EXPECT_EQ(play.bodies[0].state, RigidBodyState::asleep);
  EXPECT_EQ(speedOf(play.bodies[0]), 0);
  EXPECT_EQ(play.world.flags & sim::kBodyAwake, 0);
}

TEST(DynamicBodies, EveryShapeRestsOnItsLowestFace) {
  struct Case {
    schema::Shape shape;
    float height;  // height of the part's centre at rest, studs
  };
  const Case cases[] = {{schema::Shape::BLOCK, 1},    {schema::Shape::BALL, 1},
                        {schema::Shape::WEDGE, 1},    {schema::Shape::CORNER_WEDGE, 1},
                        {schema::Shape::CYLINDER, 1}, {schema::Shape::TRUSS, 1}};
  for (const Case& c : cases) {
    const auto level = bodyStore()
                           .block({0, 3, 0}, {2, 2, 2},
                                  [&](auto p) {
                                    p.setAnchored(false);
                                    p.setShape(c.shape);
                                  })
                           .compile();
    Play play = playOf(level);
    play.run(stand(), 240);
    const Pose pose = poseOf(play.bodies[0], level.view().bodies[0]);
    EXPECT_NEAR(pose.position.y, c.height, 0.02) << int(c.shape);
    EXPECT_NEAR(play.bodies[0].velocity.y, 0, 0.05) << int(c.shape);
  }
}

// Unions can have this shape: a single hull far from the part's centre. The hull's top is at 0.
TEST(DynamicBodies, RestOnAHullFarFromItsPartsCentre) {
  const auto slab = [](schema::Part::Builder p) {
    p.setShape(schema::Shape::HULL);
    auto vertices = p.initHulls(1)[0].initVertices(8);
    for (uint32_t i = 0; i < 8; ++i) {
      support::set(vertices[i],
                   {i & 1 ? 200.0f : -200.0f, i & 2 ? -190.0f : -200.0f, i & 4 ? 200.0f : -200.0f});
    }
  };
  for (const auto shape : {schema::Shape::BLOCK, schema::Shape::BALL}) {
    const auto level = LevelBuilder{}
                           .block({0, 190, 0}, {400, 400, 400}, slab)
                           .block({0, 5, 0}, {2, 2, 2},
                                  [=](auto p) {
                                    p.setAnchored(false);
                                    p.setShape(shape);
                                  })
                           .compile();
    Play play = playOf(level);
    play.run(stand(), 240);
    EXPECT_NEAR(play.bodies[0].position.y, 1, 0.02) << int(shape);
    EXPECT_NEAR(play.bodies[0].velocity.y, 0, 0.05) << int(shape);
  }
}

TEST(DynamicBodies, TipOverFromACorner) {
  const auto level = bodyStore()
                         .block({0, 5, 0}, {4, 4, 4},
                                [](auto p) {
                                  p.setAnchored(false);
                                  support::setRotation(p.initRotation(), 0.3f, 0.7f);
                                })
                         .compile();
  Play play = playOf(level);
  play.run(stand(), 300);
  EXPECT_NEAR(play.bodies[0].position.y, 2, 0.02);
  EXPECT_EQ(play.bodies[0].state, RigidBodyState::asleep);
}

TEST(DynamicBodies, StackAndStayStacked) {
  LevelBuilder b = bodyStore();
  for (int i = 0; i < 8; ++i) b.block({0, 2 + 4.02f * float(i), 0}, {4, 4, 4}, unanchor);
  const auto level = b.compile();
  Play play = playOf(level);
  play.run(stand(), 600);
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(play.bodies[size_t(i)].position.y, 2 + 4 * float(i), 0.025 * (i + 1)) << i;
    EXPECT_NEAR(play.bodies[size_t(i)].position.x, 0, 0.1) << i;
    EXPECT_EQ(play.bodies[size_t(i)].state, RigidBodyState::asleep) << i;
  }
}

TEST(DynamicBodies, SlideDownASlopeThatIsSteeperThanTheirFriction) {
  const auto slide = [](float friction, float pitch) {
    const auto rough = [=](auto p) {
      p.setFriction(friction);
      support::setRotation(p.initRotation(), 0, pitch);
    };
    const auto level = bodyStore()
                           .block({0, 20, 0}, {20, 2, 60}, rough)
                           .block({0, 22.18f, 0}, {4, 2, 4},
                                  [=](auto p) {
                                    rough(p);
                                    p.setAnchored(false);
                                  })
                           .compile();
    Play play = playOf(level);
    play.run(stand(), 90);
    return length(play.bodies[0].position - Vec3{0, 22.18f, 0});
  };
  EXPECT_GT(slide(0.2f, 0.4f), 5);  // tan 0.4 = 0.42
  EXPECT_LT(slide(0.6f, 0.4f), 0.05f);
}

TEST(DynamicBodies, BounceByTheirElasticity) {
  const auto bounce = [](float elasticity) {
    const auto springy = [=](auto p) { p.setElasticity(elasticity); };
    const auto level = LevelBuilder{}
                           .block({0, -1, 0}, {200, 2, 200}, springy)
                           .spawn({0, 0, 40})
                           .block({0, 21, 0}, {2, 2, 2},
                                  [=](auto p) {
                                    springy(p);
                                    p.setAnchored(false);
                                  })
                           .compile();
    Play play = playOf(level);
    float lowest = 100, highest = 0;
    for (int t = 0; t < 120; ++t) {
      play.run(stand());
      const float y = play.bodies[0].position.y - 1;
      if (y < 0.5f) lowest = y;
      if (lowest < 1) highest = maxf(highest, y);
    }
    return highest / 20;
  };
  EXPECT_LT(bounce(0), 0.03f);
  EXPECT_NEAR(bounce(0.5f), 0.25f, 0.06f);
}

// A hard flat landing does not tilt a body, and throws it sideways by at most 4 % of its speed.
TEST(DynamicBodies, BounceStraightUp) {
  const auto springy = [](auto p) { p.setElasticity(1); };
  const auto level = LevelBuilder{}
                         .block({0, -1, 0}, {200, 2, 200}, springy)
                         .spawn({0, 0, 40})
                         .block({3, 40, 5}, {7, 6, 3},
                                [=](auto p) {
                                  springy(p);
                                  p.setAnchored(false);
                                })
                         .compile();
  Play play = playOf(level);
  float highest = 0;
  for (int t = 0; t < 120; ++t) {
    play.run(stand());
    const auto& b = play.bodies[0];
    EXPECT_LT(length(b.spin), 0.2f) << t;
    EXPECT_LT(length(Vec3{b.velocity.x, 0, b.velocity.z}), 4.8f) << t;
    if (t > 60) highest = maxf(highest, b.position.y);
  }
  EXPECT_GT(highest, 36);
}

TEST(DynamicBodies, FallOutOfTheWorld) {
  const auto level = bodyStore().block({150, 10, 0}, {4, 4, 4}, unanchor).compile();
  Play play = playOf(level);
  play.run(stand(), 200);
  EXPECT_EQ(play.bodies[0].state, RigidBodyState::gone);
  EXPECT_EQ(play.world.flags & sim::kBodyAwake, 0);
}

TEST(DynamicBodies, RestOnPlatformsThatCarry) {
  const auto level = bodyStore()
                         .block({0, 0, 0}, {12, 2, 12},
                                [](auto p) {
                                  auto motion = p.initMotion();
                                  motion.setCarries(true);
                                  motion.setRepeat(schema::Repeat::PING_PONG);
                                  auto keys = motion.initKeys(2);
                                  support::set(keys[0].initPosition(), {0, 5, 0});
                                  keys[1].setTime(4);
                                  support::set(keys[1].initPosition(), {20, 5, 0});
                                })
                         .block({0, 8, 0}, {4, 4, 4}, unanchor)
                         .compile();
  Play play = playOf(level);
  play.run(stand(), 220);
  EXPECT_NEAR(play.bodies[0].position.y, 8, 0.1);
  EXPECT_NEAR(play.bodies[0].position.x, 20.0f * 220 / 240, 1.5);
  EXPECT_EQ(play.bodies[0].state, RigidBodyState::awake);
}

TEST(DynamicBodies, ArePushedByThePlayer) {
  const auto level = bodyStore().block({0, 2, 20}, {4, 4, 4}, unanchor).compile();
  Play play = playOf(level);
  play.settle().run(walk(kNorth), 240);
  EXPECT_LT(play.bodies[0].position.z, 10);
  EXPECT_NEAR(play.bodies[0].position.y, 2, 0.1);
  // The player stays behind the box.
  EXPECT_GT(play.world.position.z, play.bodies[0].position.z + 2.4f);
}

TEST(DynamicBodies, StayPutIfTooHeavyToPush) {
  const auto level = bodyStore()
                         .block({0, 2, 20}, {12, 4, 12},
                                [](auto p) {
                                  p.setAnchored(false);
                                  p.setDensity(8);
                                  p.setFriction(1);
                                })
                         .compile();
  Play play = playOf(level);
  play.settle().run(walk(kNorth), 240);
  EXPECT_NEAR(play.bodies[0].position.z, 20, 0.1);
}

TEST(DynamicBodies, CarryAPlayerWhoStandsOnThemAndJumps) {
  const auto level = bodyStore().block({0, 2, 0}, {6, 4, 6}, unanchor).compile();
  Play play(level, {0, 6, 0});
  play.settle();
  EXPECT_NEAR(play.world.position.y, 4, 0.05);
  play.run(stand(), 60);
  EXPECT_EQ(play.world.state, sim::State::running);
  const float from = play.world.position.y;
  play.history.clear();
  play.run(stand(true)).run(stand(), 60);
  EXPECT_NEAR(play.highest() - from, 53.0 * 53 / (2 * 196.2), 0.1);
  EXPECT_NEAR(play.bodies[0].position.y, 2, 0.05);
}

TEST(DynamicBodies, CarryAPlayerAlongWhenTheyFall) {
  const auto level = bodyStore().block({0, 100, 0}, {8, 2, 8}, unanchor).compile();
  Play play(level, {0, 101, 0});
  play.run(stand(), 30);
  const float above = play.world.position.y - (play.bodies[0].position.y + 1);
  EXPECT_NEAR(above, 0, 0.6f);
  EXPECT_LT(play.bodies[0].position.y, 80);
}

TEST(DynamicBodies, PushedToAWallBecomeAStep) {
  const auto climb = [](bool box) {
    LevelBuilder b = bodyStore();
    b.block({0, 5, -20}, {40, 10, 10});  // a wall 10 high: a jump reaches 7
    if (box) b.block({0, 2, 20}, {4, 4, 4}, unanchor);
    const auto level = b.compile();
    Play play = playOf(level);
    play.settle().run(walk(kNorth), 300);  // walks to the wall and pushes the box there
    play.run(walk(kNorth ^ 0x8000), 20);   // walks back
    // Jumps onto the box, and from it onto the wall.
    return play.until(walk(kNorth, true), [](const sim::World& w) {
      return w.position.y > 9.9f && (w.flags & sim::kFloorSensed);
    }) >= 0;
  };
  EXPECT_TRUE(climb(true));
  EXPECT_FALSE(climb(false));
}

TEST(DynamicBodies, ContinueIdenticallyWhenRestored) {
  LevelBuilder b = bodyStore();
  for (int i = 0; i < 5; ++i) b.block({float(i), 4 + 5 * float(i), 20}, {4, 4, 4}, unanchor);
  const auto level = b.compile();
  Play play = playOf(level);
  play.run(walk(kNorth), 60);
  const sim::World world = play.world;
  const std::vector<sim::RigidBody> bodies = play.bodies;
  play.run(walk(kNorth), 60);
  Play again = playOf(level);
  again.world = world;
  again.bodies = bodies;
  again.run(walk(kNorth), 60);
  EXPECT_EQ(stateHash(again.world, again.bodies), stateHash(play.world, play.bodies));
}

TEST(DynamicBodies, TheSeventeenthBodyIsAnError) {
  LevelBuilder b = bodyStore();
  for (int i = 0; i < 17; ++i) b.block({5 * float(i), 2, 0}, {4, 4, 4}, unanchor);
  const auto level = level::Level::compile(b.record());
  ASSERT_FALSE(level);
  EXPECT_EQ(level.error().path, "parts[17].anchored");
}

// The bodies have come to rest, as on a server that has run for a while.
TEST(StartBodies, IsAtRestIfAllBodiesComeToRest) {
  const auto level = bodyStore()
                         .block({0, 9, 0}, {4, 4, 4}, unanchor)
                         .block({2, 20, 0}, {4, 4, 4}, unanchor)
                         .compile();
  const auto bodies = sim::startBodies(level.view());
  for (const sim::RigidBody& b : bodies) {
    EXPECT_EQ(b.state, RigidBodyState::asleep);
    EXPECT_EQ(speedOf(b), 0);
  }
  EXPECT_NEAR(bodies[0].position.y, 2, 0.02f);
}

TEST(StartBodies, EqualsTheLevelIfABodyStaysAwake) {
  const auto spins = [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(1); };
  const auto level = bodyStore()
                         .block({0, 9, 0}, {4, 4, 4}, unanchor)
                         .block({0, 1, 0}, {8, 2, 8}, spins)
                         .compile();
  const auto bodies = sim::startBodies(level.view());
  EXPECT_EQ(bodies[0].state, RigidBodyState::awake);
  EXPECT_EQ(bodies[0].position.y, 9);
}

}  // namespace
}  // namespace obby::test
