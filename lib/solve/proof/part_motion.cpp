#include "solve/proof/part_motion.h"

#include <algorithm>
#include <optional>

#include "sim/floor.h"

namespace obby::solve {

namespace {

// Upper bounds on the motion of a mover in a tick.
struct Steps {
  float up = 0, vertical = 0, sideways = 0;  // motion of the centre, studs
  float turn = 0, spin = 0;       // motion of a point one stud from the centre or pivot, studs
  float lo = 1e30f, hi = -1e30f;  // heights of the centre at the keys
};

// Returns an upper bound on how far a point one stud from the axis moves between two rotations.
float turnOf(const Mat3& a, const Mat3& b) {
  const Vec3 x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return sqrtf32(dot(x, x) + dot(y, y) + dot(z, z));
}

Steps stepsOf(const level::Mover& m) {
  Steps s;
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Pose &from = m.keys[k], &to = m.keys[k + 1 < m.keyCount ? k + 1 : m.once ? k : 0];
    const Vec3 moved = to.position - from.position;
    s.up = std::max(s.up, moved.y);
    s.vertical = std::max(s.vertical, absf(moved.y));
    s.sideways = std::max(s.sideways, length(Vec3{moved.x, 0, moved.z}));
    s.turn = std::max(s.turn, turnOf(from.rotation, to.rotation));
    s.lo = std::min(s.lo, from.position.y);
    s.hi = std::max(s.hi, from.position.y);
  }
  for (uint32_t k = 0; k < m.spinCount; ++k) {
    s.spin = std::max(s.spin, turnOf(m.spins[k], m.spins[(k + 1) % m.spinCount]));
  }
  return s;
}

// Returns an upper bound on the distance from a part to the feet of a player that it carries.
float feetAway(const Params& p) {
  const float side = (p.bodyWidth + p.bodyDepth) * std::max(p.floorRaySpread, 0.5f) + p.climbReach;
  return side + std::max(sim::rayHeight(p), p.bodyTop);
}

void move(PartMotion& motion, const level::LevelView& level, uint32_t collider, const Steps& s) {
  const level::Collider& c = level.colliders[collider];
  const level::Mover& m = level.movers[c.mover];
  const uint32_t flags = level.bounds[collider].flags;
  const bool upright = (flags & level::kUpright) != 0;
  const float rate = level.params.controlRate, pivot = length(m.pivot);
  const float radius = length(c.shape.half) + pivot + feetAway(level.params);
  // Keys turn a part about its centre. Half a turn about the pivot moves that centre by twice its
  // distance from the pivot.
  const float turned = s.turn * radius + s.spin * (radius + pivot);
  // An upright part turns about the vertical only, so its height range is that of its keys.
  const float lifted = upright ? 0 : turned;
  if (upright) {
    motion.swept.lo.y = s.lo - c.shape.half.y;
    motion.swept.hi.y = s.hi + c.shape.half.y;
  }
  motion.vertical = (s.vertical + lifted) * rate;
  motion.step = s.vertical + lifted + s.sideways + turned;
  if (m.trigger != level::kNone) {  // it returns at once to its first key when its clock ends
    const Vec3 size = motion.swept.hi - motion.swept.lo;
    motion.step = std::max(motion.step, 2 * (size.y + length(Vec3{size.x, 0, size.z})));
  }
  if (!(flags & (level::kCarries | level::kSeat))) return;
  motion.upward = (s.up + lifted) * rate;
  motion.sideways = (s.sideways + turned) * rate;
}

}  // namespace

std::vector<PartMotion> partMotions(const level::LevelView& level) {
  std::vector<PartMotion> motions(level.colliderCount);
  std::vector<std::optional<Steps>> steps(level.moverCount);  // shared by the hulls of a mover
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& c = level.colliders[i];
    const level::Roles& r = level.roles[c.role];
    const uint32_t flags = level.bounds[i].flags;
    PartMotion& motion = motions[i];
    motion.swept = level.bounds[i].box();
    if (c.mover != level::kNone) {
      if (!steps[c.mover]) steps[c.mover] = stepsOf(level.movers[c.mover]);
      move(motion, level, i, *steps[c.mover]);
    }
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
  }
  return motions;
}

}  // namespace obby::solve
