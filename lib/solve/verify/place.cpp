#include "solve/verify/place.h"

#include "sim/targets.h"

namespace obby::solve {

Point feetOf(const sim::World& world) {
  return {world.position.x, world.position.y, world.position.z};
}

namespace {

bool touchesAny(level::ColliderRun colliders, const level::LevelView& level,
                const sim::World& world, std::span<const sim::RigidBody> bodies) {
  const sim::Limbs limbs = sim::limbsOf(world, level.params);
  for (uint32_t i = 0; i < colliders.count; ++i) {
    if (sim::touchesCollider(world, bodies.data(), level, colliders.first + i, limbs)) return true;
  }
  return false;
}

}  // namespace

Place::Place(schema::Region::Reader region, level::ColliderRuns& runs, schema::Arrive arrive,
             const level::LevelView& level)
    : box_(region), touch_(region.getTouch()) {
  if (region.getPartIndex() < 0) return;
  colliders_ = runs.of(uint32_t(region.getPartIndex()));
  stand_ = !touch_ && arrive == schema::Arrive::STAND && colliders_.count > 0;
  for (uint32_t i = 0; i < colliders_.count; ++i) {
    stand_ = stand_ && (level.bounds[colliders_.first + i].flags & level::kSolid) != 0;
  }
  if (!stand_ || colliders_.count != 1) return;
  const level::Bounds& only = level.bounds[colliders_.first];
  const bool flat = (only.flags & level::kUpright) && !(only.flags & level::kHeldElsewhere);
  if (flat) lowest_ = double(only.box().hi.y) - double(level::kStandDepth);
}

bool Place::holds(const level::LevelView& level, const sim::World& world,
                  std::span<const sim::RigidBody> bodies) const {
  if (touch_) return touchesAny(colliders_, level, world, bodies);
  if (stand_) {
    const Point feet = feetOf(world);
    return sim::isHeld(world) && feet.y >= lowest_ && box_.holds(feet, 0);
  }
  return box_.holds(feetOf(world), level.params.bodyTop);
}

bool Place::isEntered(const level::LevelView& level, const sim::World& before,
                      const sim::World& world, std::span<const sim::RigidBody> bodies) const {
  if (holds(level, world, bodies)) return true;
  const bool teleported = (world.flags & sim::kArrived) != 0 && (before.flags & sim::kArrived) == 0;
  if (touch_ || teleported) return false;
  return box_.holdsAlong(feetOf(before), feetOf(world), level.params.bodyTop);
}

}  // namespace obby::solve
