#include "solve/verify/place.h"

#include "sim/targets.h"

namespace obby::solve {

namespace {

Point feetOf(const sim::World& world) {
  return {world.position.x, world.position.y, world.position.z};
}

bool touchesPart(int64_t part, const level::LevelView& level, const sim::World& world,
                 std::span<const sim::LooseBody> loose) {
  const sim::Limbs limbs = sim::limbsOf(world, level.params);
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (int64_t(level.colliders[i].part) != part) continue;
    if (sim::touchesCollider(world, loose.data(), level, i, limbs)) return true;
  }
  return false;
}

}  // namespace

bool Place::holds(const level::LevelView& level, const sim::World& world,
                  std::span<const sim::LooseBody> loose) const {
  if (touch_ >= 0) return touchesPart(touch_, level, world, loose);
  return box_.holds(feetOf(world), level.params.bodyTop);
}

bool Place::isEntered(const level::LevelView& level, const sim::World& before,
                      const sim::World& world, std::span<const sim::LooseBody> loose) const {
  if (holds(level, world, loose)) return true;
  const bool teleported = (world.flags & sim::kArrived) != 0 && (before.flags & sim::kArrived) == 0;
  if (touch_ >= 0 || teleported) return false;
  return box_.holdsOnTheWay(feetOf(before), feetOf(world), level.params.bodyTop);
}

}  // namespace obby::solve
