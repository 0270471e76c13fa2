#include "solve/proof/part_motion.h"

#include <algorithm>

#include "solve/proof/body_reach.h"

namespace obby::solve {

namespace {

constexpr float kMostVertical = 1e-3f;

// Studs a tick: movers that jump further push through things, and are farther in a body than what
// they lift it from.
float snapOf(const Params& p) {
  const float half = 0.5f * std::min(p.bodyWidth, p.bodyDepth);
  return std::min(1.0f, half + kSlack + std::max(sim::rayHeight(p) - p.hipHeight, 0.0f));
}

void noteStep(PartMotion& m, Vec3 step, float turned, float rate) {
  const float side = length(Vec3{step.x, 0, step.z}) + turned;
  m.upward = std::max(m.upward, (absf(step.y) + turned) * rate);
  m.sideways = std::max(m.sideways, side * rate);
  m.rough |= absf(step.y) > kMostVertical;
}

// Bound on how far a tick of spin moves a point at `radius`.
float spinStep(const Mat3& a, const Mat3& b, float radius) {
  const Vec3 x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  return radius * sqrtf32(dot(x, x) + dot(y, y) + dot(z, z));
}

// `half`: half of its height while it is upright. What stays upright is no lower and no higher than
// at its keys, however it turns; the level's bounds of what turns are a cube.
void noteHeights(PartMotion& motion, const level::Mover& m, float half, bool upright,
                 const Params& p) {
  float lowest = 1e30f, highest = -1e30f;
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    lowest = std::min(lowest, m.keys[k].position.y);
    highest = std::max(highest, m.keys[k].position.y);
  }
  motion.lowestTop = lowest + half;
  // What takes minutes for it presses a body as deep into others as what takes a second.
  motion.rough |= highest - lowest > flushDepth(p);
  if (!upright) return;
  motion.swept.lo.y = lowest - half;
  motion.swept.hi.y = highest + half;
}

// Studs to the farthest point that counts, from what the keys and what the spin turn it about.
struct Radii {
  float keys, spin;
};

// Once its clock has run out a mover is back at its beginning, wherever it was, in one tick.
void noteReturn(PartMotion& motion, const level::Mover& m, const Radii& radii, const Params& p,
                bool carries) {
  if (m.trigger == level::kNone) return;
  const float rate = p.controlRate;
  PartMotion back;
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Vec3 step = m.keys[0].position - m.keys[k].position;
    noteStep(back, step, spinStep(m.keys[k].rotation, m.keys[0].rotation, radii.keys), rate);
  }
  float turned = 0;
  for (uint32_t k = 0; k < m.spinCount; ++k) {
    turned = std::max(turned, spinStep(m.spins[k], m.spins[0], radii.spin));
  }
  back.upward += turned * rate;
  back.sideways += turned * rate;
  const bool snaps = back.sideways > snapOf(p) * rate;
  motion.rough |= back.rough || snaps;
  if (!carries) {
    // Who is in its way is pushed by all of that at once.
    if (!snaps) motion.sideways = std::max(motion.sideways, back.sideways);
    return;
  }
  motion.upward = std::max(motion.upward, back.upward);
  motion.sideways = std::max(motion.sideways, back.sideways);
}

}  // namespace

PartMotion partMotion(const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  const level::Mover& m = level.movers[c.mover];
  const bool upright = (level.bounds[collider].flags & level::kUpright) != 0;
  // Who sits on what turns over may be farther from its centre than its corners are.
  const bool swings = !upright && (level.bounds[collider].flags & level::kSeat) != 0;
  const float half = std::max(length(c.shape.half), swings ? level.params.seatHeight : 0.0f);
  const float arm = length(m.pivot), rate = level.params.controlRate;
  const float spun = half + arm + feetAway(level.params, level.bounds[collider].flags);
  // Half a turn about the pivot leads as far again from the centre, about which the keys turn.
  const Radii radii{m.spinCount != 0 ? spun + arm : spun, spun};
  PartMotion motion;
  motion.collider = collider;
  motion.swept = level.bounds[collider].box();
  motion.rough = !upright;
  noteHeights(motion, m, c.shape.half.y, upright, level.params);
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    if (k + 1 == m.keyCount && m.once) break;
    const Pose &from = m.keys[k], &to = m.keys[(k + 1) % m.keyCount];
    noteStep(motion, to.position - from.position, spinStep(from.rotation, to.rotation, radii.keys),
             rate);
  }
  float spin = 0;
  for (uint32_t k = 0; k < m.spinCount; ++k) {
    spin = std::max(spin, spinStep(m.spins[k], m.spins[(k + 1) % m.spinCount], radii.spin));
  }
  motion.sideways += spin * rate;
  if (!upright) motion.upward += spin * rate;
  motion.rough |= motion.sideways > snapOf(level.params) * rate;
  const bool carries = (level.bounds[collider].flags & (level::kCarries | level::kSeat)) != 0;
  noteReturn(motion, m, radii, level.params, carries);
  return motion;
}

std::vector<PartMotion> partMotions(const level::LevelView& level) {
  std::vector<PartMotion> motions;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (level.colliders[i].mover != level::kNone) motions.push_back(partMotion(level, i));
  }
  return motions;
}

}  // namespace obby::solve
