// The same scene in Bullet, the engine that Debian carries: one world of rigid bodies with the
// level's static blocks and one upright capsule that walks and jumps. What it does less than our
// player: one step a tick, no legs, no floor rays, no states.
#pragma once

#include <memory>

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::bench {

class BulletWorld {
 public:
  // Every collider must be a block that stands still.
  BulletWorld(const level::LevelView& level, Vec3 feet);
  ~BulletWorld();
  BulletWorld(BulletWorld&&) noexcept;

  // One step of 1/60 s: walks as the action says, jumps where the capsule does not move vertically.
  void step(const sim::Action& action);

  Vec3 position() const;  // of the capsule's centre

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace obby::bench
