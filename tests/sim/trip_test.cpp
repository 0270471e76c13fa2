// Trip parts and the state they cause, FallingDown.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::State;
using sim::World;
using support::LevelBuilder;

TEST(Trip, TakesControlForItsTimeOnly) {
  const auto level = floorLevel()
                         .block({0, 1, -10}, {10, 2, 1},
                                [](Part::Builder p) {
                                  p.setSolid(false);
                                  p.initTrip().setSeconds(1);
                                  p.getTrip().setAfter(2);
                                })
                         .compile();
  Play play(level);
  play.settle();
  play.until(walk(kNorth), [](const World& w) { return w.clockCount > 0; });
  play.run(walk(kNorth, true), 30);
  EXPECT_NEAR(play.world.velocity.z, 0, 0.1f);
  EXPECT_EQ(play.world.jumps, 0);
  play.run(walk(kNorth), 90);
  EXPECT_LT(play.world.position.z, -14) << "walks on, out of the part that tripped it";
}

// Adds a trip wire across the floor at z = -10. The wire is not solid.
LevelBuilder& withWire(LevelBuilder& b, float seconds = 3, float after = 1) {
  return b.block({0, 1, -10}, {100, 40, 0.2f}, [=](Part::Builder p) {
    p.setSolid(false);
    p.initTrip().setSeconds(seconds);
    p.getTrip().setAfter(after);
  });
}

bool isDown(const World& w) { return w.state == State::fallingDown; }

// Returns the studs that a player slides after walking into the wire, on a floor of this friction.
float slideOn(float friction) {
  LevelBuilder b = LevelBuilder().block({0, -1, 0}, {200, 2, 200},
                                        [=](Part::Builder p) { p.setFriction(friction); });
  const auto level = withWire(b).compile();
  Play play(level);
  play.settle().until(walk(kNorth), isDown);
  const float from = play.history[play.history.size() - 2].position.z;  // the slide's first tick
  play.run(walk(kNorth, true), 150);
  EXPECT_EQ(play.world.state, State::fallingDown) << "for three seconds";
  EXPECT_EQ(play.world.velocity.z, 0);
  return from - play.world.position.z;
}

// In Roblox, FallingDown has no control force. Contact friction alone slows the body, over a
// distance of v^2 / (2 mu g).
TEST(FallingDown, SlidesAsFarAsFrictionLets) {
  const float speed = 16, gravity = 196.2f;
  for (const float friction : {0.3f, 0.1f, 1.0f}) {
    const float mean = (friction + 0.3f) / 2;
    // In whole steps, the slide is half a step shorter.
    const float far = speed * speed / (2 * mean * gravity) - speed / 480;
    EXPECT_NEAR(slideOn(friction), far, 0.02f) << friction;
  }
}

// In Roblox, the limbs also collide in FallingDown.
TEST(FallingDown, LegsCollideSoThatAStepStopsTheBody) {
  const auto at = [](bool wire) {
    LevelBuilder b = floorLevel();
    if (wire) withWire(b);
    b.block({0, 0.5f, -22}, {100, 1, 21.8f});  // a step of one stud right after the wire
    const auto level = b.compile();
    Play play(level);
    play.settle().run(walk(kNorth), 120);
    return play.world.position;
  };
  EXPECT_GT(at(false).y, 0.9f) << "a walker steps onto it";
  EXPECT_NEAR(at(true).y, 0, 0.02f);
  EXPECT_NEAR(at(true).z, -11.1f + 0.5f, 0.02f) << "half the torso's depth before the step";
}

TEST(FallingDown, KeepsItsMomentumInTheAir) {
  LevelBuilder b = LevelBuilder().block({0, -1, 0}, {200, 2, 19.6f});  // the floor ends at the wire
  const auto level = withWire(b).compile();
  Play play(level);
  play.settle().until(walk(kNorth), [](const World& w) { return w.position.z < -5; });
  play.until(walk(kNorth, true), isDown);
  EXPECT_NEAR(play.world.velocity.z, -16, 0.01f);
  const float rise = play.world.velocity.y;
  play.run(walk(kNorth + 0x8000), 30);
  EXPECT_NEAR(play.world.velocity.z, -16, 0.01f) << "no air control";
  EXPECT_NEAR(play.world.velocity.y, rise - 196.2f * 0.5f, 0.1f) << "gravity alone";
}

TEST(FallingDown, LetsGoOfATruss) {
  LevelBuilder b = floorLevel();
  b.block({0, 20, -6}, {2, 40, 2}, [](Part::Builder p) { p.setShape(schema::Shape::TRUSS); });
  b.block({0, 15, -4}, {4, 1, 2}, [](Part::Builder p) {
    p.setSolid(false);
    p.initTrip();
  });
  const auto level = b.compile();
  Play play(level);
  play.settle().until(walk(kNorth), isDown);
  EXPECT_GT(play.world.position.y, 7);
  play.run(walk(kNorth), 100);
  EXPECT_NEAR(play.world.position.y, 0, 0.02f);
}

TEST(FallingDown, GetsUpAndWalksAndJumpsAgain) {
  LevelBuilder b = floorLevel();
  const auto level = withWire(b, 1, 2).compile();
  Play play(level);
  play.settle().until(walk(kNorth), isDown);
  play.run(stand(), 60);
  play.until(stand(), [](const World& w) { return w.state == State::running; });
  play.run(walk(kNorth, true), 10);
  EXPECT_EQ(play.world.jumps, 1);
  EXPECT_GT(play.world.position.y, 1);
  EXPECT_LT(play.world.velocity.z, -15);
}

}  // namespace
}  // namespace obby::test
