#include "solve/proof/part_motion.h"

#include <algorithm>

#include "sim/floor.h"

namespace obby::solve {

namespace {

// Straight distance that a point at `radius` from the axis moves between two rotations, at most.
float turnStep(const Mat3& a, const Mat3& b, float radius) {
  const Vec3 x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return radius * sqrtf32(dot(x, x) + dot(y, y) + dot(z, z));
}

// How far the feet of a player who is carried can be from the part.
float feetAway(const Params& p) {
  const float side = (p.bodyWidth + p.bodyDepth) * std::max(p.floorRaySpread, 0.5f) + p.climbReach;
  return side + std::max(sim::rayHeight(p), p.bodyTop);
}

struct Steps {
  float up = 0, vertical = 0, sideways = 0;

  void note(Vec3 moved, float turned) {
    up = std::max(up, moved.y + turned);
    vertical = std::max(vertical, absf(moved.y) + turned);
    sideways = std::max(sideways, length(Vec3{moved.x, 0, moved.z}) + turned);
  }
  float any() const { return vertical + sideways; }
};

// Returns how far points at `radius` move in a tick. A triggered part goes back to its first key
// when its clock ends: that step counts for `put` alone, since no floor has a velocity then.
Steps stepsOf(const level::Mover& m, float radius, float& put) {
  Steps keys, spin, back;
  const Pose& first = m.keys[0];
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Pose& from = m.keys[k];
    if (m.trigger != level::kNone) {
      back.note(first.position - from.position, turnStep(from.rotation, first.rotation, radius));
    }
    const bool last = k + 1 == m.keyCount;
    if (last && m.once) break;
    const Pose& to = last ? first : m.keys[k + 1];
    keys.note(to.position - from.position, turnStep(from.rotation, to.rotation, radius));
  }
  // Half a turn about the pivot leads as far again from the centre, about which the keys turn.
  const float arm = m.spinCount != 0 ? radius + length(m.pivot) : 0;
  for (uint32_t k = 0; k < m.spinCount; ++k) {
    spin.note({}, turnStep(m.spins[k], m.spins[(k + 1) % m.spinCount], arm));
    if (m.trigger != level::kNone) back.note({}, 2 * arm);
  }
  put = std::max(keys.any() + spin.any(), 2 * back.any());
  return {keys.up + spin.up, keys.vertical + spin.vertical, keys.sideways + spin.sideways};
}

void move(PartMotion& motion, const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  const level::Mover& m = level.movers[c.mover];
  const Params& p = level.params;
  const float radius = length(c.shape.half) + length(m.pivot) + feetAway(p);
  Steps steps = stepsOf(m, radius, motion.step);
  if (level.bounds[collider].flags & level::kUpright) {
    // What stays upright is no lower and no higher than at its keys, however it turns.
    Box heights{m.keys[0].position, m.keys[0].position};
    Steps still;
    for (uint32_t k = 0; k < m.keyCount; ++k) {
      const uint32_t next = k + 1 < m.keyCount ? k + 1 : (m.once ? k : 0);
      heights = join(heights, {m.keys[k].position, m.keys[k].position});
      still.note(m.keys[next].position - m.keys[k].position, 0);
    }
    steps = {still.up, still.vertical, steps.sideways};
    motion.swept.lo.y = heights.lo.y - c.shape.half.y;
    motion.swept.hi.y = heights.hi.y + c.shape.half.y;
  }
  motion.vertical = steps.vertical * p.controlRate;
  if (!(level.bounds[collider].flags & (level::kCarries | level::kSeat))) return;
  motion.upward = steps.up * p.controlRate;
  motion.sideways = steps.sideways * p.controlRate;
}

}  // namespace

PartMotion partMotion(const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  const level::Roles& r = level.roles[c.role];
  const uint32_t flags = level.bounds[collider].flags;
  PartMotion motion;
  motion.swept = level.bounds[collider].box();
  if (c.mover != level::kNone) move(motion, level, collider);
  if (flags & level::kConveyor) {
    const float across = length(motion.swept.hi - motion.swept.lo) + 2 * feetAway(level.params);
    const float turning = length(r.conveyorAngular) * across;
    motion.sideways += length(Vec3{r.conveyorVelocity.x, 0, r.conveyorVelocity.z}) + turning;
    motion.upward += absf(r.conveyorVelocity.y) + turning;
  }
  if (flags & level::kPad) {
    const float pad = length(Vec3{r.padVelocity.x, 0, r.padVelocity.z});
    motion.sideways = std::max(motion.sideways, pad);
  }
  return motion;
}

std::vector<PartMotion> partMotions(const level::LevelView& level) {
  std::vector<PartMotion> motions;
  for (uint32_t i = 0; i < level.colliderCount; ++i) motions.push_back(partMotion(level, i));
  return motions;
}

}  // namespace obby::solve
