// The physics of one tick: substeps of gravity, drive and hover spring, and the torso and head
// pushed out of parts.
#pragma once

#include "geom/penetration.h"
#include "math/bits.h"
#include "sim/humanoid.h"

namespace obby::sim {

// Torso and head as one upright box; the torso does not collide while jumping.
OBBY_DEVICE geom::UprightBox bodyBox(const World& w, const Params& p, SinCos yaw) {
  const float bottom = w.state == State::jumping ? p.headBottom : p.hipHeight;
  const float half = (p.bodyTop - bottom) * 0.5f;
  return {
      w.position + Vec3{0, bottom + half, 0}, {p.bodyWidth * 0.5f, half, p.bodyDepth * 0.5f}, yaw};
}

// Acceleration of a substep.
OBBY_DEVICE Vec3 acceleration(const World& w, const Params& p, const Floor& floor, const Drive& d,
                              float gap) {
  Vec3 a{(d.velocity.x - w.velocity.x) * p.moveGain, 0, (d.velocity.z - w.velocity.z) * p.moveGain};
  const float size2 = a.x * a.x + a.z * a.z;
  if (size2 > d.limit * d.limit) a = a * (d.limit / sqrtf32(size2));
  a += d.slide;
  a.y = -p.gravity;
  if (d.hover) {
    const float lift = -p.hoverStiffness * gap - p.hoverDamping * (w.velocity.y - floor.velocity.y);
    a.y = clampf(lift, -p.gravity, p.hoverLimit);  // the legs push, they do not pull
  }
  return a;
}

OBBY_DEVICE void limitSpeed(World& w, const level::LevelView& level) {
  const float most = level.params.maxFallSpeed, side = level.maxSideSpeed;
  w.velocity.y = clampf(w.velocity.y, -most, most);
  w.velocity.x = clampf(w.velocity.x, -side, side);
  w.velocity.z = clampf(w.velocity.z, -side, side);
}

OBBY_DEVICE geom::Contact contactWith(const level::Collider& collider, const Candidate& c,
                                      const geom::UprightBox& box) {
  if (c.flags & level::kUpright) return geom::boxUprightBlock(*c.pose, collider.shape.half, box);
  return geom::penetration(collider.kind, collider.shape, *c.pose, box);
}

// Pushes the body out of one part; true if it was inside by more than the skin.
OBBY_DEVICE bool pushOut(World& w, const level::LevelView& level, const Candidate& c,
                         const geom::UprightBox& box) {
  const geom::Contact contact = contactWith(level.colliders[c.collider], c, box);
  if (contact.depth <= level.params.contactSkin) return false;
  w.position += contact.normal * (contact.depth - level.params.contactSkin);
  const float into = dot(w.velocity, contact.normal);
  if (into < 0) w.velocity -= contact.normal * into;
  return true;
}

// A set of candidates: bit k stands for items[k].
using CandidateSet = uint64_t;
static_assert(kMaxCandidates <= 64, "one bit a candidate");

// Two rounds over the parts near the body, in their order: corners between parts need the second.
OBBY_DEVICE void collide(World& w, const level::LevelView& level, const Candidates& near,
                         CandidateSet solids, SinCos yaw) {
  const int rounds = (solids & (solids - 1)) != 0 ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    bool pushed = false;
    geom::UprightBox box = bodyBox(w, level.params, yaw);
    Box bounds = box.bounds();
    for (CandidateSet left = solids; left != 0; left &= left - 1) {
      const Candidate& c = near.items[lowestBit(left)];
      if (!overlaps(bounds, c.bounds) || !pushOut(w, level, c, box)) continue;
      pushed = true;
      box = bodyBox(w, level.params, yaw);
      bounds = box.bounds();
    }
    if (!pushed) return;
  }
}

// Solid parts that the body can meet during this tick.
OBBY_DEVICE CandidateSet solidsInReach(const World& w, const level::LevelView& level,
                                       const Candidates& near, SinCos yaw) {
  if (!(near.anyFlags & level::kSolid)) return 0;
  const Params& p = level.params;
  const float dt = p.tickSeconds;
  // Speed now, and what gravity and drive can add in a tick. The spring adds more upward only from
  // a floor above the feet, and then by no more than the legs are long.
  const float side = maxf(p.groundAccel, p.airAccel) * dt * dt + p.contactSkin;
  const Vec3 move =
      abs(w.velocity) * dt + Vec3{side, p.gravity * dt * dt + p.hipHeight * 0.5f, side};
  const Box box = grow(bodyBox(w, p, yaw).bounds(), move);
  CandidateSet solids = 0;
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if ((c.flags & level::kSolid) && overlaps(c.bounds, box)) solids |= CandidateSet(1) << k;
  }
  return solids;
}

// Differences below these are taken as none, so that a player who stands, walks or falls freely is
// at rest in the terms of the equations, and a tick is one step of constant acceleration instead of
// several.
constexpr float kSettledGap = 1e-3f;    // studs
constexpr float kSettledSpeed = 1e-2f;  // studs/s

OBBY_DEVICE void settle(World& w, Floor& floor, const Drive& d) {
  const float dx = d.velocity.x - w.velocity.x, dz = d.velocity.z - w.velocity.z;
  if (d.limit > 0 && dx * dx + dz * dz < kSettledSpeed * kSettledSpeed) {
    w.velocity.x = d.velocity.x;
    w.velocity.z = d.velocity.z;
  }
  if (!d.hover || absf(floor.gap) >= kSettledGap || floor.velocity.y != 0) return;
  if (absf(w.velocity.y) >= kSettledSpeed) return;
  w.position.y -= floor.gap;
  w.velocity.y = 0;
  floor.gap = 0;
}

// Will the acceleration stay what it is for the whole tick?
OBBY_DEVICE bool isConstant(const World& w, const Params& p, const Floor& floor, const Drive& d) {
  if (d.hover && (floor.gap != 0 || w.velocity.y != 0)) return false;
  const float dx = d.velocity.x - w.velocity.x, dz = d.velocity.z - w.velocity.z;
  const float left = dx * dx + dz * dz;
  // At the limit until the tick's end: the speed difference stays above limit / moveGain.
  const float needed = d.limit * (1.0f / p.moveGain + p.tickSeconds);
  return left == 0 || left > needed * needed;
}

OBBY_DEVICE void moveBody(World& w, const level::LevelView& level, const Candidates& near,
                          Floor floor, const Drive& d) {
  const Params& p = level.params;
  const SinCos yaw = sinCos(w.yaw);
  settle(w, floor, d);
  const CandidateSet solids = solidsInReach(w, level, near, yaw);
  const bool oneStep = solids == 0 && isConstant(w, p, floor, d);
  const int steps = oneStep ? 1 : p.substeps;
  const float dt = oneStep ? p.tickSeconds : p.substepSeconds;
  const float floorY = w.position.y - floor.gap;
  for (int s = 0; s < steps; ++s) {
    const Vec3 a = acceleration(w, p, floor, d, w.position.y - floorY);
    // Exact for constant acceleration: jumps are parabolas.
    w.position += w.velocity * dt + a * (0.5f * dt * dt);
    w.velocity += a * dt;
    limitSpeed(w, level);
    if (solids) collide(w, level, near, solids, yaw);
  }
}

}  // namespace obby::sim
