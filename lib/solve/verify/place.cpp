#include "solve/verify/place.h"

#include "sim/targets.h"

namespace obby::solve {

Point feetOf(const sim::World& world) {
  return {world.position.x, world.position.y, world.position.z};
}

namespace {

bool touchesAny(level::ColliderRun colliders, const level::LevelView& level,
                const sim::World& world, std::span<const sim::LooseBody> loose) {
  const sim::Limbs limbs = sim::limbsOf(world, level.params);
  for (uint32_t i = 0; i < colliders.count; ++i) {
    if (sim::touchesCollider(world, loose.data(), level, colliders.first + i, limbs)) return true;
  }
  return false;
}

}  // namespace

bool Place::holds(const level::LevelView& level, const sim::World& world,
                  std::span<const sim::LooseBody> loose) const {
  if (touch_) return touchesAny(colliders_, level, world, loose);
  return box_.holds(feetOf(world), level.params.bodyTop);
}

bool Place::isEntered(const level::LevelView& level, const sim::World& before,
                      const sim::World& world, std::span<const sim::LooseBody> loose) const {
  if (holds(level, world, loose)) return true;
  const bool teleported = (world.flags & sim::kArrived) != 0 && (before.flags & sim::kArrived) == 0;
  if (touch_ || teleported) return false;
  return box_.holdsOnTheWay(feetOf(before), feetOf(world), level.params.bodyTop);
}

}  // namespace obby::solve
