// The effect of moving parts on players around them.
#include "solve/proof/part_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"

namespace obby::solve {
namespace {

// Keys rotate a block about its centre, and a slow spin rotates it about a point ten studs away.
// After half a turn of the spin, the block is twenty studs away.
TEST(PartMotion, BoundsCornersUnderKeysAndSpin) {
  LevelBuilder b;
  b.block({0, 0, 0}, {2, 2, 2}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
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
  const PartMotion motion = partMotions(level.view())[0];
  const float rate = float(level.view().params.controlRate);
  float upward = 0, sideways = 0;
  for (uint32_t t = 0; t < 1000; ++t) {
    const Pose before = level::moverPose(level.view().movers[0], t);
    const Pose after = level::moverPose(level.view().movers[0], t + 1);
    for (uint32_t corner = 0; corner < 8; ++corner) {
      const Vec3 at{(corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                    (corner & 4) != 0 ? 1.0f : -1.0f};
      const Vec3 trajectory = toWorld(after, at) - toWorld(before, at);
      upward = std::max(upward, absf(trajectory.y) * rate);
      sideways = std::max(sideways, length(Vec3{trajectory.x, 0, trajectory.z}) * rate);
    }
  }
  EXPECT_LE(upward, motion.upward);
  EXPECT_LE(sideways, motion.sideways);
  EXPECT_GT(upward, 100) << "it never was far out";
}

}  // namespace
}  // namespace obby::solve
