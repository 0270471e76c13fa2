// Limits on what any part can do to a player. No part throws faster than the speed limit, hurts
// more than once because it has several hulls, or shifts the grid. A part that should never be
// present is never present.
#include <gtest/gtest.h>

#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using support::LevelBuilder;

TEST(Limits, APadNeverThrowsAPlayerThroughACeiling) {
  const auto level = floorLevel()
                         .block({0, 0.5f, 0}, {6, 1, 6},
                                [](Part::Builder p) {
                                  support::set(p.initJumpPad().initVelocity(), {0, 1500, 0});
                                })
                         .block({0, 23.5f, 0}, {40, 1, 40})
                         .compile();
  Play play(level, {0, 3, 0});
  play.run(stand(), 60);
  EXPECT_GT(play.highest(), 10) << "it throws";
  EXPECT_LT(play.highest() + 5, 23.1f);
}

// Makes a part of two overlapping boxes, as unions do.
void twoHulls(Part::Builder p) {
  p.setShape(schema::Shape::HULL);
  auto hulls = p.initHulls(2);
  for (uint32_t h = 0; h < 2; ++h) {
    const float x = h == 0 ? 3.0f : 2.5f;
    auto vertices = hulls[h].initVertices(8);
    for (uint32_t i = 0; i < 8; ++i)
      support::set(vertices[i], {i & 1 ? x : -x, i & 2 ? 0.5f : -0.5f, i & 4 ? 3.0f : -3.0f});
  }
}

TEST(Limits, APartOfSeveralHullsHurtsOnce) {
  const auto healthAfterATick = [](bool hulls) {
    const auto level = floorLevel()
                           .block({0, 0.5f, 0}, {6, 1, 6},
                                  [=](Part::Builder p) {
                                    if (hulls) twoHulls(p);
                                    p.setSolid(false);
                                    p.initKill().setDamage(10);
                                  })
                           .compile();
    Play play(level);
    play.run(stand());
    return play.world.health;
  };
  EXPECT_NEAR(healthAfterATick(false), 90, 0.1f);
  EXPECT_NEAR(healthAfterATick(true), 90, 0.1f);
}

TEST(Limits, AFallOfAnySpeedKeepsOtherPartsInPlace) {
  LevelBuilder b = floorLevel();
  b.block({20, 5, 20}, {4, 1, 4}, [](Part::Builder p) {
    p.initFall().setSeconds(1);
    p.getFall().setSpeed(1e12f);
  });
  const auto level = b.compile();
  Play play(level, {0, 1, 0});
  play.run(stand(), 120);
  EXPECT_NEAR(play.world.position.y, 0, 0.1f);
}

TEST(Limits, APartThatNeedsAnImpossibleTouchNeverAppears) {
  for (const bool inverted : {false, true}) {
    LevelBuilder b = floorLevel();
    b.block({0, 9.5f, 0}, {6, 1, 6}, [=](Part::Builder p) {
      p.setTouch(false);
      p.initVanish().setDelay(1);
      p.getVanish().setAway(1);
      p.getVanish().setInverted(inverted);
    });
    const auto level = b.compile();
    Play play(level, {0, 12, 0});
    play.run(stand(), 120);
    EXPECT_NEAR(play.world.position.y, inverted ? 0 : 10, 0.1f) << inverted;
  }
}

TEST(Limits, ATripOfZeroSecondsStartsNothing) {
  LevelBuilder b = floorLevel();
  b.block({20, 1, 0}, {2, 2, 2}, [](Part::Builder p) {
    p.initButton().setSignal("door");
    p.getButton().setSeconds(5);
  });
  b.block({0, 0.5f, 0}, {6, 1, 6}, [](Part::Builder p) {
    p.initTrip().setSeconds(0);
    p.getTrip().setAfter(5);
  });
  b.block({40, 1, 0}, {2, 2, 2}, [](Part::Builder p) {
    p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
    p.getVanish().setSignal("door");
  });
  const auto level = b.compile();
  Play play(level, {0, 1, 0});
  play.settle();
  EXPECT_EQ(play.world.clockCount, 0);
}

}  // namespace
}  // namespace obby::test
