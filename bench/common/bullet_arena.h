// The same scene in Bullet, Debian's physics engine: a world of rigid bodies with the level's
// static blocks and one upright capsule that walks and jumps. Bullet does less work than our
// player: one step per tick, no legs, no floor rays, no states.
#pragma once

#include <memory>

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::bench {

class BulletWorld {
 public:
  // Every collider must be a static block.
  BulletWorld(const level::LevelView& level, Vec3 feet);
  ~BulletWorld();
  BulletWorld(BulletWorld&&) noexcept;

  // Simulates 1/60 s: walks as the action says, and jumps if the capsule does not move vertically.
  void step(const sim::Action& action);

  Vec3 position() const;  // the capsule's centre

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace obby::bench
