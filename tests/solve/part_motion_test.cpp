// What moving parts do to those around them, worked out once for all queries of a level.
#include "solve/proof/part_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "solve/proof/supports.h"

namespace obby::solve {
namespace {

TEST(PartMotions, AreWorkedOutOnceAndAlike) {
  const level::Level level = support::movingArena(20, 6, 1).compile();
  PartMotions kept;
  const std::vector<PartMotion>& motions = kept.of(level.view());
  EXPECT_EQ(motions.size(), 6u);
  EXPECT_EQ(&kept.of(level.view()), &motions);
  Problem problem = support::plainProblem(level, {});
  const std::vector<Support> anew = supportsOf(problem);
  problem.motions = &kept;
  const std::vector<Support> again = supportsOf(problem);
  ASSERT_EQ(again.size(), anew.size());
  for (size_t i = 0; i < anew.size(); ++i) {
    EXPECT_EQ(again[i].upward, anew[i].upward);
    EXPECT_EQ(again[i].sideways, anew[i].sideways);
    EXPECT_EQ(again[i].entry, anew[i].entry);
  }
}

// A block that moves by `way` in so many seconds.
PartMotion motionBy(Vec3 way, float seconds) {
  LevelBuilder b;
  b.block({0, 0, 0}, {4, 1, 4}, [=](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 0, 0});
    support::set(keys[1].initPosition(), way);
    keys[1].setTime(seconds);
  });
  const level::Level level = b.compile();
  return partMotion(level.view(), 0);
}

TEST(PartMotions, RoughIsWhatRisesHoweverSlowly) {
  EXPECT_TRUE(motionBy({0, 4, 0}, 1).rough);
  EXPECT_TRUE(motionBy({0, 4, 0}, 120).rough) << "by half a thousandth of a stud a tick";
  EXPECT_FALSE(motionBy({0, 0.05f, 0}, 120).rough) << "rises by next to nothing";
  EXPECT_FALSE(motionBy({4, 0, 0}, 1).rough);
}

// A block that nobody rides creeps aside after a touch, and two seconds later is back in a tick.
TEST(PartMotions, WhatReturnsAtOncePushesByAllOfItsWay) {
  LevelBuilder b;
  b.block({0, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::ONCE);
    motion.setTrigger(schema::MotionTrigger::TOUCH);
    motion.setSeconds(2);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {0, 0, 0});
    support::set(keys[1].initPosition(), {0.6f, 0, 0});
    keys[1].setTime(2);
  });
  const level::Level level = b.compile();
  const PartMotion motion = partMotion(level.view(), 0);
  EXPECT_FALSE(motion.rough) << "less than half a body";
  EXPECT_GT(motion.sideways, 35);
}

// Keys turn a block about its centre, and a slow spin about a point ten studs from that: after half
// a turn of the spin the block is twenty studs from what the keys turn it about.
TEST(PartMotions, NoCornerIsFasterWhereKeysAndSpinTurn) {
  LevelBuilder b;
  b.block({0, 0, 0}, {2, 2, 2}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    auto keys = motion.initKeys(4);
    for (uint32_t k = 0; k < 4; ++k) {
      support::set(keys[k].initPosition(), {0, 0, 0});
      support::setRotation(keys[k].initRotation(), 0, 2 * kPi / 3 * float(k));
      keys[k].setTime(0.4f * float(k));
    }
    auto spin = motion.initSpin();
    support::set(spin.initAxis(), {1, 0, 0});
    support::set(spin.initPivot(), {0, 0, 10});
    spin.setSpeed(0.5f);
  });
  const level::Level level = b.compile();
  const PartMotion motion = partMotion(level.view(), 0);
  const float rate = float(level.view().params.controlRate);
  float upward = 0, sideways = 0;
  for (uint32_t t = 0; t < 1000; ++t) {
    const Pose before = level::moverPose(level.view().movers[0], t);
    const Pose after = level::moverPose(level.view().movers[0], t + 1);
    for (uint32_t corner = 0; corner < 8; ++corner) {
      const Vec3 at{(corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                    (corner & 4) != 0 ? 1.0f : -1.0f};
      const Vec3 way = toWorld(after, at) - toWorld(before, at);
      upward = std::max(upward, absf(way.y) * rate);
      sideways = std::max(sideways, length(Vec3{way.x, 0, way.z}) * rate);
    }
  }
  EXPECT_LE(upward, motion.upward);
  EXPECT_LE(sideways, motion.sideways);
  EXPECT_GT(upward, 100) << "it never was far out";
}

}  // namespace
}  // namespace obby::solve
