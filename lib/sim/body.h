// The physics of one tick: substeps of gravity, drive and hover spring, and depenetration of the
// torso and head.
#pragma once

#include "geom/penetration.h"
#include "math/bits.h"
#include "sim/humanoid.h"

namespace obby::sim {

// The player's motion during a tick, and its targets.
template <class F>
struct MotionT {
  Vec3T<F> position, velocity;  // position and velocity of the feet
  SinCosT<F> yaw;
  F bottom;  // bottom of the colliding body above the feet; the torso does not collide while
             // jumping
  DriveT<F> drive;
  F floorY, floorSpeed;  // height and vertical velocity of the floor
};

using Motion = MotionT<float>;

// Smaller differences count as zero. A player who stands, walks or falls freely then has a constant
// acceleration, and a tick is one step instead of several.
constexpr float kSettledGap = 1e-3f;    // studs
constexpr float kSettledSpeed = 1e-2f;  // studs/s

template <class F>
OBBY_DEVICE MotionT<F> motionOf(const PlayerT<F>& w, const Params& p, const FloorT<F>& floor,
                                const DriveT<F>& d) {
  const F bottom = select(w.is(State::jumping), F(p.headBottom), F(p.hipHeight));
  MotionT<F> m{w.position, w.velocity, sinCosOf<F>(w.yaw), bottom, d, 0, floor.velocity.y};
  const F dx = d.velocity.x - w.velocity.x, dz = d.velocity.z - w.velocity.z;
  const MaskOf<F> arrived = (d.limit > 0.0f) & (dx * dx + dz * dz < kSettledSpeed * kSettledSpeed);
  m.velocity.x = select(arrived, d.velocity.x, m.velocity.x);
  m.velocity.z = select(arrived, d.velocity.z, m.velocity.z);
  const MaskOf<F> rests = d.hover & (absf(floor.gap) < kSettledGap) & (floor.velocity.y == 0.0f) &
                          (absf(w.velocity.y) < kSettledSpeed);
  m.position.y = select(rests, m.position.y - floor.gap, m.position.y);
  m.velocity.y = select(rests, F(0.0f), m.velocity.y);
  m.floorY = select(rests, m.position.y, m.position.y - floor.gap);
  return m;
}

// Returns torso and head as one upright box.
template <class F>
OBBY_DEVICE geom::UprightBoxT<F> bodyBox(const MotionT<F>& m, const Params& p) {
  const F half = (p.bodyTop - m.bottom) * 0.5f;
  return {m.position + Vec3T<F>{0, m.bottom + half, 0},
          {p.bodyWidth * 0.5f, half, p.bodyDepth * 0.5f},
          m.yaw};
}

// Returns true if legs that hold a body at a moving floor make it rise faster than the floor.
template <class F>
OBBY_DEVICE MaskOf<F> legsLift(MaskOf<F> hover, F upward, F floorSpeed) {
  return hover & (upward > floorSpeed + kSettledSpeed);
}

// Damping of a hanging landing, 1/s. A step of 1/240 s reduces the speed to 0.375 of itself
// (measured).
constexpr float kHangGain = 150;

// Returns the acceleration of a substep.
template <class F>
OBBY_DEVICE Vec3T<F> acceleration(const MotionT<F>& m, const Params& p) {
  const DriveT<F>& d = m.drive;
  Vec3T<F> a{(d.velocity.x - m.velocity.x) * p.moveGain, 0,
             (d.velocity.z - m.velocity.z) * p.moveGain};
  const F size2 = a.x * a.x + a.z * a.z;
  const MaskOf<F> over = size2 > d.limit * d.limit;
  if (any(over)) a = select(over, a * (d.limit / sqrtf32(select(over, size2, F(1.0f)))), a);
  a += d.slide;
  // The legs push while they are compressed, and let the body fall otherwise.
  const F gap = m.position.y - m.floorY;
  const F lift = -p.hoverStiffness * gap - p.hoverDamping * (m.velocity.y - m.floorSpeed);
  a.y = select(d.hover & (gap <= 0.0f), minf(lift, F(p.hoverLimit)), F(-d.gravity));
  if (p.tricks & kHangingLanding) {
    const float gain = minf(kHangGain, 1.0f / p.substepSeconds);  // no step overshoots
    a.y = select(d.hangs & (gap > 0.0f), (m.floorSpeed - m.velocity.y) * gain, a.y);
  }
  return a;
}

// Returns true if the acceleration is constant during the whole tick.
template <class F>
OBBY_DEVICE MaskOf<F> isConstant(const MotionT<F>& m, const Params& p) {
  const DriveT<F>& d = m.drive;
  // While the legs hold the body, the acceleration is constant only at rest on a floor without
  // vertical motion.
  const MaskOf<F> bounces =
      d.hover & ((m.position.y != m.floorY) | (m.velocity.y != 0.0f) | (m.floorSpeed != 0.0f));
  const F dx = d.velocity.x - m.velocity.x, dz = d.velocity.z - m.velocity.z;
  const F left = dx * dx + dz * dz;
  // The acceleration stays at the limit while the speed difference exceeds limit / moveGain.
  const F needed = d.limit * (1.0f / p.moveGain + p.tickSeconds);
  return ((left == 0.0f) | (left > needed * needed)) & !bounces;
}

// Limits a velocity to the speeds that the grid's lists cover.
template <class F>
OBBY_DEVICE Vec3T<F> bounded(const Vec3T<F>& v, const level::LevelView& level) {
  const F limit = level.params.maxFallSpeed, side = level.maxSideSpeed;
  return {clampf<F>(v.x, -side, side), clampf<F>(v.y, -limit, limit), clampf<F>(v.z, -side, side)};
}

// Does the first half of a semi-implicit step: v += a dt. The step then moves by that velocity.
template <class F>
OBBY_DEVICE void accelerate(MotionT<F>& m, const level::LevelView& level, float dt) {
  Vec3T<F> a = acceleration(m, level.params);
  a.y = select(m.drive.freeSteps > 0.0f, F(0.0f), a.y);
  m.velocity = bounded(m.velocity + a * F(dt), level);
  m.drive.freeSteps -= F(1.0f);
}

// Takes all steps of a tick at once, for an acceleration that is constant during the tick.
template <class F>
OBBY_DEVICE void integrate(MotionT<F>& m, const level::LevelView& level, float dt, int steps) {
  const Vec3T<F> a = acceleration(m, level.params);
  const float n = float(steps);
  const F falls = n - m.drive.freeSteps;
  const float sum = 0.5f * dt * dt * n * (n + 1);
  m.position += m.velocity * F(dt * n) +
                Vec3T<F>{a.x * sum, a.y * (0.5f * dt * dt) * falls * (falls + 1.0f), a.z * sum};
  m.velocity += Vec3T<F>{a.x * (dt * n), a.y * dt * falls, a.z * (dt * n)};
  m.velocity = bounded(m.velocity, level);
}

// Returns the box in which the body can be during this tick.
template <class F>
OBBY_DEVICE BoxT<F> bodyReach(const MotionT<F>& m, const Params& p) {
  const float dt = p.tickSeconds;
  // Horizontally the body exceeds neither its present speed nor its wanted speed. Vertically
  // gravity adds speed. The legs lift it only if the floor is above the feet, and no higher than
  // the floor.
  const float more = m.drive.gravity * dt * dt + p.contactSkin;
  const F lift = select(m.drive.hover, maxf(m.floorY - m.position.y, F(0.0f)), F(0.0f));
  const Vec3T<F> fastest = max(abs(m.velocity), abs(m.drive.velocity));
  const Vec3T<F> move = fastest * F(dt) + Vec3T<F>{more, more, more};
  BoxT<F> box = grow(bodyBox(m, p).bounds(), move);
  box.hi.y += lift;
  return box;
}

// Returns true if a body within `reach` can meet a block. Tests the block's own axes, because the
// bounds of a tilted part are mostly empty.
template <class F>
OBBY_DEVICE MaskOf<F> meetsBlock(const BoxT<F>& reach, const geom::BlockT<F>& block) {
  const Vec3T<F> center = (reach.lo + reach.hi) * F(0.5f), half = (reach.hi - reach.lo) * F(0.5f);
  const Mat3T<F>& r = block.pose.rotation;
  const Vec3T<F> d = center - block.pose.position;
  return (absf(dot(d, r.x)) <= block.half.x + dot(abs(r.x), half)) &
         (absf(dot(d, r.y)) <= block.half.y + dot(abs(r.y), half)) &
         (absf(dot(d, r.z)) <= block.half.z + dot(abs(r.z), half));
}

// Moves the body out of a part that it penetrates by more than the skin.
template <class F>
OBBY_DEVICE MaskOf<F> pushOut(MotionT<F>& m, const Params& p, const geom::ContactT<F>& contact,
                              MaskOf<F> asked) {
  const MaskOf<F> inside = asked & (contact.depth > p.contactSkin);
  const Vec3T<F> out = contact.normal * (contact.depth - p.contactSkin);
  m.position = select(inside, m.position + out, m.position);
  const F into = dot(m.velocity, contact.normal);
  m.velocity = select(inside & (into < 0.0f), m.velocity - contact.normal * into, m.velocity);
  return inside;
}

OBBY_DEVICE geom::Contact contactWith(const level::Collider& collider, const Candidate& c,
                                      const geom::UprightBox& box) {
  if (c.flags & level::kUpright) {
    return geom::boxUprightBlock<float>({*c.pose, collider.shape.half}, box);
  }
  if (c.flags & level::kBlock) {
    return geom::boxTiltedBlock<float>({*c.pose, collider.shape.half}, box);
  }
  return geom::penetration(collider.kind, collider.shape, *c.pose, box);
}

// A set of candidates. Bit k stands for items[k].
using CandidateSet = uint64_t;
static_assert(kMaxCandidates <= 64, "one bit a candidate");

// Returns the rounds of depenetration. Corners between parts need the second.
OBBY_DEVICE int contactRounds(int parts) { return parts > 1 ? 2 : 1; }

// Depth that depenetration may leave. A body that is deeper does not fit between the parts.
constexpr float kTight = 0.02f;  // studs beyond the skin

OBBY_DEVICE bool isInside(const Motion& m, const level::LevelView& level, const Candidates& near,
                          CandidateSet solids) {
  const geom::UprightBox box = bodyBox(m, level.params);
  const Box bounds = box.bounds();
  for (CandidateSet left = solids; left != 0; left &= left - 1) {
    const Candidate& c = near.items[lowestBit(left)];
    if (!overlaps(bounds, c.bounds)) continue;
    const geom::Contact contact = contactWith(level.colliders[c.collider], c, box);
    if (contact.depth > level.params.contactSkin + kTight) return true;
  }
  return false;
}

// Moves the body out of the parts near it, in their order. Returns false if it does not fit.
OBBY_DEVICE bool collide(Motion& m, const level::LevelView& level, const Candidates& near,
                         CandidateSet solids) {
  const int rounds = contactRounds((solids & (solids - 1)) != 0 ? 2 : 1);
  for (int round = 0; round < rounds; ++round) {
    bool pushed = false;
    geom::UprightBox box = bodyBox(m, level.params);
    Box bounds = box.bounds();
    for (CandidateSet left = solids; left != 0; left &= left - 1) {
      const Candidate& c = near.items[lowestBit(left)];
      if (!overlaps(bounds, c.bounds)) continue;
      const geom::Contact contact = contactWith(level.colliders[c.collider], c, box);
      if (!pushOut(m, level.params, contact, true)) continue;
      pushed = true;
      box = bodyBox(m, level.params);
      bounds = box.bounds();
    }
    if (!pushed) return true;
  }
  return rounds == 1 || !isInside(m, level, near, solids);
}

// Ends a move that began at `from`. A body that does not fit between `solids` goes back sideways,
// so that it is pressed neither into a part nor through one.
OBBY_DEVICE void endMove(Motion& m, Vec3 from, const level::LevelView& level,
                         const Candidates& near, CandidateSet solids) {
  if (solids == 0 || collide(m, level, near, solids)) return;
  m.position.x = from.x;
  m.position.z = from.z;
}

// Moves the body for `dt` seconds among `solids`.
OBBY_DEVICE void moveAmong(Motion& m, const level::LevelView& level, const Candidates& near,
                           CandidateSet solids, float dt) {
  const Vec3 from = m.position;
  m.position += m.velocity * dt;
  endMove(m, from, level, near, solids);
}

// Returns the max distance of a move near a solid part. The limit is less than half the body's
// extent, so that even a thin part pushes the body back to the side that it came from.
template <class F>
OBBY_DEVICE F safeTravel(const MotionT<F>& m, const Params& p) {
  return 0.45f * minf(F(minf(p.bodyWidth, p.bodyDepth)), p.bodyTop - m.bottom);
}

// Returns the max distance of a substep, with the speed that gravity and drive can add in a tick.
template <class F>
OBBY_DEVICE F substepTravel(const MotionT<F>& m, const Params& p) {
  const Vec3T<F> v = max(abs(m.velocity), abs(m.drive.velocity));
  return (maxf(maxf(v.x, v.z), v.y) + m.drive.gravity * p.tickSeconds) * p.substepSeconds;
}

// Very fast players need several moves in a substep near solid parts.
constexpr int kMaxSplits = 32;
OBBY_DEVICE int contactSplits(const Motion& m, const Params& p) {
  const float travel = substepTravel(m, p), limit = safeTravel(m, p);
  int splits = 1;
  while (splits < kMaxSplits && travel > limit * float(splits)) ++splits;
  return splits;
}

// Returns the solid parts that the body can meet during this tick.
OBBY_DEVICE CandidateSet solidsInReach(const Motion& m, const level::LevelView& level,
                                       const Candidates& near) {
  if (!(near.anyFlags & level::kSolid)) return 0;
  const Box reach = bodyReach(m, level.params);
  CandidateSet solids = 0;
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if (!(c.flags & level::kSolid) || !overlaps(c.bounds, reach)) continue;
    const Vec3 extent = level.colliders[c.collider].shape.half;
    if (meetsBlock<float>(reach, {*c.pose, extent})) solids |= CandidateSet(1) << k;
  }
  return solids;
}

// Moves the player by one tick.
OBBY_DEVICE void moveBody(Motion& m, const level::LevelView& level, const Candidates& near) {
  const Params& p = level.params;
  const CandidateSet solids = solidsInReach(m, level, near);
  const bool oneStep = solids == 0 && isConstant(m, p);
  if (oneStep) {
    integrate(m, level, p.substepSeconds, p.substeps);
    return;
  }
  const int splits = solids ? contactSplits(m, p) : 1;
  const float part = p.substepSeconds / float(splits);
  for (int s = 0; s < p.substeps; ++s) {
    accelerate(m, level, p.substepSeconds);
    for (int i = 0; i < splits; ++i) moveAmong(m, level, near, solids, part);
  }
}

}  // namespace obby::sim
